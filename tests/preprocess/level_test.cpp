#include "scanfuse/preprocess/level.hpp"

#include <gtest/gtest.h>

namespace scanfuse::preprocess {
namespace {

TEST(Level, TurnsReturnsIntoTheAxesOfTheEgoFrameAndKeepsTheOriginAtTheSensor) {
  Scan scan;
  scan.returns.push_back({1, 0, 0, 0, 0, -1, 0, 0});
  scan.beams = BeamPattern{0, 0.01, 100, 1, 0, 100};
  const Scan turned = level(scan, Pose3::from_planar({5, 6, kPi / 2}, 2));
  EXPECT_NEAR(turned.returns[0].x_m, 0, 1e-6);
  EXPECT_NEAR(turned.returns[0].y_m, 1, 1e-6);
  EXPECT_NEAR(turned.returns[0].z_m, 0, 1e-6);
  EXPECT_NEAR(turned.beams->first_azimuth_rad, kPi / 2, 1e-6);
}

TEST(Level, APitchedMountingHasNoBeamColumnsAnyMore) {
  Scan scan;
  scan.beams = BeamPattern{0, 0.01, 100, 1, 0, 100};
  scan.returns.push_back({10, 0, 0, 0, 0, 0, 0, 0});
  const Pose3 pitched{Eigen::Quaterniond(Eigen::AngleAxisd(0.1, Eigen::Vector3d::UnitY())),
                      {0, 0, 1}};
  const Scan turned = level(scan, pitched);
  EXPECT_FALSE(turned.beams.has_value());
  EXPECT_NEAR(turned.returns[0].z_m, -10 * std::sin(0.1), 1e-5);
}

// A wall post stands still while the vehicle drives 20 m/s along a bend: seen at any time in the
// sweep it comes out at the same place.
TEST(Deskew, WhatStandsStillComesOutWhereItWasAtTheStamp) {
  const Eigen::Vector3d post(12, 4, 0.5);
  const Pose3 ego_from_sensor = Pose3::from_planar({1.5, 0.3, 0.2}, 0.6);
  const double speed = 20, yaw_rate = 0.5;
  Scan scan;
  for (const double t : {0.0, 0.03, 0.08}) {
    const double heading = yaw_rate * t;
    const Pose3 start_from_now =
        Pose3::from_planar({speed / yaw_rate * std::sin(heading),
                            speed / yaw_rate * (1 - std::cos(heading)), heading});
    const Eigen::Vector3d p = (start_from_now * ego_from_sensor).inverse() * post;
    Return r;
    r.x_m = static_cast<float>(p.x());
    r.y_m = static_cast<float>(p.y());
    r.z_m = static_cast<float>(p.z());
    r.time_offset_s = static_cast<float>(t);
    scan.returns.push_back(r);
  }
  const Scan still = deskew(scan, {speed, 0}, yaw_rate, ego_from_sensor);
  const Eigen::Vector3d expected = ego_from_sensor.inverse() * post;
  for (const Return& r : still.returns) {
    EXPECT_NEAR(r.x_m, expected.x(), 1e-4);
    EXPECT_NEAR(r.y_m, expected.y(), 1e-4);
    EXPECT_NEAR(r.z_m, expected.z(), 1e-4);
  }
}

}  // namespace
}  // namespace scanfuse::preprocess
