#include "scanfuse/preprocess/scan_match.hpp"

#include <gtest/gtest.h>

#include "preprocess/room_scene.hpp"

namespace scanfuse::preprocess {
namespace {

void expect_near(const Pose2& a, const Pose2& b, double place_m, double turn_rad) {
  EXPECT_NEAR(a.x_m, b.x_m, place_m);
  EXPECT_NEAR(a.y_m, b.y_m, place_m);
  EXPECT_NEAR(wrap_pi(a.heading_rad - b.heading_rad), 0, turn_rad);
}

TEST(ScanMatch, FindsAnyStepOfASensorInARoom) {
  RandomStream random(7);
  ScanMatcher matcher;
  for (int n = 0; n < 40; ++n) {
    const Pose2 first{random.uniform(-1, 1), random.uniform(-0.5, 1), random.uniform(-3, 3)};
    const Pose2 step{random.uniform(-0.2, 0.2), random.uniform(-0.2, 0.2),
                     random.uniform(-0.25, 0.25)};
    matcher.refer_to(look(room(), first, 0, random));
    const auto match = matcher(look(room(), first * step, 0.1, random), {{}, 0.3, 0.3});
    EXPECT_TRUE(match.converged);
    EXPECT_GT(match.fit.share, 0.8);
    expect_near(match.reference_from_scan, step, 0.015, 0.004);
  }
}

TEST(ScanMatch, WhatMovesOnItsOwnHasNoSay) {
  RandomStream random(8);
  auto before = room(), after = room();
  for (const double x : {1.0, 2.5}) {  // a cart and another, 0.3 m farther in the second scan
    for (const Wall& wall : box_walls({x, -2}, {x + 1, -1})) before.push_back(wall);
    for (const Wall& wall : box_walls({x, -1.7}, {x + 1, -0.7})) after.push_back(wall);
  }
  ScanMatcher matcher;
  matcher.refer_to(look(before, {}, 0, random));
  const Pose2 step{0.1, 0.02, 0.05};
  const auto match = matcher(look(after, step, 0.1, random), {{}, 0.3, 0.3});
  expect_near(match.reference_from_scan, step, 0.02, 0.005);
}

TEST(ScanMatch, AlongACorridorThePriorDecides) {
  RandomStream random(9);
  const std::vector<Wall> corridor{{{-100, -1}, {100, -1}}, {{-100, 1}, {100, 1}}};
  ScanMatcher matcher;
  matcher.refer_to(look(corridor, {}, 0, random));
  const auto scan = look(corridor, {0.2, 0.1, 0.03}, 0.1, random);
  const auto match = matcher(scan, {{0.15, 0, 0}, 0.05, 0.3});
  EXPECT_NEAR(match.reference_from_scan.x_m, 0.15, 0.05);
  EXPECT_NEAR(match.reference_from_scan.y_m, 0.1, 0.015);
  EXPECT_NEAR(match.reference_from_scan.heading_rad, 0.03, 0.004);
}

TEST(ScanMatch, NothingToSeeIsNoMatchAndChangesNothing) {
  RandomStream random(10);
  ScanMatcher matcher;
  const ScanPrior prior{{1, 2, 0.3}, 0.1, 0.1};
  expect_near(matcher(look(room(), {}, 0, random), prior).reference_from_scan, {1, 2, 0.3}, 0, 0);
  matcher.refer_to(look(room(), {}, 0, random));
  const auto match = matcher(VirtualScan{}, prior);
  EXPECT_FALSE(match.converged);
  EXPECT_EQ(match.fit.share, 0);
  expect_near(match.reference_from_scan, {1, 2, 0.3}, 0, 0);
}

}  // namespace
}  // namespace scanfuse::preprocess
