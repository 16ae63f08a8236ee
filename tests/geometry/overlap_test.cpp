#include "scanfuse/geometry/overlap.hpp"

#include <gtest/gtest.h>

#include "scanfuse/core/random.hpp"

namespace scanfuse {
namespace {

TEST(IntersectionOverUnion, OfABoxWithItselfIsOne) {
  const Box2 box{{3, -2}, 0.7, 4.4, 1.8};
  EXPECT_NEAR(intersection_over_union(box, box), 1, 1e-12);
}

TEST(IntersectionOverUnion, OfHalfShiftedBoxesIsAThird) {
  EXPECT_NEAR(intersection_over_union({{0, 0}, 0, 2, 1}, {{1, 0}, 0, 2, 1}), 1.0 / 3, 1e-12);
}

TEST(IntersectionOverUnion, OfACrossIsTheSquareInItsMiddle) {
  EXPECT_NEAR(intersection_over_union({{0, 0}, 0, 4, 1}, {{0, 0}, kPi / 2, 4, 1}), 1.0 / 7, 1e-12);
}

TEST(IntersectionOverUnion, OfASquareAndItsTurnByHalfARightAngleIsTheOctagon) {
  const double octagon = 2 * (std::sqrt(2.0) - 1);
  EXPECT_NEAR(intersection_over_union({{5, 5}, 0, 1, 1}, {{5, 5}, kPi / 4, 1, 1}),
              octagon / (2 - octagon), 1e-12);
}

TEST(IntersectionOverUnion, OfBoxesApartOrWithoutAreaIsZero) {
  EXPECT_EQ(intersection_over_union({{0, 0}, 0, 1, 1}, {{3, 0}, 0, 1, 1}), 0);
  EXPECT_EQ(intersection_over_union({{0, 0}, 0, 0, 1}, {{0, 0}, 0, 1, 1}), 0);
}

TEST(IntersectionOverUnion, DoesNotDependOnOrderPlaceOrHeading) {
  RandomStream random(5);
  for (int i = 0; i < 200; ++i) {
    const auto box = [&] {
      return Box2{{random.uniform(-1, 1), random.uniform(-1, 1)},
                  random.uniform(-4, 4),
                  random.uniform(0.5, 3),
                  random.uniform(0.5, 2)};
    };
    const Box2 a = box(), b = box();
    const double iou = intersection_over_union(a, b);
    EXPECT_NEAR(intersection_over_union(b, a), iou, 1e-9);
    const Pose2 move{7, -3, random.uniform(-3, 3)};
    const auto moved = [&](const Box2& x) {
      return Box2{move * x.centre_m, x.heading_rad + move.heading_rad, x.length_m, x.width_m};
    };
    EXPECT_NEAR(intersection_over_union(moved(a), moved(b)), iou, 1e-9);
    EXPECT_GE(iou, 0);
    EXPECT_LE(iou, 1 + 1e-12);
  }
}

}  // namespace
}  // namespace scanfuse
