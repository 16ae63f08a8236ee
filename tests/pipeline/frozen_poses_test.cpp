#include "scanfuse/pipeline/frozen_poses.hpp"

#include <gtest/gtest.h>

#include "pipeline/list_reader.hpp"

namespace scanfuse::pipeline {
namespace {

Pose3 pose_at(double x) { return Pose3::from_planar({x, 0, 0}); }

TEST(FrozenPoses, APoseThatStopsDeadIsFrozenFromThereOn) {
  FrozenPoses poses;
  for (int k = 0; k < 50; ++k) poses.add(at(0.1 * k), pose_at(0.2 * std::min(k, 20)));
  EXPECT_FALSE(poses.frozen_since(at(1.9)));
  ASSERT_TRUE(poses.frozen_since(at(3)));
  EXPECT_EQ(*poses.frozen_since(at(3)), at(2));
}

TEST(FrozenPoses, AVehicleThatBrakesAndStandsIsNot) {
  FrozenPoses poses;
  double x = 0, speed = 10;
  for (int k = 0; k < 100; ++k) {
    poses.add(at(0.1 * k), pose_at(x));
    speed = std::max(0.0, speed - 0.5);
    x += 0.1 * speed;
  }
  EXPECT_FALSE(poses.frozen_since(at(9)));
}

TEST(FrozenPoses, APoseThatNeverMovedIsNot) {
  FrozenPoses poses;
  for (int k = 0; k < 50; ++k) poses.add(at(0.1 * k), pose_at(1));
  EXPECT_FALSE(poses.frozen_since(at(3)));
}

TEST(FrozenPoses, AShortHitchIsNotAndItEndsWhereItMovesOn) {
  FrozenPoses poses;
  for (int k = 0; k < 80; ++k) {
    const int moved = k < 20 ? k : k < 24 ? 20 : k < 40 ? k : k < 60 ? 40 : k;
    poses.add(at(0.1 * k), pose_at(0.3 * moved));
  }
  EXPECT_FALSE(poses.frozen_since(at(2.2)));
  EXPECT_TRUE(poses.frozen_since(at(5)));
  EXPECT_FALSE(poses.frozen_since(at(6.5)));
}

TEST(FrozenPoses, APoseToldOftenerThanItIsMadeIsFrozenOnlyWhenItStaysFarLonger) {
  FrozenPoses poses(Duration{0}, 3);
  // Made at 10 Hz, told at 50 Hz; stuck from 4 s on.
  for (int k = 0; k < 300; ++k) poses.add(at(0.02 * k), pose_at(0.2 * std::min(k / 5, 40)));
  EXPECT_FALSE(poses.frozen_since(at(3.93)));
  EXPECT_FALSE(poses.frozen_since(at(4)));
  EXPECT_TRUE(poses.frozen_since(at(5)));
}

}  // namespace
}  // namespace scanfuse::pipeline
