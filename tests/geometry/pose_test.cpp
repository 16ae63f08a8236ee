#include "scanfuse/geometry/pose.hpp"

#include <gtest/gtest.h>

#include "scanfuse/core/random.hpp"
#include "scanfuse/geometry/box.hpp"

namespace scanfuse {
namespace {

Pose2 random_pose(RandomStream& random) {
  return {random.uniform(-50, 50), random.uniform(-50, 50), random.uniform(-kPi, kPi)};
}

TEST(Pose2, TimesItsInverseIsTheIdentity) {
  RandomStream random(1);
  for (int i = 0; i < 100; ++i) {
    const Pose2 pose = random_pose(random);
    const Pose2 unit = pose * pose.inverse();
    EXPECT_NEAR(unit.x_m, 0, 1e-12);
    EXPECT_NEAR(unit.y_m, 0, 1e-12);
    EXPECT_NEAR(wrap_pi(unit.heading_rad), 0, 1e-12);
  }
}

TEST(Pose3, AgreesWithPose2InThePlane) {
  RandomStream random(2);
  for (int i = 0; i < 100; ++i) {
    const Pose2 a = random_pose(random), b = random_pose(random);
    const Pose2 planar = a * b;
    const Pose2 spatial = (Pose3::from_planar(a) * Pose3::from_planar(b)).planar();
    EXPECT_NEAR(planar.x_m, spatial.x_m, 1e-9);
    EXPECT_NEAR(planar.y_m, spatial.y_m, 1e-9);
    EXPECT_NEAR(wrap_pi(planar.heading_rad - spatial.heading_rad), 0, 1e-12);
  }
}

TEST(WrapPi, StaysInTheHalfOpenInterval) {
  EXPECT_EQ(wrap_pi(kPi), -kPi);
  EXPECT_EQ(wrap_pi(-kPi), -kPi);
  EXPECT_NEAR(wrap_pi(7 * kPi / 2), -kPi / 2, 1e-12);
  EXPECT_EQ(wrap_half_pi(kPi / 2), -kPi / 2);
}

TEST(Box2, ContainsItsCornersOnlyWithMargin) {
  const Box2 box{{1, 2}, 0.3, 4, 2};
  for (const auto& corner : box.corners()) {
    EXPECT_TRUE(box.contains(corner, 1e-9));
    EXPECT_FALSE(box.contains(corner, -1e-3));
  }
}

}  // namespace
}  // namespace scanfuse
