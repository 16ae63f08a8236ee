#include <benchmark/benchmark.h>

#include "scanfuse/classify/recognizer.hpp"
#include "scanfuse/core/random.hpp"
#include "scanfuse/geometry/angles.hpp"
#include "scanfuse/shape/outline.hpp"

namespace scanfuse {
namespace {

struct Street {
  VirtualScan scan;
  Clusters clusters;
};

/// One 110 degree scan: `clusters` objects side by side over 440 columns, cars, bushes and walls.
Street street(int clusters) {
  RandomStream random(1);
  Street street;
  street.scan.step_rad = radians(0.25);
  const int width = 440 / clusters;
  for (int column = 0; column < width * clusters; ++column) {
    const int kind = column / width % 4;
    const double bearing = (column - 220) * street.scan.step_rad;
    const double middle = (column / width * width + width / 2 - 220) * street.scan.step_rad;
    double range = (12 + 5 * (column / width % 5)) / std::cos(bearing - middle);
    range += random.normal(0, kind == 1 ? 0.3 : 0.03);
    if (kind == 2) range += 8 * std::abs(bearing - middle);
    PlanarPoint point;
    point.x_m = static_cast<float>(range * std::cos(bearing));
    point.y_m = static_cast<float>(range * std::sin(bearing));
    point.range_m = static_cast<float>(range);
    point.bearing_rad = static_cast<float>(bearing);
    point.column = column;
    street.clusters.indices.push_back(static_cast<std::uint32_t>(street.scan.points.size()));
    street.scan.points.push_back(point);
    if (column % width == width - 1) street.clusters.close();
  }
  return street;
}

void Shape_Outline(benchmark::State& state) {
  const Street scene = street(static_cast<int>(state.range(0)));
  shape::OutlineExtractor extract;
  for (auto _ : state) benchmark::DoNotOptimize(extract(scene.scan, scene.clusters).data());
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(scene.scan.points.size()));
}
BENCHMARK(Shape_Outline)->ArgName("clusters")->Arg(1)->Arg(5)->Arg(20)->Arg(80);

void Shape_Iepf(benchmark::State& state) {
  const Street scene = street(20);
  std::vector<std::vector<Eigen::Vector2d>> groups(scene.clusters.size());
  for (std::size_t k = 0; k < groups.size(); ++k) {
    for (const auto i : scene.clusters[k]) groups[k].push_back(scene.scan.position(i));
  }
  shape::Iepf iepf;
  for (auto _ : state) {
    for (const auto& group : groups) benchmark::DoNotOptimize(iepf(group, 0.03).data());
  }
}
BENCHMARK(Shape_Iepf);

void Classify_Recognize(benchmark::State& state) {
  const Street scene = street(20);
  shape::OutlineExtractor extract;
  const auto outlines = extract(scene.scan, scene.clusters);
  classify::Recognizer recognize;
  for (auto _ : state) benchmark::DoNotOptimize(recognize(outlines).data());
}
BENCHMARK(Classify_Recognize);

}  // namespace
}  // namespace scanfuse
