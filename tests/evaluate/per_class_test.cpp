#include "scanfuse/evaluate/per_class.hpp"

#include <gtest/gtest.h>

#include "evaluate/sample.hpp"

namespace scanfuse::evaluate {
namespace {

using namespace sample;

Track walker(std::int64_t id, double x, double y) {
  Track t = track(id, x, y);
  t.object_class = ObjectClass::kPedestrian;
  return t;
}

TEST(EvaluateByClass, ATrackOnAnObjectOfAnotherClassIsFalseAndTheObjectMissed) {
  const std::vector steps{step(0, {track(1, 10, 0), walker(2, 20, 0)})};
  const std::vector truths{truth(0, {object(5, 10, 0), object(6, 20, 0)})};
  const auto classes = evaluate_by_class(steps, truths);
  ASSERT_EQ(classes.size(), 2u);
  const auto& cars = classes.at(ObjectClass::kVehicle);
  EXPECT_EQ(cars.precision, 1.0);
  EXPECT_EQ(cars.recall, 0.5);
  const auto& walkers = classes.at(ObjectClass::kPedestrian);
  EXPECT_EQ(walkers.precision, 0.0);
  EXPECT_FALSE(walkers.recall.has_value());
}

TEST(EvaluateByClass, OneClassAloneScoresAsTheWhole) {
  const std::vector steps{step(0, {track(1, 10, 0.4)}), step(1, {track(2, 11, 0)})};
  const std::vector truths{truth(0, {object(5, 10, 0)}), truth(1, {object(5, 11, 0)})};
  const auto cars = evaluate_by_class(steps, truths).at(ObjectClass::kVehicle).score;
  const auto all = evaluate(steps, truths);
  EXPECT_EQ(cars.clear.mota, all.clear.mota);
  EXPECT_EQ(cars.clear.identity_switches, 1);
  EXPECT_EQ(cars.hota.hota, all.hota.hota);
}

EvaluateOptions forty_degrees_to_30_m() {
  EvaluateOptions options;
  options.view_half_angle_rad = radians(40);
  options.view_range_m = 30;
  return options;
}

TEST(View, WhatLiesBesideItOrBeyondCountsOnNeitherSide) {
  auto steps = std::vector{step(0, {track(1, 10, 0), track(2, 0, 10), track(3, 40, 0)})};
  auto truths = std::vector{truth(0, {object(5, 10, 0), object(6, 5, 10), object(7, 40, 9)})};
  truths[0].coordinate_frame = steps[0].coordinate_frame = "ego";
  const auto score = evaluate(steps, truths, forty_degrees_to_30_m());
  EXPECT_EQ(score.clear.true_positives, 1);
  EXPECT_EQ(score.clear.false_positives, 0);
  EXPECT_EQ(score.clear.false_negatives, 0);
}

TEST(View, TurnsWithTheEgo) {
  auto steps = std::vector{step(0, {track(1, 100, 10)})};
  steps[0].world_from_ego = Pose3::from_planar({100, 0, kPi / 2});
  const auto truths = std::vector{truth(0, {object(5, 100, 10), object(6, 110, 0)})};
  const auto score = evaluate(steps, truths, forty_degrees_to_30_m());
  EXPECT_EQ(score.clear.true_positives, 1);
  EXPECT_EQ(score.clear.false_negatives, 0);
}

// The object is just outside, the track on it just inside: it is no false one.
TEST(View, TheTrackOfAnObjectOutsideIsLeftOutWithIt) {
  auto steps = std::vector{step(0, {track(1, 29.8, 0)})};
  auto truths = std::vector{truth(0, {object(5, 30.2, 0)})};
  truths[0].coordinate_frame = steps[0].coordinate_frame = "ego";
  EXPECT_EQ(evaluate(steps, truths, forty_degrees_to_30_m()).clear.false_positives, 0);
}

}  // namespace
}  // namespace scanfuse::evaluate
