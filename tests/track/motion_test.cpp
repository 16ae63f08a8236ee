#include "scanfuse/track/motion.hpp"

#include <gtest/gtest.h>

#include "scanfuse/simulate/set_pieces.hpp"
#include "scanfuse/track/tracker.hpp"

namespace scanfuse::track {
namespace {

StateVector moving(double vx, double vy) {
  StateVector x = StateVector::Zero();
  x(kVx) = vx;
  x(kVy) = vy;
  return x;
}

TEST(StepAlongArc, WithoutTurnAndAccelerationIsConstantVelocity) {
  const Step step = step_along_arc(moving(8, -3), 0.1, 0, 0);
  StateMatrix F = StateMatrix::Identity();
  F(kX, kVx) = F(kY, kVy) = 0.1;
  EXPECT_EQ(step.F, F);
  EXPECT_TRUE(step.shift.isZero());
}

TEST(StepAlongArc, AQuarterOfACircleEndsOnIt) {
  const double w = 0.5, T = kPi / 2 / w, radius = 10 / w;
  const StateVector from = moving(10, 0);
  const Step step = step_along_arc(from, T, w, 0);
  const StateVector to = step.F * from + step.shift;
  EXPECT_NEAR(to(kX), radius, 1e-9);
  EXPECT_NEAR(to(kY), radius, 1e-9);
  EXPECT_NEAR(to(kVx), 0, 1e-9);
  EXPECT_NEAR(to(kVy), 10, 1e-9);
}

TEST(StepAlongArc, TwoHalfStepsAreOneWholeStep) {
  const StateVector from = moving(6, 2);
  const auto go = [](const StateVector& x, double dt) {
    const Step step = step_along_arc(x, dt, 0.3, -1.5);
    return StateVector(step.F * x + step.shift);
  };
  EXPECT_LT((go(go(from, 0.2), 0.2) - go(from, 0.4)).norm(), 1e-12);
}

TEST(StepAlongArc, BrakingEndsAtRest) {
  const StateVector from = moving(1, 0);
  const Step step = step_along_arc(from, 0.5, 0, -10);
  const StateVector to = step.F * from + step.shift;
  EXPECT_NEAR(to(kVx), 0, 1e-12);
}

/// A car that surely moves, and its heading filter's belief of the turn rate.
Target car_that_turns(double yaw_rate, double variance) {
  Target car;
  car.state.mean = moving(8, 0);
  car.state.covariance = 0.01 * StateMatrix::Identity();
  car.class_weight[static_cast<std::size_t>(ObjectClass::kVehicle)] = 1;
  car.heading.mean << 0, yaw_rate;
  car.heading.covariance << 0.001, 0, 0, variance;
  return car;
}

TEST(ManoeuvreOf, ATurnWithinItsNoiseIsHardlyGoneOnWith) {
  const auto m = manoeuvre_of(car_that_turns(0.06, 0.04 * 0.04), {});
  EXPECT_GT(m.yaw_rate_rad_per_s, 0);
  EXPECT_LT(m.yaw_rate_rad_per_s, 0.03);
}

TEST(ManoeuvreOf, ASureTurnIsGoneOnWith) {
  const auto m = manoeuvre_of(car_that_turns(-0.3, 0.04 * 0.04), {});
  EXPECT_NEAR(m.yaw_rate_rad_per_s, -0.3, 0.01);
}

TEST(ManoeuvreOf, NoTurnRateGivesNonsense) {
  for (const double w : {0.0, 1e-300, 1e3, 1e200}) {
    for (const double variance : {0.0, 1e-12, 1e6}) {
      const auto m = manoeuvre_of(car_that_turns(w, variance), {});
      EXPECT_TRUE(std::isfinite(m.yaw_rate_rad_per_s)) << w << " " << variance;
    }
  }
}

/// Mean error of the velocity over the last 60 of 100 scans of a car that turns.
double velocity_error(Motion motion) {
  simulate::Mover car{{-20, 0}, {8, 0}};
  constexpr double kTurn = 0.25;
  car.accel = [](double t) {
    return Eigen::Vector2d(-8 * kTurn * std::sin(kTurn * t), 8 * kTurn * std::cos(kTurn * t));
  };
  TrackerOptions options;
  options.motion = motion;
  double error = 0;
  int count = 0;
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    Tracker tracker(options);
    int frame = 0;
    simulate::SceneOptions scene;
    scene.clutter_per_frame = 0;
    for (const auto& f : simulate::play({car}, scene, seed)) {
      const auto& tracks = tracker.step(f.stamp, f.detections);
      if (++frame <= 40 || tracks.empty()) continue;
      const Eigen::Vector2d v(tracks[0].state.mean(1), tracks[0].state.mean(3));
      error += (v - Eigen::Vector2d(f.truth[0](1), f.truth[0](3))).norm();
      ++count;
    }
  }
  return error / count;
}

TEST(Motion, TurningModelsFollowABendMoreCloselyThanConstantVelocity) {
  const double cv = velocity_error(Motion::kCv);
  for (const auto& [name, motion] : choices(Motion{})) {
    if (motion == Motion::kCv) continue;
    const double error = velocity_error(motion);
    RecordProperty(name, std::to_string(error));
    EXPECT_LT(error, cv) << name << " against " << cv;
  }
}

// A car at rest for 3 s that then picks up speed at 2 m/s^2, the latest of 20.
TEST(Motion, ACarThatStartsIsSeenToMoveWithin800Milliseconds) {
  simulate::Mover car{{10, 0}, {0, 0}};
  constexpr double kStart_s = 3;
  car.accel = [](double t) { return Eigen::Vector2d(t >= kStart_s ? 2 : 0, 0); };
  TrackerOptions options;
  simulate::SceneOptions scene;
  scene.frames = 60;
  scene.clutter_per_frame = 0;
  scene.sigma_m = 0.05;
  double late_s = 0;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    Tracker tracker(options);
    double seen_s = 10;
    const auto frames = simulate::play({car}, scene, seed);
    for (const auto& f : frames) {
      const double t = to_seconds(f.stamp - frames.front().stamp);
      const auto& tracks = tracker.step(f.stamp, f.detections);
      const bool moves = !tracks.empty() && tracks[0].speed_m_per_s > 0;
      if (t > kStart_s && moves) seen_s = std::min(seen_s, t - kStart_s);
    }
    late_s = std::max(late_s, seen_s);
  }
  RecordProperty("late_s", std::to_string(late_s));
  EXPECT_LE(late_s, 0.8);
}

