#include "scanfuse/pipeline/pose_buffer.hpp"

#include <gtest/gtest.h>

namespace scanfuse::pipeline {
namespace {

Time clock_at(double seconds) { return time_from_seconds(100 + seconds); }
Pose3 planar(double x, double y, double heading) { return Pose3::from_planar({x, y, heading}); }

TEST(PoseBuffer, InterpolatesBetweenSamplesGivenInAnyOrder) {
  PoseBuffer buffer;
  buffer.add(clock_at(1), planar(10, 0, 0.2));
  buffer.add(clock_at(0), planar(0, 0, 0));
  const auto found = buffer.at(clock_at(0.25));
  ASSERT_TRUE(found);
  EXPECT_FALSE(found->extrapolated);
  EXPECT_NEAR(found->pose.translation_m.x(), 2.5, 1e-9);
  EXPECT_NEAR(found->pose.planar().heading_rad, 0.05, 1e-9);
}

TEST(PoseBuffer, CarriesTheLastMotionOnForAWhileAndThenHoldsIt) {
  PoseBuffer buffer;
  buffer.add(clock_at(0), planar(0, 0, 0));
  buffer.add(clock_at(1), planar(10, 0, 0));
  EXPECT_NEAR(buffer.at(clock_at(1.1))->pose.translation_m.x(), 11, 1e-9);
  EXPECT_NEAR(buffer.at(clock_at(50))->pose.translation_m.x(), 12.5, 1e-9);
  EXPECT_TRUE(buffer.at(clock_at(1.1))->extrapolated);
}

TEST(PoseBuffer, OfTwoSamplesWithOneStampTheLaterGivenWins) {
  PoseBuffer buffer;
  buffer.add(clock_at(0), planar(0, 0, 0));
  buffer.add(clock_at(0), planar(5, 0, 0));
  EXPECT_NEAR(buffer.at(clock_at(0))->pose.translation_m.x(), 5, 1e-12);
}

TEST(PoseBuffer, TwistIsInTheEgosOwnAxesOnACircle) {
  PoseBuffer buffer;
  const double radius = 20, rate = 0.4;
  for (int i = 0; i < 100; ++i) {
    const double turn = rate * 0.01 * i;
    buffer.add(clock_at(0.01 * i),
               planar(radius * std::sin(turn), radius * (1 - std::cos(turn)), turn));
  }
  const auto twist = buffer.twist_at(clock_at(0.5));
  EXPECT_NEAR(twist.speed_m_per_s, radius * rate, 0.01);
  EXPECT_NEAR(twist.lateral_m_per_s, 0, 0.01);
  EXPECT_NEAR(twist.yaw_rate_rad_per_s, rate, 1e-6);
}

TEST(PoseBuffer, ForgettingKeepsWhatInterpolationNeeds) {
  PoseBuffer buffer;
  for (int i = 0; i < 100; ++i) buffer.add(clock_at(i), planar(i, 0, 0));
  buffer.forget_before(clock_at(90.5));
  EXPECT_NEAR(buffer.at(clock_at(90.5))->pose.translation_m.x(), 90.5, 1e-9);
  EXPECT_FALSE(buffer.at(clock_at(90.5))->extrapolated);
}

}  // namespace
}  // namespace scanfuse::pipeline
