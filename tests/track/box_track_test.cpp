#include <gtest/gtest.h>

#include <algorithm>

#include "scanfuse/estimate/kalman.hpp"
#include "scanfuse/track/heading.hpp"
#include "track/scene.hpp"

namespace scanfuse::track {
namespace {

Time moment(int frame) { return time_from_seconds(1000 + 0.08 * frame); }

/// A car of which a sensor at the origin sees the rear face only: length is the class's.
Detection rear_only(const Eigen::Vector2d& centre, double length_m, RandomStream& random) {
  Detection d;
  const double sigma = 0.05, believed = 4.4;
  d.box = {centre, 0, believed, 1.8};
  d.box.centre_m.x() += (believed - length_m) / 2 + random.normal(0, sigma);
  d.box.centre_m.y() += random.normal(0, sigma);
  d.covariance = Eigen::Vector3d(sigma * sigma, sigma * sigma, 0.003).asDiagonal();
  d.var_length_m2 = 0.25;
  d.var_width_m2 = 0.01;
  d.width_seen = true;
  d.faces_seen = 1;
  d.visible_middle_m = centre - Eigen::Vector2d(length_m / 2, 0);
  return d;
}

/// The same with its whole side in view.
Detection corner_seen(const Eigen::Vector2d& centre, double length_m, RandomStream& random) {
  Detection d = rear_only(centre, length_m, random);
  const double seen_m = length_m + random.normal(0, 0.1);
  d.box.centre_m.x() += (seen_m - 4.4) / 2;
  d.box.length_m = seen_m;
  d.var_length_m2 = 0.01;
  d.length_seen = true;
  d.faces_seen = 2;
  return d;
}

TEST(BoxTrack, CentreDoesNotJumpWhenTheSideComesIntoView) {
  for (const double length : {3.8, 4.4, 5.0}) {
    RandomStream random(1);
    Tracker tracker;
    double before = 0;
    for (int k = 0; k < 80; ++k) {
      const Eigen::Vector2d centre(20 + 0.4 * k, 4);
      const Detection d =
          k < 40 ? rear_only(centre, length, random) : corner_seen(centre, length, random);
      const auto& tracks = tracker.step(moment(k), std::span(&d, 1));
      ASSERT_EQ(tracks.size(), 1U);
      const double error = tracks[0].box.centre_m.x() - centre.x();
      // Before: half of what the length is off. After: known, and velocity did not take the step.
      if (k == 39) before = error;
      if (k > 45) {
        EXPECT_NEAR(error, 0, 0.2) << length << " at " << k;
      }
      if (k > 20) {
        EXPECT_NEAR(tracks[0].state.mean(1), 5, 0.5) << length << " at " << k;
      }
      if (k == 79) {
        EXPECT_NEAR(tracks[0].box.length_m, length, 0.15);
      }
    }
    EXPECT_NEAR(before, (4.4 - length) / 2, 0.12);
  }
}

TEST(BoxTrack, NeesStaysHonestWhileTheLengthIsOnlyBelieved) {
  std::vector<double> nees;
  for (int run = 0; run < 200; ++run) {
    RandomStream random(7, run);
    const double length = 4.4 + random.normal(0, 0.5);
    const double vx = random.normal(0, 6);
    Tracker tracker;
    for (int k = 0; k < 60; ++k) {
      const Eigen::Vector4d truth(40 + vx * 0.08 * k, vx, 3, 0);
      const Detection d = rear_only({truth(0), truth(2)}, length, random);
      const auto& tracks = tracker.step(moment(k), std::span(&d, 1));
      if (k == 59) nees.push_back(estimate::nees(tracks[0].state, truth));
    }
  }
  std::nth_element(nees.begin(), nees.begin() + 100, nees.end());
  // The targets do not accelerate and the filter allows for it: below the median of chi-square 4.
  EXPECT_GT(nees[100], 0.5);
  EXPECT_LT(nees[100], 6);
}

TEST(BoxTrack, HeadingSignFollowsTheMotionAndDoesNotFlip) {
  for (const double sign : {1.0, -1.0}) {
    RandomStream random(3);
    Tracker tracker;
    for (int k = 0; k < 60; ++k) {
      const Eigen::Vector2d centre(30 + sign * 0.5 * k, 5);
      Detection d = corner_seen(centre, 4.4, random);
      d.box.heading_rad = random.normal(0, 0.05) + (k % 2 ? kPi : 0);
      const auto& tracks = tracker.step(moment(k), std::span(&d, 1));
      if (k < 6) continue;
      EXPECT_GT(sign * std::cos(tracks[0].box.heading_rad), 0.95) << k;
    }
  }
}

TEST(BoxTrack, AParkedCarKeepsItsHeadingAgainstQuarterTurns) {
  RandomStream random(4);
  Tracker tracker;
  double first = 0;
  for (int k = 0; k < 100; ++k) {
    Detection d = rear_only({15, 2}, 4.4, random);
    d.box.heading_rad = random.normal(0, 0.05);
    if (k > 5 && k % 3 == 0) {
      d.box.heading_rad += kPi / 2;
      std::swap(d.box.length_m, d.box.width_m);
      std::swap(d.length_seen, d.width_seen);
      std::swap(d.var_length_m2, d.var_width_m2);
    }
    const auto& tracks = tracker.step(moment(k), std::span(&d, 1));
    if (k == 5) first = tracks[0].box.heading_rad;
    if (k > 5) {
      EXPECT_NEAR(wrap_pi(tracks[0].box.heading_rad - first), 0, 0.15) << k;
    }
    if (k == 99) {
      EXPECT_NEAR(tracks[0].box.length_m, 4.4, 0.3);
      EXPECT_NEAR(tracks[0].box.width_m, 1.8, 0.1);
      EXPECT_LT(tracks[0].speed_m_per_s, 0.3);
    }
  }
}

TEST(BoxTrack, YawRateOfASteadyTurnIsReported) {
  RandomStream random(5);
  Tracker tracker;
  const double w = 0.3, v = 6, radius = v / w;
  double mean_yaw_rate = 0, mean_square_error = 0;
  for (int k = 0; k < 100; ++k) {
    const double psi = w * 0.08 * k;
    const Eigen::Vector2d centre(20 + radius * std::sin(psi), -radius * std::cos(psi));
    const testing::Mover car{{0, 0}, {0, 0}};
    Detection d = testing::box_detection(
        centre + Eigen::Vector2d(random.normal(0, 0.05), random.normal(0, 0.05)),
        psi + random.normal(0, 0.04), car, 0.05);
    const auto& tracks = tracker.step(moment(k), std::span(&d, 1));
    if (k < 50) continue;
    mean_yaw_rate += tracks[0].yaw_rate_rad_per_s / 50;
    mean_square_error += std::pow(tracks[0].yaw_rate_rad_per_s - w, 2) / 50;
    EXPECT_NEAR(tracks[0].yaw_rate_rad_per_s, w, 0.3) << k;  // the largest of 50 errors
    EXPECT_NEAR(wrap_pi(tracks[0].box.heading_rad - psi), 0, 0.12) << k;
    EXPECT_NEAR(tracks[0].speed_m_per_s, v, 0.9) << k;
  }
  EXPECT_LT(std::sqrt(mean_square_error), 0.12);
  EXPECT_NEAR(mean_yaw_rate, w, 0.1);  // turns are believed to end: it stays low
}

}  // namespace
}  // namespace scanfuse::track
