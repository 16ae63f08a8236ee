#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <vector>

#include "scanfuse/segment/score.hpp"
#include "scanfuse/segment/segmenter.hpp"
#include "segment/ray_scene.hpp"

namespace scanfuse::segment {
namespace {

using testing::planar_point;

/// What every way of segmentation promises.
template <class T>
class SegmentationLaws : public ::testing::Test {};

using Policies = ::testing::Types<Pag, PagLiteral, Surface, Breakpoint, Adaptive, DistanceThreshold,
                                  Euclidean, Segmenter>;
TYPED_TEST_SUITE(SegmentationLaws, Policies);

static_assert(Segmentation<Pag> && Segmentation<PagLiteral> && Segmentation<Breakpoint> &&
              Segmentation<Surface> && Segmentation<Adaptive> && Segmentation<DistanceThreshold> &&
              Segmentation<Euclidean> && Segmentation<Segmenter>);

void expect_well_formed(const Clusters& clusters, std::size_t points) {
  std::set<std::uint32_t> seen;
  std::uint32_t last_first = 0;
  for (std::size_t k = 0; k < clusters.size(); ++k) {
    const auto group = clusters[k];
    ASSERT_FALSE(group.empty());
    EXPECT_TRUE(std::ranges::is_sorted(group));
    EXPECT_TRUE(k == 0 || group.front() > last_first);
    last_first = group.front();
    for (const std::uint32_t i : group) {
      EXPECT_LT(i, points);
      EXPECT_TRUE(seen.insert(i).second) << "point " << i << " stands in two clusters";
    }
  }
  EXPECT_EQ(seen.size(), clusters.indices.size());
}

TYPED_TEST(SegmentationLaws, EachPointStandsInOneClusterAtMostAndClustersAreInOrder) {
  TypeParam segment{};
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const auto scene = testing::three_cars(seed);
    expect_well_formed(segment(scene.scan), scene.scan.points.size());
  }
}

TYPED_TEST(SegmentationLaws, TheSameScanGivesTheSameClustersWhateverCameBefore) {
  TypeParam fresh{}, used{};
  const auto scene = testing::three_cars(3);
  for (std::uint64_t seed = 5; seed < 9; ++seed) (void)used(testing::three_cars(seed).scan);
  const Clusters& a = fresh(scene.scan);
  const Clusters& b = used(scene.scan);
  EXPECT_EQ(a.indices, b.indices);
  EXPECT_EQ(a.ends, b.ends);
}

TYPED_TEST(SegmentationLaws, EmptyAndTinyScansAreFine) {
  TypeParam segment{};
  VirtualScan scan;
  scan.step_rad = radians(0.25);
  scan.full_circle = true;
  EXPECT_EQ(segment(scan).size(), 0U);
  for (int n = 1; n <= 4; ++n) {
    scan.points.push_back(planar_point(10, 0.004 * n));
    expect_well_formed(segment(scan), scan.points.size());
  }
}

TYPED_TEST(SegmentationLaws, PointsThatCoincideAreOneClusterAtMost) {
  TypeParam segment{};
  for (const double range : {0.0, 12.0}) {
    VirtualScan scan;
    scan.step_rad = radians(0.25);
    scan.full_circle = true;
    scan.points.assign(500, planar_point(range, 0.3));
    const Clusters& clusters = segment(scan);
    expect_well_formed(clusters, 500);
    EXPECT_LE(clusters.size(), 1U);
  }
}

TYPED_TEST(SegmentationLaws, ExtremeCoordinatesAreSurvived) {
  TypeParam segment{};
  auto scene = testing::three_cars(1);
  for (const double range : {1e9, 1e18, 1e30}) {
    scene.scan.points.back() = planar_point(range, scene.scan.points.back().bearing_rad);
    expect_well_formed(segment(scene.scan), scene.scan.points.size());
  }
}

template <class T>
class RobustSegmentation : public ::testing::Test {};
using Robust = ::testing::Types<Pag, Surface, Breakpoint, Adaptive, DistanceThreshold, Euclidean>;
TYPED_TEST_SUITE(RobustSegmentation, Robust);

TYPED_TEST(RobustSegmentation, CutsOutThreeCarsBetweenBarriers) {
  TypeParam segment{};
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    const auto scene = testing::three_cars(seed);
    int right = 0;
    for (const ObjectScore& score : score_clusters(segment(scene.scan), scene.objects)) {
      right += score.object >= 2 && score.right();
    }
    EXPECT_EQ(right, 3) << "seed " << seed;
  }
}

TYPED_TEST(RobustSegmentation, OneStrayReturnAt195MetresChangesNothingElse) {
  TypeParam segment{};
  auto scene = testing::three_cars(4);
  const Clusters before = segment(scene.scan);
  scene.scan.points.push_back(planar_point(195, scene.scan.points.back().bearing_rad + 0.2));
  const Clusters& after = segment(scene.scan);
  EXPECT_EQ(before.indices, after.indices);
  EXPECT_EQ(before.ends, after.ends);
}

TYPED_TEST(RobustSegmentation, AnObjectAcrossTheSeamIsOneCluster) {
  TypeParam segment{};
  const auto scene = testing::cast_scene({{{-12, 0.1}, 0, 4.5, 1.8}}, 2, 1440, radians(0.25), -kPi);
  const Clusters& clusters = segment(scene.scan);
  ASSERT_EQ(clusters.size(), 1U);
  EXPECT_GE(clusters[0].size(), scene.scan.points.size() * 8 / 10);
}

}  // namespace
}  // namespace scanfuse::segment
