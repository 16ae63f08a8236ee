#include "scanfuse/track/tracker.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <numeric>

#include "scanfuse/estimate/kalman.hpp"
#include "track/scene.hpp"

namespace scanfuse::track {
namespace {

using testing::box_detection;
using testing::Mover;
using testing::SceneOptions;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

Time at(double seconds) { return time_from_seconds(1000 + seconds); }

Detection car_at(double x, double y, double heading = 0) {
  return box_detection({x, y}, heading, Mover{{0, 0}, {0, 0}}, 0.1);
}

std::vector<Track> feed(Tracker& tracker, double seconds, std::vector<Detection> detections) {
  return tracker.step(at(seconds), detections);
}

TEST(Tracker, ConfirmsAtTheThirdHitAndCountsIdsFromOne) {
  Tracker tracker;
  EXPECT_EQ(feed(tracker, 0, {car_at(0, 0)})[0].status, TrackStatus::kTentative);
  EXPECT_EQ(feed(tracker, 0.08, {car_at(0, 0)})[0].status, TrackStatus::kTentative);
  const auto tracks = feed(tracker, 0.16, {car_at(0, 0)});
  ASSERT_EQ(tracks.size(), 1U);
  EXPECT_EQ(tracks[0].status, TrackStatus::kConfirmed);
  EXPECT_EQ(tracks[0].id, 1);
  EXPECT_EQ(tracks[0].age_frames, 3);
  EXPECT_EQ(tracks[0].detection, 0);
  EXPECT_EQ(tracks[0].object_class, ObjectClass::kVehicle);
}

TEST(Tracker, CoastsWithGrowingCovarianceThenForgets) {
  Tracker tracker;
  for (int k = 0; k < 70; ++k) feed(tracker, 0.08 * k, {car_at(0.8 * k, 0)});
  double variance = 0;
  int coasted = 0;
  for (int k = 70; k < 100; ++k) {
    const auto tracks = feed(tracker, 0.08 * k, {});
    if (tracks.empty()) break;
    ++coasted;
    EXPECT_EQ(tracks[0].status, TrackStatus::kCoasting);
    EXPECT_EQ(tracks[0].missed_frames, coasted);
    EXPECT_EQ(tracks[0].detection, -1);
    EXPECT_GT(tracks[0].state.covariance(0, 0), variance);
    EXPECT_NEAR(tracks[0].box.centre_m.x(), 0.8 * k, 0.2 + 0.1 * coasted);
    variance = tracks[0].state.covariance(0, 0);
  }
  EXPECT_EQ(coasted, 10) << "0.15 times 5.6 s";
}

TEST(Tracker, ATentativeTrackThatCannotBeConfirmedIsDropped) {
  Tracker tracker;
  feed(tracker, 0, {car_at(0, 0)});
  EXPECT_EQ(feed(tracker, 0.08, {}).size(), 1U);
  EXPECT_EQ(feed(tracker, 0.16, {}).size(), 1U);
  EXPECT_EQ(feed(tracker, 0.24, {}).size(), 0U);
}

TEST(Tracker, KeepsItsIdentityThroughFourteenHiddenFramesAndABrakingTarget) {
  int kept = 0;
  for (int run = 0; run < 50; ++run) {
    Mover car{{0, 0}, {10, 0}};
    car.accel = [](double t) {
      return t > 4.9 && t < 6.2 ? Eigen::Vector2d(-2.5, 0) : Eigen::Vector2d(0, 0);
    };
    SceneOptions options;
    options.frames = 90;
    options.half_field_m = 80;
    auto frames = testing::play({car}, options, run);
    Tracker tracker;
    std::int64_t before = -1, after = -2;
    for (int k = 0; k < options.frames; ++k) {
      if (k >= 62 && k <= 75) frames[k].detections.clear();
      for (const Track& t : tracker.step(frames[k].stamp, frames[k].detections)) {
        const Eigen::Vector2d truth(frames[k].truth[0](0), frames[k].truth[0](2));
        if (t.status == TrackStatus::kTentative || (t.box.centre_m - truth).norm() > 2) continue;
        if (k == 61) before = t.id;
        if (k == 89) after = t.id;
      }
    }
    kept += before == after;
  }
  EXPECT_GE(kept, 48);
}

TEST(Tracker, TwoPiecesOfOneCarDoNotMakeTwoTracks) {
  Tracker tracker;
  for (int k = 0; k < 10; ++k) feed(tracker, 0.08 * k, {car_at(0.8 * k, 0)});
  std::vector<Track> tracks;
  for (int k = 10; k < 20; ++k) {
    Detection front = car_at(0.8 * k + 1.4, 0), rear = car_at(0.8 * k - 1.4, 0);
    front.box.length_m = rear.box.length_m = 1.2;
    front.length_seen = rear.length_seen = false;
    tracks = feed(tracker, 0.08 * k, {front, rear});
  }
  EXPECT_EQ(tracks.size(), 1U);
}

TEST(Tracker, AVehicleThatTurnsOutToBeAPedestrianHasItsSize) {
  Tracker tracker;
  Detection car = car_at(10, 0);
  car.length_seen = car.width_seen = false;
  feed(tracker, 0, {car});
  Detection person = car;
  person.object_class = ObjectClass::kPedestrian;
  person.box.length_m = person.box.width_m = 0.5;
  person.length_seen = person.width_seen = true;
  person.box.centre_m.x() -= (car.box.length_m - 0.5) / 2;
  std::vector<Track> tracks;
  for (int k = 1; k < 10; ++k) tracks = feed(tracker, 0.08 * k, {person});
  ASSERT_EQ(tracks.size(), 1U);
  EXPECT_EQ(tracks[0].object_class, ObjectClass::kPedestrian);
  EXPECT_NEAR(tracks[0].box.length_m, 0.5, 0.2);
  EXPECT_NEAR(tracks[0].box.width_m, 0.5, 0.2);
  EXPECT_NEAR(tracks[0].box.centre_m.x(), person.box.centre_m.x(), 0.3);
}

TEST(Tracker, TheSameInputGivesTheSameBytes) {
  const auto frames = testing::play(testing::set_pieces()[1].movers, {}, 3);
  Tracker a, b;
  for (const auto& frame : frames) {
    const auto left = a.step(frame.stamp, frame.detections);
    const auto right = b.step(frame.stamp, frame.detections);
    ASSERT_EQ(left.size(), right.size());
    for (std::size_t i = 0; i < left.size(); ++i) {
      EXPECT_EQ(left[i].id, right[i].id);
      EXPECT_EQ(left[i].state.mean, right[i].state.mean);
      EXPECT_EQ(left[i].state.covariance, right[i].state.covariance);
    }
  }
}

TEST(Tracker, AnEqualStampMovesNothingAndCountsNoMiss) {
  Tracker tracker;
  for (int k = 0; k < 5; ++k) feed(tracker, 0.08 * k, {car_at(0.8 * k, 0)});
  const auto before = feed(tracker, 0.40, {car_at(4.0, 0)});
  const auto after = feed(tracker, 0.40, {});
  ASSERT_EQ(after.size(), 1U);
  EXPECT_EQ(after[0].state.mean, before[0].state.mean);
  EXPECT_EQ(after[0].missed_frames, 0);
  EXPECT_EQ(after[0].detection, -1);
}

TEST(Tracker, ATargetIsMissedByTheSensorThatSawItNotByOneThatLooksElsewhere) {
  Tracker tracker;
  const auto see = [&](double seconds, int sensor, std::vector<Detection> detections) {
    return tracker.step(at(seconds), detections, sensor);
  };
  std::vector<Track> tracks;
  for (int k = 0; k < 20; ++k) {  // one ahead of the left scanner, one behind the right one
    see(0.1 * k, 0, {car_at(20, 0)});
    tracks = see(0.1 * k + 0.05, 1, {car_at(-20, 0)});
  }
  ASSERT_EQ(tracks.size(), 2U);
  for (const Track& track : tracks) {
    EXPECT_EQ(track.status, TrackStatus::kConfirmed);
    EXPECT_EQ(track.missed_frames, 0);
  }
  tracks = see(2, 0, {});
  ASSERT_EQ(tracks.size(), 2U);
  EXPECT_EQ(tracks[0].status, TrackStatus::kCoasting);
  EXPECT_EQ(tracks[1].status, TrackStatus::kConfirmed);
  for (int k = 1; k < 20; ++k) tracks = see(2 + 0.1 * k, 0, {car_at(20, 0)});
  EXPECT_EQ(tracks.size(), 1U) << "the right scanner fell silent, and what it saw is gone";
}

TEST(Tracker, AnOlderScanIsLeftOutAndCounted) {
  Tracker tracker;
  for (int k = 0; k < 5; ++k) feed(tracker, 0.08 * k, {car_at(0, 0)});
  const auto tracks = feed(tracker, 0.2, {car_at(0, 0), car_at(20, 0)});
  ASSERT_EQ(tracks.size(), 1U);
  EXPECT_EQ(tracks[0].age_frames, 5);
  EXPECT_EQ(tracker.diagnostics().count("scan older than the last one left out of tracking"), 1);
}

TEST(Tracker, JumpsOfTheClockDropTheTracksAndAreCounted) {
  Tracker tracker;
  for (int k = 0; k < 5; ++k) feed(tracker, 0.08 * k, {car_at(0, 0)});
  EXPECT_EQ(feed(tracker, 100, {car_at(0, 0)})[0].status, TrackStatus::kTentative);
  EXPECT_EQ(feed(tracker, 50, {car_at(0, 0)})[0].id, 3);
  const Time first = Time::min(), last = Time::max();
  tracker.step(last, {});
  tracker.step(first, {});
  EXPECT_EQ(tracker.diagnostics().count("pause in the data, tracks dropped"), 2);
  EXPECT_EQ(tracker.diagnostics().count("clock stepped back, tracks dropped"), 2);
}

TEST(Tracker, UnusableDetectionsAreLeftOutAndCounted) {
  Tracker tracker;
  std::vector<Detection> bad(5, car_at(0, 0));
  bad[0].box.centre_m.x() = kNan;
  bad[1].box.heading_rad = std::numeric_limits<double>::infinity();
  bad[2].box.length_m = -1;
  bad[3].box.centre_m.y() = 1e300;
  bad[4] = car_at(5, 5);
  const auto tracks = feed(tracker, 0, bad);
  ASSERT_EQ(tracks.size(), 1U);
  EXPECT_EQ(tracks[0].detection, 4);
  EXPECT_EQ(tracker.diagnostics().count("detection with unusable numbers left out"), 4);
}

TEST(Tracker, ABadCovarianceIsReplacedAndNoNumberBecomesNan) {
  for (const double bad : {kNan, 0.0, -1.0, 1e300, 1e-300}) {
    Tracker tracker;
    for (int k = 0; k < 40; ++k) {
      Detection d = car_at(0.8 * k, 0);
      d.covariance.setConstant(bad);
      d.var_length_m2 = d.var_width_m2 = bad;
      for (const Track& t : feed(tracker, 0.08 * k, {d})) {
        EXPECT_TRUE(t.state.mean.allFinite() && t.state.covariance.allFinite()) << bad;
        EXPECT_TRUE(std::isfinite(t.box.heading_rad + t.box.length_m + t.box.width_m)) << bad;
      }
    }
  }
}

TEST(Tracker, AnyOptionsInTheirRangeAreSurvived) {
  RandomStream random(9);
  for (int run = 0; run < 60; ++run) {
    TrackerOptions options;
    std::apply(
        [&](const auto&... field) {
          const auto draw = [&](const auto& f) {
            using T = std::decay_t<decltype(options.*f.member)>;
            if constexpr (std::is_same_v<T, bool>)
              options.*f.member = random.chance(0.5);
            else if constexpr (std::is_arithmetic_v<T>)
              options.*f.member = static_cast<T>(random.chance(0.5) ? f.low : f.high);
          };
          (draw(field), ...);
        },
        TrackerOptions::fields());
    options.max_gap_s = 2;
    Tracker tracker(options);
    SceneOptions scene;
    scene.frames = 30;
    for (const auto& frame : testing::play(testing::set_pieces()[5].movers, scene, run)) {
      for (const Track& t : tracker.step(frame.stamp, frame.detections)) {
        ASSERT_TRUE(t.state.mean.allFinite() && t.state.covariance.allFinite());
      }
    }
  }
}

TEST(LiteralBank, StartsAFilterAtOnceAndCoastsTwentyFrames) {
  Tracker tracker(literal_options());
  EXPECT_EQ(feed(tracker, 0, {car_at(0, 0)})[0].status, TrackStatus::kConfirmed);
  int lived = 0;
  for (int k = 1; k < 40; ++k) lived += !feed(tracker, 0.08 * k, {}).empty();
  EXPECT_EQ(lived, 20);
}

TEST(LiteralBank, IsTheFilterOfEquationsEightToSixteen) {
  Tracker tracker(literal_options());
  const double dt = 0.08;
  Eigen::Vector4d x(1, 0, 2, 0);
  Eigen::Matrix4d P = Eigen::Matrix4d::Zero(), A = Eigen::Matrix4d::Identity();
  A(0, 1) = A(2, 3) = dt;
  for (const int i : {0, 2}) {
    P.block<2, 2>(i, i) << 0.25, 0.25 / dt, 0.25 / dt, 0.5 / (dt * dt);
  }
  Eigen::Matrix<double, 2, 4> H = Eigen::Matrix<double, 2, 4>::Zero();
  H(0, 0) = H(1, 2) = 1;
  feed(tracker, 0, {car_at(1, 2)});
  for (int k = 1; k < 30; ++k) {
    const Eigen::Vector2d z(1 + 0.7 * k + 0.1 * std::sin(k), 2 + 0.1 * std::cos(k));
    x = A * x;
    P = A * P * A.transpose();
    const Eigen::Matrix2d S = H * P * H.transpose() + 0.04 * Eigen::Matrix2d::Identity();
    const Eigen::Matrix<double, 4, 2> K = P * H.transpose() * S.inverse();
    x += K * (z - H * x);
    P = (Eigen::Matrix4d::Identity() - K * H) * P;
    const auto tracks = feed(tracker, dt * k, {car_at(z.x(), z.y())});
    ASSERT_EQ(tracks.size(), 1U);
    EXPECT_TRUE(tracks[0].state.mean.isApprox(x, 1e-9)) << k;
    EXPECT_TRUE(tracks[0].state.covariance.isApprox(P, 1e-7)) << k;
  }
}

}  // namespace
}  // namespace scanfuse::track
