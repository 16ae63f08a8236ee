#include "scanfuse/preprocess/deskew.hpp"

#include <gtest/gtest.h>

#include "scanfuse/geometry/pose.hpp"

namespace scanfuse::preprocess {
namespace {

// A wall point that stands still, seen by a sensor that drives and turns, is one point again.
TEST(Deskew, TheStaticWorldFallsTogetherOnADriveWithATurn) {
  const EgoTwist twist{{12, 0.3}, 0.4};
  const Eigen::Vector2d sensor(3.5, 0.2);
  const Eigen::Vector2d wall_ego(40, 15);
  VirtualScan scan;
  for (int i = 0; i <= 10; ++i) {
    const double t = 0.01 * i;
    Pose2 start_from_now;  // integrated finely
    constexpr int kSteps = 2000;
    for (int k = 0; k < kSteps; ++k) {
      const double dt = t / kSteps;
      start_from_now =
          start_from_now * Pose2{twist.velocity_m_per_s.x() * dt, twist.velocity_m_per_s.y() * dt,
                                 twist.yaw_rate_rad_per_s * dt};
    }
    const Eigen::Vector2d seen = start_from_now.inverse() * wall_ego - sensor;
    PlanarPoint point;
    point.x_m = static_cast<float>(seen.x());
    point.y_m = static_cast<float>(seen.y());
    point.time_offset_s = static_cast<float>(t);
    scan.points.push_back(point);
  }
  deskew(scan, twist, sensor);
  for (const auto& point : scan.points) {
    EXPECT_NEAR(point.x_m + sensor.x(), wall_ego.x(), 2e-3);
    EXPECT_NEAR(point.y_m + sensor.y(), wall_ego.y(), 2e-3);
  }
}

TEST(Deskew, AStandingEgoChangesNothing) {
  VirtualScan scan;
  scan.points.resize(1);
  scan.points[0].x_m = 5;
  scan.points[0].time_offset_s = 0.05F;
  deskew(scan, {}, {1, 0});
  EXPECT_EQ(scan.points[0].x_m, 5);
}

}  // namespace
}  // namespace scanfuse::preprocess
