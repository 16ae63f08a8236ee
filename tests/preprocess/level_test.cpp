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

}  // namespace
}  // namespace scanfuse::preprocess
