#include "scanfuse/segment/surface.hpp"

#include <gtest/gtest.h>

#include <utility>

#include "scanfuse/segment/adaptive.hpp"
#include "scanfuse/segment/breakpoint.hpp"
#include "scanfuse/segment/pag.hpp"
#include "scanfuse/segment/score.hpp"
#include "scanfuse/simulate/segmentation_scenes.hpp"
#include "segment/ray_scene.hpp"

namespace scanfuse::segment {
namespace {

using testing::cast_scene;

template <class Method>
double share_right(Method method) {
  int right = 0, all = 0;
  for (std::uint64_t seed = 1; seed <= 50; ++seed) {
    const auto scene = simulate::segmentation_scene(seed);
    for (const ObjectScore& score : score_clusters(method(scene.scan), scene.label)) {
      right += score.right_by_iou();
      ++all;
    }
  }
  return static_cast<double>(right) / all;
}

// As long as facing_rad <= pi - 2 lambda_facing_rad.
TEST(Adaptive, EqualsTheBreakpointDetectorWithTheSmallLambda) {
  for (const auto& [facing_lambda, facing] :
       {std::pair{radians(30), radians(60)}, std::pair{radians(15), radians(140)},
        std::pair{radians(60), radians(50)}}) {
    AdaptiveOptions options;
    options.lambda_facing_rad = facing_lambda;
    options.facing_rad = facing;
    Adaptive adaptive(options);
    Breakpoint plain;
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
      const auto scene = simulate::segmentation_scene(seed);
      const Clusters& a = adaptive(scene.scan);
      const Clusters& b = plain(scene.scan);
      EXPECT_EQ(a.indices, b.indices);
      EXPECT_EQ(a.ends, b.ends);
    }
  }
}

TEST(Surface, FollowsAFlankAtGrazingIncidenceFromItsCorner) {
  const auto scene = cast_scene({{{30, -3.2}, 0, 10, 2}}, 1);
  Surface surface;
  ASSERT_EQ(surface(scene.scan).size(), 1U);
  // The last gap may be wider than along_m.
  EXPECT_GE(surface(scene.scan)[0].size() + 1, scene.scan.points.size());
  Breakpoint plain;
  EXPECT_LT(plain(scene.scan)[0].size() + 1, scene.scan.points.size());
}

TEST(Surface, TellsTwoThatTouchApartByTheNotchBetweenThem) {
  const auto scene = cast_scene({{{12, -0.3}, 0, 0.5, 0.5}, {{12.5, 0.25}, 0, 0.5, 0.5}}, 2);
  Surface surface;
  EXPECT_EQ(surface(scene.scan).size(), 2U);
  SurfaceOptions uncut;
  uncut.notch_m = 0;
  EXPECT_EQ(Surface(uncut)(scene.scan).size(), 1U);
}

TEST(Surface, LeavesTheCornerOfACarWhole) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const auto scene = cast_scene({{{8, 3}, 0.3, 4.5, 1.8}}, seed);
    Surface surface;
    EXPECT_EQ(surface(scene.scan).size(), 1U) << seed;
  }
}

TEST(Surface, GetsMoreObjectsRightThanTheBreakpointDetector) {
  EXPECT_GT(share_right(Surface()), 0.95);
  EXPECT_GT(share_right(Surface()), share_right(Breakpoint()) + 0.02);
}

TEST(Pag, GetsMoreObjectsRightWhereItCutsNotches) {
  PagOptions notched;
  notched.notch_m = 0.02;
  EXPECT_GT(share_right(Pag(notched)), 0.95);
}

}  // namespace
}  // namespace scanfuse::segment
