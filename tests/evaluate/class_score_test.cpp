#include "scanfuse/evaluate/class_score.hpp"

#include <gtest/gtest.h>

#include <functional>

namespace scanfuse::evaluate {
namespace {

constexpr double kStep_s = 0.1;

Time stamp_of(int scan) { return time_from_nanos(0) + duration_from_seconds(scan * kStep_s); }

Track track_at(std::int64_t id, const Eigen::Vector2d& place, ObjectClass kind) {
  Track track;
  track.id = id;
  track.object_class = kind;
  track.class_probability = 0.9;
  track.status = TrackStatus::kConfirmed;
  track.box = {place, 0, 0.6, 0.6};
  return track;
}

TruthFrame one_pedestrian(int scan) {
  TruthObject person;
  person.id = 1;
  person.object_class = ObjectClass::kPedestrian;
  person.position_m = {10, 0};
  person.heading_rad = 0;
  person.length_m = person.width_m = 0.6;
  person.visible_points = 9;
  return {stamp_of(scan), scan, "world", {person}};
}

/// Scans of one pedestrian and the tracks that `tracks_of(scan)` gives.
ClassScore score(int scans, const std::function<std::vector<Track>(int)>& tracks_of) {
  ClassScore score;
  for (int scan = 0; scan < scans; ++scan) {
    StepResult step;
    step.stamp = stamp_of(scan);
    step.frame = scan;
    step.tracks = tracks_of(scan);
    score.add(step, one_pedestrian(scan));
  }
  return score;
}

TEST(ClassScore, AYoungTrackCountsForRecallButNotAmongThoseFollowed) {
  const auto of = score(40, [](int scan) {
    std::vector<Track> tracks;
    if (scan >= 30) tracks.push_back(track_at(7, {10, 0}, ObjectClass::kPedestrian));
    return tracks;
  });
  EXPECT_NEAR(of.recall(ObjectClass::kPedestrian, 20).value(), 10.0 / 30, 1e-9);
  EXPECT_FALSE(of.recall_of_followed(ObjectClass::kPedestrian, 20).has_value());
}

TEST(ClassScore, AFollowedObjectOfTheWrongClassIsMissedInBothRecalls) {
  const auto of = score(40, [](int scan) {
    return std::vector{
        track_at(7, {10, 0}, scan < 25 ? ObjectClass::kPedestrian : ObjectClass::kCyclist)};
  });
  EXPECT_NEAR(of.recall(ObjectClass::kPedestrian, 20).value(), 0.5, 1e-9);
  EXPECT_NEAR(of.recall_of_followed(ObjectClass::kPedestrian, 20).value(), 0.5, 1e-9);
}

TEST(ClassScore, ASecondTrackOfAnObjectIsToldApartFromClutterElsewhere) {
  const auto of = score(20, [](int) {
    return std::vector{track_at(1, {10, 0}, ObjectClass::kPedestrian),
                       track_at(2, {10.5, 0}, ObjectClass::kPedestrian),
                       track_at(3, {30, 5}, ObjectClass::kPedestrian)};
  });
  EXPECT_NEAR(of.clutter_per_scan().value(), 2, 1e-9);
  EXPECT_NEAR(of.old_clutter_per_scan().value(), 2 * of.old_seconds_per_scan().value(), 1e-9);
  EXPECT_GT(of.old_seconds_per_scan().value(), 0.4);
}

}  // namespace
}  // namespace scanfuse::evaluate
