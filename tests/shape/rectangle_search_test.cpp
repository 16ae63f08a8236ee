#include "scanfuse/shape/rectangle_search.hpp"

#include <gtest/gtest.h>

#include "scanfuse/geometry/pose.hpp"

namespace scanfuse::shape {
namespace {

class RectangleSearchOf : public testing::TestWithParam<Criterion> {};

// Not the area: the box along the hypotenuse of an L is as small as the one along its sides.
TEST_P(RectangleSearchOf, ACornerFindsItsHeading) {
  for (const double heading : {0.1, 0.5, 0.9, 1.3}) {
    const Pose2 pose{15, 2, heading};
    std::vector<Eigen::Vector2d> points;
    for (int i = 0; i <= 10; ++i) points.push_back(pose * Eigen::Vector2d(0, 1.8 - 0.18 * i));
    for (int i = 1; i <= 16; ++i) points.push_back(pose * Eigen::Vector2d(0.25 * i, 0));
    RectangleSearch search(GetParam(), 45);
    EXPECT_NEAR(std::remainder(search(points, 0.01) - heading, kPi / 2), 0, radians(4)) << heading;
  }
}

INSTANTIATE_TEST_SUITE_P(ClosenessAndVariance, RectangleSearchOf,
                         testing::Values(Criterion::kCloseness, Criterion::kVariance));

TEST(RectangleSearch, TheSmallestAreaFindsAFullRectangle) {
  const Pose2 pose{15, 2, 0.5};
  std::vector<Eigen::Vector2d> points;
  for (int i = 0; i <= 8; ++i) {
    for (const double side : {-0.9, 0.9}) points.push_back(pose * Eigen::Vector2d(0.5 * i, side));
  }
  RectangleSearch search(Criterion::kArea, 45);
  EXPECT_NEAR(std::remainder(search(points, 0.01) - 0.5, kPi / 2), 0, radians(4));
}

TEST(RectangleSearch, OnePointOrEqualPointsGiveSomeHeading) {
  RectangleSearch search;
  const std::vector<Eigen::Vector2d> equal(5, Eigen::Vector2d(3, 4));
  EXPECT_EQ(search(equal, 0.01), 0);
  EXPECT_EQ(search(std::span(equal).first(1), 0.01), 0);
}

}  // namespace
}  // namespace scanfuse::shape
