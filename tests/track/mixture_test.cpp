#include <gtest/gtest.h>

#include "scanfuse/estimate/kalman.hpp"
#include "scanfuse/track/steps.hpp"
#include "track/scene.hpp"

namespace scanfuse::track {
namespace {

Detection car_to_15_cm(double x, double y) {
  const Eigen::Vector2d place(x, y);
  Detection detection = testing::box_detection(place, 0, {place, {0, 0}}, 0.15);
  detection.seen_from_m = {-10, -10};  // the same corner of every car is turned to the sensor
  return detection;
}

std::vector<Target> one_car(const TrackerOptions& options) {
  return {birth(car_to_15_cm(20, 0), 0, 1, time_from_seconds(0), 0, options)};
}

TEST(MixedStates, OneSureDetectionIsTheUpdate) {
  const TrackerOptions options;
  Workspace workspace;
  const auto targets = one_car(options);
  const std::vector detections{car_to_15_cm(20.3, 0.1)};
  const std::vector<associate::Candidate> pairs{{0, 0, 0}};
  const auto mixed = mixed_states(targets, detections, pairs, {{1}, {0}}, options, workspace);
  const Measurement m = measure(detections[0], targets[0], options);
  const auto sure = estimate::update_considering(targets[0].state, m.position, m.H, kLength);
  EXPECT_LT((mixed[0].mean - sure.mean).norm(), 1e-12);
  EXPECT_LT((mixed[0].covariance - sure.covariance).norm(), 1e-12);
}

TEST(MixedStates, BetweenTwoEquallyLikelyTheMeanStaysAndTheirSpreadIsAdded) {
  const TrackerOptions options;
  Workspace workspace;
  const auto targets = one_car(options);
  const std::vector detections{car_to_15_cm(20, 0.4), car_to_15_cm(20, -0.4)};
  const std::vector<associate::Candidate> pairs{{0, 0, 0}, {0, 1, 0}};
  const auto mixed =
      mixed_states(targets, detections, pairs, {{0.5, 0.5}, {0}}, options, workspace);
  const Measurement m = measure(detections[0], targets[0], options);
  const auto one = estimate::update_considering(targets[0].state, m.position, m.H, kLength);
  const double off = one.mean(kY) - targets[0].state.mean(kY);
  EXPECT_NEAR(mixed[0].mean(kY), targets[0].state.mean(kY), 1e-12);
  EXPECT_GT(off, 0.01);
  EXPECT_NEAR(mixed[0].covariance(kY, kY), one.covariance(kY, kY) + off * off, 1e-9);
}

TEST(MixedStates, MissedForSureChangesNothing) {
  const TrackerOptions options;
  Workspace workspace;
  const auto targets = one_car(options);
  const auto mixed = mixed_states(targets, {}, {}, {{}, {1}}, options, workspace);
  EXPECT_EQ(mixed[0].mean, targets[0].state.mean);
  EXPECT_EQ(mixed[0].covariance, targets[0].state.covariance);
}

TEST(Tracker, WithJpdaFollowsACarThroughClutterUnderOneIdentity) {
  TrackerOptions options;
  options.associator = associate::Method::kJpda;
  const simulate::Mover car{{-20, 0}, {8, 0}};
  testing::SceneOptions scene;
  scene.clutter_per_frame = 3;
  int changes = 0;
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    Tracker tracker(options);
    testing::IdentityCounter counter(2);
    for (const auto& frame : testing::play({car}, scene, seed)) {
      counter.add(frame.truth, tracker.step(frame.stamp, frame.detections));
    }
    EXPECT_GT(counter.coverage(), 0.9);
    changes += counter.changes();
  }
  EXPECT_EQ(changes, 0);
}

}  // namespace
}  // namespace scanfuse::track
