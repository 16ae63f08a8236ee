#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "scanfuse/core/random.hpp"
#include "scanfuse/preprocess/virtual_scan_builder.hpp"
#include "scanfuse/segment/segmenter.hpp"
#ifdef SCANFUSE_HAVE_PCL
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>
#include <pcl/search/kdtree.h>
#include <pcl/segmentation/extract_clusters.h>
#include <time.h>
#endif

namespace scanfuse {
namespace {

/// `layers` x `columns` returns over 110 deg on walls, cars and gaps between them.
Scan street(int columns, int layers) {
  Scan scan;
  RandomStream random(7);
  const double step = radians(110) / columns, first = -radians(55);
  scan.beams = BeamPattern{first, step, columns, layers, 0.1, 200};
  double range = 20;
  for (int c = 0; c < columns; ++c) {
    if (random.chance(15.0 / columns)) range = random.uniform(6, 70);
    const double bearing = first + c * step;
    for (int layer = 0; layer < layers; ++layer) {
      const double r = range + random.normal(0, 0.03);
      Return echo;
      echo.x_m = static_cast<float>(r * std::cos(bearing));
      echo.y_m = static_cast<float>(r * std::sin(bearing));
      echo.z_m = static_cast<float>(r * 0.014 * (layer - 0.5 * (layers - 1)));
      echo.beam = c;
      echo.layer = static_cast<std::int16_t>(layer);
      scan.returns.push_back(echo);
    }
  }
  return scan;
}

/// `points` points of such a street without flattening, as a virtual scan.
VirtualScan flat_points(std::int64_t points) {
  const Scan scan = street(static_cast<int>(points), 1);
  VirtualScan flat;
  flat.step_rad = scan.beams->step_rad;
  for (std::uint32_t i = 0; i < scan.returns.size(); ++i) {
    const Return& r = scan.returns[i];
    flat.points.push_back(
        {r.x_m, r.y_m, r.z_m, std::hypot(r.x_m, r.y_m), std::atan2(r.y_m, r.x_m), 0, r.beam, i, 1});
  }
  return flat;
}

void Preprocess_Layers(benchmark::State& state) {
  const Scan scan = street(440, 4);
  preprocess::VirtualScanBuilder build;
  const Pose3 mount = Pose3::from_planar({3.5, 0, 0}, 0.55);
  for (auto _ : state) benchmark::DoNotOptimize(build(scan, mount).points.data());
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(scan.returns.size()));
}
BENCHMARK(Preprocess_Layers)->Name("Preprocess_Layers/points:1760");

template <class Policy>
void cut(benchmark::State& state) {
  const VirtualScan scan = flat_points(state.range(0));
  Policy policy{};
  for (auto _ : state) benchmark::DoNotOptimize(policy(scan).indices.data());
  state.SetItemsProcessed(state.iterations() * state.range(0));
}
#define SCANFUSE_SEGMENT_BENCH(policy) \
  BENCHMARK(cut<segment::policy>)      \
      ->Name("Segment_" #policy)       \
      ->ArgName("points")              \
      ->Arg(440)                       \
      ->Arg(1760)                      \
      ->Arg(100'000)                   \
      ->Arg(1'000'000)
SCANFUSE_SEGMENT_BENCH(Pag);
SCANFUSE_SEGMENT_BENCH(PagLiteral);
SCANFUSE_SEGMENT_BENCH(Breakpoint);
SCANFUSE_SEGMENT_BENCH(DistanceThreshold);
SCANFUSE_SEGMENT_BENCH(Euclidean);

#ifdef SCANFUSE_HAVE_PCL
/// All returns of the street, or the virtual scan that flattening leaves of them.
VirtualScan street_points(bool flattened) {
  const Scan scan = street(440, 4);
  if (flattened)
    return preprocess::VirtualScanBuilder()(scan, Pose3::from_planar({3.5, 0, 0}, 0.55));
  VirtualScan all;
  all.step_rad = scan.beams->step_rad;
  for (std::uint32_t i = 0; i < scan.returns.size(); ++i) {
    const Return& r = scan.returns[i];
    all.points.push_back(
        {r.x_m, r.y_m, r.z_m, std::hypot(r.x_m, r.y_m), std::atan2(r.y_m, r.x_m), 0, r.beam, i, 1});
  }
  std::ranges::stable_sort(all.points, {}, &PlanarPoint::bearing_rad);
  return all;
}

using Cloud = pcl::PointCloud<pcl::PointXYZ>;

/// The search tree is built for every scan, as a user must. Clusters found.
std::size_t cluster_with_pcl(const Cloud::Ptr& cloud) {
  auto tree = std::make_shared<pcl::search::KdTree<pcl::PointXYZ>>();
  tree->setInputCloud(cloud);
  pcl::EuclideanClusterExtraction<pcl::PointXYZ> extraction;
  extraction.setClusterTolerance(0.5);
  extraction.setMinClusterSize(3);
  extraction.setMaxClusterSize(static_cast<int>(cloud->size()));
  extraction.setSearchMethod(tree);
  extraction.setInputCloud(cloud);
  std::vector<pcl::PointIndices> clusters;
  extraction.extract(clusters);
  return clusters.size();
}

double cpu_s() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + static_cast<double>(now.tv_nsec) * 1e-9;
}

/// The peer, and in turn with it Pag and our euclidean clustering, on the same points: the time
/// shown is PCL's, the counters say how many times faster ours are.
void peer_pcl(benchmark::State& state) {
  const VirtualScan scan = street_points(state.range(0) == 1);
  auto cloud = std::make_shared<Cloud>();
  for (const PlanarPoint& p : scan.points) cloud->push_back({p.x_m, p.y_m, 0});
  segment::Pag pag;
  segment::Euclidean euclidean;
  double pcl_s = 0, pag_s = 0, euclidean_s = 0;
  std::size_t found = 0, found_by_pag = 0;
  for (auto _ : state) {
    const double start = cpu_s();
    found = cluster_with_pcl(cloud);
    const double after_pcl = cpu_s();
    found_by_pag = pag(scan).size();
    const double after_pag = cpu_s();
    benchmark::DoNotOptimize(euclidean(scan).indices.data());
    euclidean_s += cpu_s() - after_pag;
    pag_s += after_pag - after_pcl;
    pcl_s += after_pcl - start;
    state.SetIterationTime(after_pcl - start);
  }
  state.counters["points"] = static_cast<double>(scan.points.size());
  state.counters["clusters"] = static_cast<double>(found);
  state.counters["pag_clusters"] = static_cast<double>(found_by_pag);
  state.counters["pag_times_faster"] = pcl_s / pag_s;
  state.counters["euclidean_times_faster"] = pcl_s / euclidean_s;
}
BENCHMARK(peer_pcl)
    ->Name("Peer_PclEuclidean")
    ->ArgName("flattened")
    ->Arg(1)
    ->Arg(0)
    ->UseManualTime()
    ->Unit(benchmark::kMicrosecond);
#endif

}  // namespace
}  // namespace scanfuse
