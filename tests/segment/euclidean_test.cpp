#include "scanfuse/segment/euclidean.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <vector>

#include "scanfuse/core/random.hpp"

namespace scanfuse::segment {
namespace {

void add_point(VirtualScan& scan, double x, double y) {
  PlanarPoint p;
  p.x_m = static_cast<float>(x);
  p.y_m = static_cast<float>(y);
  scan.points.push_back(p);
}

/// Labels by looking at all pairs.
std::vector<std::uint32_t> by_all_pairs(const VirtualScan& scan, double radius_m) {
  DisjointSets sets;
  sets.reset(scan.points.size());
  for (std::uint32_t i = 0; i < scan.points.size(); ++i) {
    for (std::uint32_t j = 0; j < i; ++j) {
      const double dx = static_cast<double>(scan.points[i].x_m) - scan.points[j].x_m;
      const double dy = static_cast<double>(scan.points[i].y_m) - scan.points[j].y_m;
      if (dx * dx + dy * dy <= radius_m * radius_m) sets.join(i, j);
    }
  }
  std::vector<std::uint32_t> labels(scan.points.size());
  for (std::uint32_t i = 0; i < labels.size(); ++i) labels[i] = sets.find(i);
  return labels;
}

TEST(Euclidean, CrowdsAreCutAsByLookingAtAllPairs) {
  EuclideanOptions options;
  options.min_points = 1;
  for (std::uint64_t seed = 1; seed <= 30; ++seed) {
    RandomStream random(seed);
    VirtualScan scan;
    for (int crowd = 0; crowd < 12; ++crowd) {
      const double x = random.uniform(-4, 4), y = random.uniform(-4, 4);
      for (int i = 0; i < 60; ++i)
        add_point(scan, x + random.normal(0, 0.1), y + random.normal(0, 0.1));
    }
    const auto labels = by_all_pairs(scan, options.radius_m);
    Euclidean segment(options);
    const Clusters& clusters = segment(scan);
    std::size_t components = 0;
    for (std::uint32_t i = 0; i < labels.size(); ++i) components += labels[i] == i ? 1 : 0;
    ASSERT_EQ(clusters.size(), components) << seed;
    for (std::size_t k = 0; k < clusters.size(); ++k) {
      for (const std::uint32_t i : clusters[k]) EXPECT_EQ(labels[i], labels[clusters[k].front()]);
    }
  }
}

// Two walls of 100 000 points each, a hair out of reach of each other: ten thousand million pairs.
TEST(Euclidean, CrowdsJustOutOfReachDoNotCostAllPairs) {
  VirtualScan scan;
  constexpr int kPoints = 100'000;
  for (int i = 0; i < kPoints; ++i) add_point(scan, 0.40, 0.5 * i / kPoints);
  for (int i = 0; i < kPoints; ++i) add_point(scan, 1.2005, 0.5 * i / kPoints);
  const auto start = std::chrono::steady_clock::now();
  Euclidean segment;
  EXPECT_EQ(segment(scan).size(), 2u);
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(5));
}

}  // namespace
}  // namespace scanfuse::segment
