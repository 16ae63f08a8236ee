#include "scanfuse/simulate/segmentation_scenes.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace scanfuse::simulate {
namespace {

TEST(SegmentationScene, LabelsEveryPointAndCountsThem) {
  int vehicles = 0;
  for (std::uint64_t seed = 1; seed <= 300; ++seed) {
    const auto scene = segmentation_scene(seed);
    ASSERT_EQ(scene.label.size(), scene.scan.points.size());
    for (std::size_t i = 0; i < scene.objects.size(); ++i) {
      const auto& object = scene.objects[i];
      EXPECT_EQ(std::count(scene.label.begin(), scene.label.end(), static_cast<std::int32_t>(i)),
                object.points);
      vehicles += object.object_class == ObjectClass::kVehicle && object.points >= 3;
    }
  }
  EXPECT_GT(vehicles, 900);
}

TEST(SegmentationScene, PointsLieOnTheirObjectsAndAreSortedByBearing) {
  const auto scene = segmentation_scene(7);
  for (std::size_t i = 0; i < scene.label.size(); ++i) {
    const auto p = scene.scan.position(static_cast<std::uint32_t>(i));
    if (i > 0) {
      EXPECT_GT(scene.scan.points[i].bearing_rad, scene.scan.points[i - 1].bearing_rad);
      EXPECT_GT(scene.scan.points[i].column, scene.scan.points[i - 1].column);
    }
    if (scene.label[i] < 0) {
      EXPECT_NEAR(std::abs(p.y()), 8, 0.2);
    } else {
      EXPECT_TRUE(scene.objects[static_cast<std::size_t>(scene.label[i])].box.contains(p, 0.2));
    }
  }
}

TEST(SegmentationScene, AStrayReturnIsAddedWhereNothingWasSeen) {
  SegmentationSceneOptions options;
  const auto plain = segmentation_scene(3, options);
  options.stray_return = true;
  const auto stray = segmentation_scene(3, options);
  EXPECT_EQ(stray.scan.points.size(), plain.scan.points.size() + 1);
  const auto far = std::max_element(
      stray.scan.points.begin(), stray.scan.points.end(),
      [](const PlanarPoint& a, const PlanarPoint& b) { return a.range_m < b.range_m; });
  EXPECT_FLOAT_EQ(far->range_m, 195);
}

TEST(RangeLadder, TheCarStandsAtItsRangeAndIsSeenLessFartherOut) {
  int near = 0, far = 0;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    near += range_ladder_scene(10, seed).objects[0].points;
    far += range_ladder_scene(60, seed).objects[0].points;
  }
  EXPECT_GT(far, 20 * 4);
  EXPECT_GT(near, 5 * far);
}

}  // namespace
}  // namespace scanfuse::simulate
