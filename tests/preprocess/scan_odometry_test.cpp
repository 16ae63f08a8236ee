#include "scanfuse/preprocess/scan_odometry.hpp"

#include <gtest/gtest.h>

#include "preprocess/room_scene.hpp"

namespace scanfuse::preprocess {
namespace {

void add_box(std::vector<Wall>& walls, double x, double y, double length, double width) {
  for (const Wall& wall : box_walls({x, y}, {x + length, y + width})) walls.push_back(wall);
}

TEST(ScanOdometry, ASensorThatStandsStaysExactlyWhereItIsWhilePeoplePass) {
  RandomStream random(1);
  ScanOdometry odometry;
  for (int k = 0; k < 200; ++k) {
    auto walls = room();
    for (int person = 0; person < 4; ++person) {
      add_box(walls, -3 + 0.05 * k + person, 1 - 0.7 * person, 0.4, 0.4);
    }
    const Pose2 pose = odometry(look(walls, {}, 0.1 * k, random));
    ASSERT_EQ(pose.x_m, 0);
    ASSERT_EQ(pose.heading_rad, 0);
  }
  EXPECT_FALSE(odometry.moves());
}

TEST(ScanOdometry, FollowsARobotRoundARoom) {
  RandomStream random(2);
  ScanOdometry odometry;
  Pose2 truth;
  double way_m = 0;
  for (int k = 0; k < 300; ++k) {
    const Pose2 pose = odometry(look(room(), truth, 0.1 * k, random));
    if (odometry.moves()) {
      const Pose2 off = truth.inverse() * pose;
      ASSERT_LT(std::hypot(off.x_m, off.y_m), 0.03 + 0.02 * way_m) << k;
      ASSERT_LT(std::abs(off.heading_rad), 0.04) << k;
    }
    if (k == 150) {
      EXPECT_NEAR(odometry.twist().x(), 0.5, 0.2);
      EXPECT_NEAR(odometry.twist().z(), 0.5, 0.1);
    }
    truth = truth * Pose2{0.05, 0, 0.05};  // 0.5 m/s on a circle of 1 m
    way_m += 0.05;
  }
  EXPECT_TRUE(odometry.moves());
  EXPECT_TRUE(odometry.is_found());
}

// Without a rest of the world to tell, vehicles that all drive alike are vehicles.
TEST(ScanOdometry, VehiclesOnAnEmptyPlainAreNoMotionOfTheSensor) {
  RandomStream random(3);
  ScanOdometry odometry;
  for (int k = 0; k < 40; ++k) {
    std::vector<Wall> walls;
    for (int lane = 0; lane < 3; ++lane) add_box(walls, 3 + 0.1 * k, -4 + 3 * lane, 4.5, 1.8);
    const Pose2 pose = odometry(look(walls, {}, 0.1 * k, random));
    ASSERT_EQ(pose.x_m, 0);
  }
  EXPECT_FALSE(odometry.moves());
}

// Its first scans are 1.2 m apart: one is not the neighbour of the other.
TEST(ScanOdometry, FollowsACarThatIsMetInTheMiddleOfItsDrive) {
  RandomStream random(6);
  std::vector<Wall> street;
  for (double x = -30; x < 80; x += random.uniform(3, 8)) {
    add_box(street, x, 4 + random.uniform(0, 2), 2, 2);
    add_box(street, x + 1, -8 + random.uniform(0, 2), 2, 2);
  }
  ScanOdometry odometry;
  Pose2 pose;
  for (int k = 0; k < 30; ++k) {
    pose = odometry(look(street, {1.2 * k, 0, 0}, 0.1 * k, random));
  }
  EXPECT_TRUE(odometry.moves());
  EXPECT_NEAR(pose.x_m, 1.2 * 29, 0.5);
  EXPECT_NEAR(pose.y_m, 0, 0.3);
  EXPECT_NEAR(odometry.twist().x(), 12, 0.5);
}

TEST(ScanOdometry, StandsAgainWhenTheRobotDoes) {
  RandomStream random(4);
  ScanOdometry odometry;
  Pose2 truth;
  Pose2 last;
  for (int k = 0; k < 120; ++k) {
    if (k < 60) truth = truth * Pose2{0.06, 0, 0.02};
    const Pose2 pose = odometry(look(room(), truth, 0.1 * k, random));
    if (k > 70) {
      EXPECT_LT(std::hypot(pose.x_m - last.x_m, pose.y_m - last.y_m), 0.01);
    }
    last = pose;
  }
  EXPECT_LT(odometry.twist().norm(), 0.1);
}

TEST(ScanOdometry, CarriesOnThroughScansWithoutReturnsAndThenRests) {
  RandomStream random(5);
  ScanOdometry odometry;
  odometry.start_moving({1, 0, 0});
  (void)odometry(look(room(), {}, 0, random));
  EXPECT_TRUE(odometry.is_found());
  VirtualScan empty;
  for (int k = 1; k < 40; ++k) {
    empty.stamp = time_from_seconds(0.1 * k);
    EXPECT_LT(odometry(empty).x_m, 1);
  }
  EXPECT_FALSE(odometry.is_found());
  EXPECT_TRUE(odometry.twist().isZero());
}

}  // namespace
}  // namespace scanfuse::preprocess
