#include "scanfuse/shape/occlusion.hpp"

#include <gtest/gtest.h>

#include "scanfuse/geometry/angles.hpp"

namespace scanfuse::shape {
namespace {

/// Columns 0, 1, ... with these ranges; a range of 0 leaves the column empty.
VirtualScan scan_of(const std::vector<float>& ranges) {
  VirtualScan scan;
  scan.step_rad = 0.01;
  for (std::size_t column = 0; column < ranges.size(); ++column) {
    if (ranges[column] == 0) continue;
    PlanarPoint point;
    point.column = static_cast<std::int32_t>(column);
    point.bearing_rad = 0.01f * static_cast<float>(column);
    point.range_m = ranges[column];
    scan.points.push_back(point);
  }
  return scan;
}

TEST(Occlusion, ANearerNeighbourHidesTheEndBesideIt) {
  const CutEnds cut = find_cut_ends(scan_of({30, 30, 20, 20, 20, 5, 5}), 2, 4, {});
  EXPECT_TRUE(cut.left);
  EXPECT_FALSE(cut.right);
}

TEST(Occlusion, AnEndBesideNothingIsFree) {
  const CutEnds cut = find_cut_ends(scan_of({0, 0, 0, 0, 20, 20, 0, 0, 0, 0}), 0, 1, {});
  EXPECT_FALSE(cut.left);
  EXPECT_FALSE(cut.right);
}

TEST(Occlusion, ANearerNeighbourManyColumnsAwayHidesNothing) {
  EXPECT_FALSE(find_cut_ends(scan_of({20, 20, 0, 0, 0, 0, 0, 5}), 0, 1, {}).left);
}

TEST(Occlusion, AnEndWhereTheSurfaceGoesOnInAnotherClusterIsNotFree) {
  EXPECT_TRUE(find_cut_ends(scan_of({20, 20, 20.1f, 20.1f}), 0, 1, {}).left);
}

TEST(Occlusion, TheEdgeOfTheViewCutsAnObject) {
  VirtualScan scan = scan_of({0, 0, 0, 20, 20});
  EXPECT_FALSE(find_cut_ends(scan, 0, 1, {}).left);
  scan.view_from_rad = 0;
  scan.view_to_rad = 0.04;
  EXPECT_TRUE(find_cut_ends(scan, 0, 1, {}).left);
  EXPECT_FALSE(find_cut_ends(scan, 0, 1, {}).right);
}

TEST(Occlusion, OnAFullCircleTheFirstPointIsBesideTheLast) {
  VirtualScan scan = scan_of({5, 30, 30, 30, 20, 20});
  EXPECT_FALSE(find_cut_ends(scan, 4, 5, {}).left);
  scan.full_circle = true;
  EXPECT_TRUE(find_cut_ends(scan, 4, 5, {}).left);
}

}  // namespace
}  // namespace scanfuse::shape
