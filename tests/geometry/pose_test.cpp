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

TEST(TurnZTo, TurnsZThereByTheShortestWay) {
  RandomStream random(3);
  for (int i = 0; i < 100; ++i) {
    const double near = i % 2 == 0 ? 1 : 1e-6;  // half of them all but straight back
    const Eigen::Vector3d towards(near * random.normal(), near * random.normal(),
                                  near < 1 ? -3 : random.normal());
    const Eigen::Quaterniond turn = turn_z_to(towards);
    const Eigen::Vector3d n = towards.normalized();
    EXPECT_NEAR(turn.norm(), 1, 1e-12);
    EXPECT_NEAR((turn * Eigen::Vector3d::UnitZ() - n).norm(), 0, 1e-9);
    EXPECT_NEAR(turn.z(), 0, 1e-12);  // about an axis in the xy plane: the shortest
  }
  const Eigen::Vector3d back = turn_z_to({0, 0, -2}) * Eigen::Vector3d::UnitZ();
  EXPECT_NEAR((back + Eigen::Vector3d::UnitZ()).norm(), 0, 1e-12);
}

TEST(WrapPi, IsTheLibrarysRemainderEverywhere) {
  RandomStream random(4);
  for (int i = 0; i < 10000; ++i) {
    const double angle = random.uniform(-20, 20);
    const double whole = std::remainder(angle, 2 * kPi), half = std::remainder(angle, kPi);
    EXPECT_EQ(wrap_pi(angle), whole >= kPi ? whole - 2 * kPi : whole);
    EXPECT_EQ(wrap_half_pi(angle), half >= kPi / 2 ? half - kPi : half);
  }
}

TEST(Box2, HoldsWhatItsOwnFrameSays) {
  RandomStream random(5);
  for (int i = 0; i < 10000; ++i) {
    const Box2 box{{random.uniform(-50, 50), random.uniform(-50, 50)},
                   random.uniform(-4, 4),
                   random.uniform(0, 5),
                   random.uniform(0, 2)};
    const double margin = random.uniform(0, 1);
    const Eigen::Vector2d point =
        box.centre_m + 4 * Eigen::Vector2d(random.normal(), random.normal());
    const Eigen::Vector2d local = box.pose().inverse() * point;
    const Eigen::Vector2d beyond(std::abs(local.x()) - box.length_m / 2 - margin,
                                 std::abs(local.y()) - box.width_m / 2 - margin);
    if (beyond.cwiseAbs().minCoeff() < 1e-9) continue;  // on the border
    EXPECT_EQ(box.contains(point, margin), beyond.maxCoeff() < 0);
    EXPECT_EQ(InBox(box, margin)(point), beyond.maxCoeff() < 0);
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