// Someone who walks at 1.3 m/s and someone who stands, both placed to 0.1 m, after 1.5 s.
TEST(Motion, AWalkerIsSeenToMoveAndWhoStandsIsNot) {
  constexpr auto kPerson = ObjectClass::kPedestrian;
  const simulate::Mover walker{{10, 0}, {1.3, 0}, kPerson, 0.6, 0.5};
  const simulate::Mover standing{{10, 5}, {0, 0}, kPerson, 0.6, 0.5};
  simulate::SceneOptions scene;
  scene.frames = 20;
  scene.clutter_per_frame = 0;
  scene.sigma_m = 0.1;
  scene.detection_probability = 1;
  int walk = 0, walkers = 0, rest = 0, resters = 0;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    Tracker tracker;
    const std::vector<Track>* tracks = nullptr;
    for (const auto& f : simulate::play({walker, standing}, scene, seed)) {
      tracks = &tracker.step(f.stamp, f.detections);
    }
    for (const Track& t : *tracks) {
      if (t.status == TrackStatus::kTentative) continue;
      const bool walks = t.box.centre_m.y() < 2.5;
      (walks ? walkers : resters) += 1;
      if (walks) walk += t.speed_m_per_s > 0 ? 1 : 0;
      if (!walks) rest += t.speed_m_per_s == 0 ? 1 : 0;
    }
  }
  EXPECT_GE(walkers, 18);
  EXPECT_GE(resters, 18);
  EXPECT_GE(walk, 0.9 * walkers);
  EXPECT_GE(rest, 0.95 * resters);
}

class AnyMotion : public ::testing::TestWithParam<Motion> {};

TEST_P(AnyMotion, TellsAParkedCarFromADrivingOne) {
  const simulate::Mover parked{{-10, 0}, {0, 0}}, driving{{-20, 15}, {5, 0}};
  TrackerOptions options;
  options.motion = GetParam();
  options.moving_from = 0.5;
  Tracker tracker(options);
  simulate::SceneOptions scene;
  scene.clutter_per_frame = 0;
  scene.sigma_m = 0.05;
  const std::vector<Track>* tracks = nullptr;
  for (const auto& f : simulate::play({parked, driving}, scene, 3)) {
    tracks = &tracker.step(f.stamp, f.detections);
  }
  int parked_ones = 0, driving_ones = 0;
  for (const Track& t : *tracks) {
    if (t.status != TrackStatus::kConfirmed) continue;
    if (t.box.centre_m.y() < 5) {
      EXPECT_LT(t.moving_probability, 0.5);
      EXPECT_EQ(t.speed_m_per_s, 0);
      ++parked_ones;
    } else {
      EXPECT_GT(t.moving_probability, 0.9);
      EXPECT_NEAR(t.speed_m_per_s, 5, 0.5);
      ++driving_ones;
    }
  }
  EXPECT_EQ(parked_ones, 1);
  EXPECT_EQ(driving_ones, 1);
}

INSTANTIATE_TEST_SUITE_P(Motions, AnyMotion,
                         ::testing::Values(Motion::kCv, Motion::kCtrv, Motion::kCtra,
                                           Motion::kImm));

}  // namespace
}  // namespace scanfuse::track
