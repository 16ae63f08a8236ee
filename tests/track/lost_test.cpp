#include "scanfuse/track/lost.hpp"

#include <gtest/gtest.h>

#include "scanfuse/track/tracker.hpp"
#include "track/scene.hpp"

namespace scanfuse::track {
namespace {

constexpr double kScanStep_s = 0.08;

Detection passing_car(double x, double y) {
  return testing::box_detection({x, y}, 0, testing::Mover{{x, y}, {8, 0}}, 0.05);
}

/// A car at 8 m/s, seen for 2 s, then `unseen` scans long not, then again, `aside_m` beside its
/// way.
struct Reappearance {
  int unseen = 15;
  double aside_m = 0;
  TrackerOptions options{};
};

/// Its tracks in the last scan before it went, in the last unseen one, in each after it came back.
struct SeenAgain {
  std::vector<Track> before, gone;
  std::vector<std::vector<Track>> after;
};

SeenAgain play_reappearance(const Reappearance& scene) {
  constexpr int kSeen = 25, kAgain = 6;
  Tracker tracker(scene.options);
  SeenAgain seen;
  for (int k = 0; k < kSeen + scene.unseen + kAgain; ++k) {
    const double x = 8 * kScanStep_s * k;
    std::vector<Detection> detections;
    if (k < kSeen) detections.push_back(passing_car(x, 0));
    if (k >= kSeen + scene.unseen) detections.push_back(passing_car(x, scene.aside_m));
    const auto tracks = tracker.step(time_from_seconds(kScanStep_s * k), detections);
    if (k == kSeen - 1) seen.before = tracks;
    if (k == kSeen + scene.unseen - 1) seen.gone = tracks;
    if (k >= kSeen + scene.unseen) seen.after.push_back(tracks);
  }
  return seen;
}

TEST(LostTargets, WhatComesBackWhereItShouldBeIsTheSameAgain) {
  const SeenAgain seen = play_reappearance({});
  ASSERT_EQ(seen.before.size(), 1U);
  EXPECT_TRUE(seen.gone.empty()) << "in the open it is not reported for 1.2 s";
  ASSERT_EQ(seen.after.front().size(), 1U);
  EXPECT_EQ(seen.after.front()[0].id, seen.before[0].id);
  EXPECT_EQ(seen.after.front()[0].status, TrackStatus::kTentative);
  EXPECT_EQ(seen.after[2][0].status, TrackStatus::kConfirmed) << "at the third hit";
  EXPECT_NEAR(seen.after.front()[0].state.mean(1), 8, 0.5) << "its velocity is remembered";
}

TEST(LostTargets, WhatAppearsElsewhereIsAnother) {
  Reappearance scene;
  scene.aside_m = 6;
  const SeenAgain seen = play_reappearance(scene);
  ASSERT_EQ(seen.after.back().size(), 1U);
  EXPECT_NE(seen.after.back()[0].id, seen.before[0].id);
}

TEST(LostTargets, AreForgottenAfterTheTimeOfTheOption) {
  Reappearance scene;
  scene.options.lost_s = 1.0;
  EXPECT_NE(play_reappearance(scene).after.back()[0].id, 1);
  scene.options.lost_s = 2.0;
  EXPECT_EQ(play_reappearance(scene).after.back()[0].id, 1);
}

TEST(LostTargets, AnotherClassIsAnotherObject) {
  Tracker tracker;
  const testing::Mover person{{10, 0}, {0, 0}, ObjectClass::kPedestrian, 0.6, 0.5};
  for (int k = 0; k < 20; ++k) {
    tracker.step(time_from_seconds(kScanStep_s * k), std::vector{passing_car(10, 0)});
  }
  for (int k = 20; k < 40; ++k) tracker.step(time_from_seconds(kScanStep_s * k), {});
  const auto& tracks = tracker.step(time_from_seconds(kScanStep_s * 40),
                                    std::vector{testing::box_detection({10, 0}, 0, person, 0.05)});
  ASSERT_EQ(tracks.size(), 1U);
  EXPECT_EQ(tracks[0].id, 2);
}

TEST(LostTargets, WhatWasNeverConfirmedIsNotRemembered) {
  LostTargets lost;
  TrackerOptions options;
  const Detection car = passing_car(10, 0);
  Target target = birth(car, 0, 1, time_from_seconds(0), kScanStep_s, options);
  lost.keep(target);
  EXPECT_FALSE(lost.find(car, options).has_value());
  target.is_known = true;
  lost.keep(target);
  const auto found = lost.find(car, options);
  ASSERT_TRUE(found.has_value());
  EXPECT_EQ(found->id, 1);
  EXPECT_FALSE(lost.find(car, options).has_value()) << "it was taken out";
}

TEST(LostTargets, AreDroppedWhenTheClockJumps) {
  Tracker tracker;
  for (int k = 0; k < 20; ++k)
    tracker.step(time_from_seconds(kScanStep_s * k), std::vector{passing_car(10, 0)});
  for (int k = 20; k < 30; ++k) tracker.step(time_from_seconds(kScanStep_s * k), {});
  const auto& tracks = tracker.step(time_from_seconds(100), std::vector{passing_car(10, 0)});
  ASSERT_EQ(tracks.size(), 1U);
  EXPECT_EQ(tracks[0].id, 2);
}

}  // namespace
}  // namespace scanfuse::track
