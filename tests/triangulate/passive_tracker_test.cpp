#include "scanfuse/triangulate/passive_tracker.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <set>

#include "scanfuse/estimate/consistency.hpp"
#include "scanfuse/simulate/passive.hpp"
#include "triangulate/scene_of_three.hpp"

namespace scanfuse::triangulate {
namespace {

using simulate::PassiveOptions;
using simulate::PassiveRecording;
using testing::bearings_to;
using testing::scene_of_three;

struct Target {
  Eigen::Vector3d from_m, velocity_m_per_s;
  [[nodiscard]] Eigen::Vector3d at(double t_s) const { return from_m + t_s * velocity_m_per_s; }
};

/// What all sensors tell of moving points; every sensor sees every point.
BearingScan scan_of(const PassiveScene& scene, std::span<const Target> targets, int k,
                    std::uint64_t seed = 1) {
  BearingScan scan;
  scan.scan = k;
  scan.stamp = time_from_seconds(k);
  for (std::size_t t = 0; t < targets.size(); ++t) {
    const auto stream = (seed * 1000 + static_cast<std::uint64_t>(k)) * 1000 + t;
    for (Bearing b : bearings_to(scene, targets[t].at(k), 1, stream)) {
      b.truth = static_cast<std::int64_t>(t);
      b.measurement = static_cast<std::int64_t>(t);
      scan.bearings.push_back(b);
    }
  }
  return scan;
}

void keep_sensor(BearingScan& scan, std::int32_t sensor) {
  std::erase_if(scan.bearings, [&](const Bearing& b) { return b.sensor != sensor; });
}

PassiveScene quiet_scene(int targets) {
  PassiveScene scene = scene_of_three();
  scene.volume_m = PassiveScene::Volume{{{0, 40e3}, {0, 40e3}, {0, 11e3}}};
  scene.expected_targets = targets;
  for (auto& sensor : scene.sensors) sensor.clutter_density = 0.01;
  return scene;
}

std::vector<PassiveTrack> confirmed(const PassiveStep& step) {
  std::vector<PassiveTrack> tracks;
  for (const auto& track : step.tracks) {
    if (track.confirmed) tracks.push_back(track);
  }
  return tracks;
}

/// Whose bearings a track holds: the truth of the first.
std::int64_t owner(const PassiveTrack& track, const BearingScan& scan) {
  return track.bearings.empty()
             ? -2
             : *scan.bearings[static_cast<std::size_t>(track.bearings.front())].truth;
}

PassiveOptions busy_scene() {
  PassiveOptions options;
  options.targets = 10;
  options.target_layout = simulate::TargetLayout::kRandom;
  options.speed_m_per_s = 200;
  options.scans = 30;
  options.detection_probability = 0.9;
  options.false_alarms = 5;
  return options;
}

class EveryUpdate : public ::testing::TestWithParam<PointUpdateMethod> {};
INSTANTIATE_TEST_SUITE_P(All, EveryUpdate,
                         ::testing::Values(PointUpdateMethod::kEkf, PointUpdateMethod::kCubature));

// Targets whose velocity is drawn from what a new track believes, no clutter, no process noise.
TEST_P(EveryUpdate, ErrorsAreAsLargeAsTheTrackSays) {
  constexpr int kRuns = 200, kScans = 20;
  PassiveTrackOptions options;
  options.update = GetParam();
  options.sigma_accel = options.sigma_accel_z = 0;
  const PassiveScene scene = quiet_scene(1);
  double sum = 0;
  for (int run = 0; run < kRuns; ++run) {
    const auto seed = static_cast<std::uint64_t>(run) + 1;
    RandomStream random(seed, 7);
    const std::array targets{
        Target{{random.uniform(5e3, 35e3), random.uniform(5e3, 35e3), random.uniform(2e3, 10e3)},
               {200 * random.normal(), 200 * random.normal(), 50 * random.normal()}}};
    PassiveTracker tracker(scene, options);
    PassiveStep last;
    for (int k = 0; k < kScans; ++k) last = *tracker.step(scan_of(scene, targets, k, seed));
    ASSERT_EQ(last.tracks.size(), 1U) << run;
    Eigen::Matrix<double, 6, 1> off = last.tracks[0].state.mean;
    off.head<3>() -= targets[0].at(kScans - 1);
    off.tail<3>() -= targets[0].velocity_m_per_s;
    sum += off.dot(last.tracks[0].state.covariance.ldlt().solve(off));
  }
  const auto band = estimate::mean_chi_square_band(kRuns, 6, 0.99);
  EXPECT_TRUE(band.contains(sum / kRuns)) << sum / kRuns;
}

TEST_P(EveryUpdate, FollowsTargetsThroughMissesAndClutter) {
  PassiveTrackOptions options;
  options.update = GetParam();
  const auto recording = simulate::simulate_passive(busy_scene(), 1001);
  PassiveTracker tracker(recording->scene, options);
  std::set<std::int64_t> ids;
  PassiveStep last;
  for (const auto& scan : recording->scans) {
    last = *tracker.step(scan);
    for (const auto& track : confirmed(last)) ids.insert(track.id);
  }
  EXPECT_EQ(ids.size(), 10U);
  for (const auto& target : recording->targets.back()) {
    double nearest = 1e9;
    for (const auto& track : confirmed(last)) {
      nearest = std::min(nearest, (track.state.mean.head<3>() - target.position_m).norm());
    }
    EXPECT_LT(nearest, 500);
  }
}

// Tracks of the last scan, of targets that fly straight on; samples of one run are of different
// targets. The band is wide: one wrong bearing is worth many right ones.
TEST(PassiveTracker, ErrorsAreAsLargeAsItSaysAmongMissesAndClutter) {
  PassiveTrackOptions options;
  options.sigma_accel = options.sigma_accel_z = 0.01;
  double sum = 0;
  int samples = 0;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const auto recording = simulate::simulate_passive(busy_scene(), seed);
    PassiveTracker tracker(recording->scene, options);
    PassiveStep last;
    for (const auto& scan : recording->scans) last = *tracker.step(scan);
    for (const auto& track : confirmed(last)) {
      for (const auto& target : recording->targets.back()) {
        Eigen::Matrix<double, 6, 1> off = track.state.mean;
        off.head<3>() -= target.position_m;
        off.tail<3>() -= target.velocity_m_per_s;
        if (off.head<3>().norm() > 500) continue;
        sum += off.dot(track.state.covariance.ldlt().solve(off));
        ++samples;
      }
    }
  }
  EXPECT_GE(samples, 195);
  EXPECT_NEAR(sum / samples, 6, 1);
}

TEST(PassiveTracker, StartsAfterScansThatTellNothing) {
  PassiveScene scene = scene_of_three();
  for (auto& sensor : scene.sensors) sensor.clutter_density = 0.01;
  const std::array targets{Target{{15e3, 20e3, 5e3}, {200, -100, 0}},
                           Target{{25e3, 10e3, 5e3}, {0, 100, 0}}};
  PassiveTracker tracker(scene, {});
  PassiveStep last;
  for (int k = 0; k < 20; ++k) {
    BearingScan scan = scan_of(scene, targets, k);
    if (k < 3) scan.bearings.clear();
    if (k >= 3 && k < 6) keep_sensor(scan, 1);
    last = *tracker.step(scan);
  }
  EXPECT_EQ(confirmed(last).size(), 2U);
}

TEST(PassiveTracker, TakesAPriorOfNoTargets) {
  for (const auto association : {TrackAssociation::kJoint, TrackAssociation::kFixesFirst}) {
    PassiveScene scene = quiet_scene(0);
    const std::array targets{Target{{15e3, 20e3, 5e3}, {200, -100, 0}}};
    PassiveTrackOptions options;
    options.association = association;
    PassiveTracker tracker(scene, options);
    PassiveStep last;
    for (int k = 0; k < 10; ++k) last = *tracker.step(scan_of(scene, targets, k));
    for (const auto& track : last.tracks) {
      EXPECT_TRUE(std::isfinite(track.log_odds) && track.state.mean.allFinite());
    }
    EXPECT_LE(last.tracks.size(), 1U);
  }
}

TEST(PassiveTracker, KeepsIdentityWhileNothingIsSeen) {
  const PassiveScene scene = quiet_scene(1);
  const std::array targets{Target{{15e3, 20e3, 5e3}, {200, -100, 0}}};
  PassiveTracker tracker(scene, {});
  for (int k = 0; k < 20; ++k) {
    BearingScan scan = scan_of(scene, targets, k);
    if (k >= 10 && k < 14) scan.bearings.clear();
    const auto step = *tracker.step(scan);
    ASSERT_EQ(step.tracks.size(), 1U) << k;
    EXPECT_EQ(step.tracks[0].id, 1);
    EXPECT_EQ(step.tracks[0].missed_scans, k >= 10 && k < 14 ? k - 9 : 0);
  }
}

TEST(PassiveTracker, EndsATrackUnseenForTooLongAndNeverGivesItsNumberAgain) {
  const PassiveScene scene = quiet_scene(1);
  const std::array targets{Target{{15e3, 20e3, 5e3}, {0, 0, 0}}};
  PassiveTracker tracker(scene, {});
  std::set<std::int64_t> ids;
  for (int k = 0; k < 30; ++k) {
    BearingScan scan = scan_of(scene, targets, k);
    if (k >= 10 && k < 18) scan.bearings.clear();
    const auto step = *tracker.step(scan);
    EXPECT_EQ(step.tracks.empty(), k >= 15 && k < 18) << k;
    for (const auto& track : step.tracks) ids.insert(track.id);
  }
  EXPECT_EQ(ids, (std::set<std::int64_t>{1, 2}));
}

TEST(PassiveTracker, TellsCrossingTargetsApart) {
  const PassiveScene scene = quiet_scene(2);
  const std::array targets{Target{{14e3, 20e3, 6e3}, {300, 0, 0}},
                           Target{{20e3, 14e3, 6e3}, {0, 300, 0}}};
  int swapped = 0;
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    PassiveTracker tracker(scene, {});
    std::vector<std::int64_t> before;
    for (int k = 0; k < 40; ++k) {
      const BearingScan scan = scan_of(scene, targets, k, seed);
      const auto step = *tracker.step(scan);
      if (k != 5 && k != 39) continue;
      std::vector<std::int64_t> owners;
      for (const auto& track : confirmed(step)) owners.push_back(owner(track, scan));
      EXPECT_EQ(owners.size(), 2U);
      if (k == 5) before = owners;
      if (k == 39 && owners != before) ++swapped;
    }
  }
  EXPECT_LE(swapped, 1);
}

TEST(PassiveTracker, OneBearingOfOneSensorNarrowsATrack) {
  const PassiveScene scene = quiet_scene(1);
  const std::array targets{Target{{15e3, 20e3, 5e3}, {200, -100, 0}}};
  PassiveTracker heard(scene, {}), deaf(scene, {});
  for (int k = 0; k < 14; ++k) {
    BearingScan scan = scan_of(scene, targets, k), nothing = scan;
    if (k >= 10) {
      keep_sensor(scan, k % 3);
      nothing.bearings.clear();
    }
    const auto with = *heard.step(scan), without = *deaf.step(nothing);
    ASSERT_EQ(with.tracks.size(), 1U);
    ASSERT_EQ(without.tracks.size(), 1U);
    if (k < 10) continue;
    EXPECT_EQ(with.tracks[0].bearings.size(), 1U);
    EXPECT_LT(place_of(with.tracks[0].state).covariance.trace(),
              place_of(without.tracks[0].state).covariance.trace());
  }
}

TEST(PassiveTracker, FollowsTargetsByAzimuthAlone) {
  PassiveScene scene = quiet_scene(2);
  for (auto& sensor : scene.sensors) sensor.sigma_elevation_rad.reset();
  const std::array targets{Target{{14e3, 20e3, 6e3}, {200, 0, 0}},
                           Target{{25e3, 12e3, 6e3}, {0, 200, 0}}};
  PassiveTracker tracker(scene, {});
  PassiveStep last;
  for (int k = 0; k < 20; ++k) last = *tracker.step(scan_of(scene, targets, k));
  const auto tracks = confirmed(last);
  ASSERT_EQ(tracks.size(), 2U);
  for (const auto& track : tracks) {
    double nearest = 1e9;
    for (const Target& target : targets) {
      const Eigen::Vector3d off = track.state.mean.head<3>() - target.at(19);
      nearest = std::min(nearest, off.head<2>().norm());
    }
    EXPECT_LT(nearest, 300);
  }
}

TEST(PassiveTracker, ASensorOfAzimuthsAloneTakesPart) {
  PassiveScene scene = quiet_scene(1);
  scene.sensors[2].sigma_elevation_rad.reset();
  const std::array targets{Target{{15e3, 20e3, 5e3}, {200, -100, 0}}};
  PassiveTracker tracker(scene, {});
  PassiveStep last;
  for (int k = 0; k < 10; ++k) last = *tracker.step(scan_of(scene, targets, k));
  ASSERT_EQ(last.tracks.size(), 1U);
  EXPECT_EQ(last.tracks[0].bearings.size(), 3U);
}

TEST(PassiveTracker, FindsTheOffsetOfASensorWithinItsSigma) {
  double sum = 0;
  constexpr int kRuns = 10;
  for (std::uint64_t seed = 1; seed <= kRuns; ++seed) {
    PassiveOptions options = busy_scene();
    options.azimuth_bias_rad = 0.01;
    options.sensors = 4;
    options.sensor_layout = simulate::SensorLayout::kRandom;
    const auto recording = simulate::simulate_passive(options, seed);
    PassiveTrackOptions track;
    track.estimate_bias = true;
    PassiveTracker tracker(recording->scene, track);
    for (const auto& scan : recording->scans) ASSERT_TRUE(tracker.step(scan));
    const auto biases = tracker.biases();
    ASSERT_EQ(biases.size(), 4U);
    EXPECT_NEAR(biases[0].azimuth_rad, 0.01, 4 * biases[0].sigma_azimuth_rad) << seed;
    EXPECT_LT(biases[0].sigma_azimuth_rad, 0.002);
    for (std::size_t s = 0; s < biases.size(); ++s) {
      const double truth = s == 0 ? 0.01 : 0;
      const double off = (biases[s].azimuth_rad - truth) / biases[s].sigma_azimuth_rad;
      sum += off * off / 4;
    }
  }
  EXPECT_LT(sum / kRuns, 2);
}

TEST(BiasFilter, LeavesAloneWhatTwoSensorsCannotTell) {
  PassiveScene scene = scene_of_three();
  scene.sensors.pop_back();
  for (auto& sensor : scene.sensors) sensor.sigma_elevation_rad.reset();
  BiasFilter filter(scene.sensors, 0.02);
  const auto bearings = bearings_to(scene, {10e3, 12e3, 0}, 1);
  filter.learn(testing::lines_of(scene, bearings), {10e3, 12e3, 0});
  for (const auto& bias : filter.biases()) {
    EXPECT_DOUBLE_EQ(bias.sigma_azimuth_rad, 0.02);
    EXPECT_EQ(bias.azimuth_rad, 0);
  }
}

TEST(PassiveTracker, EmptyScansAreNothingSpecial) {
  PassiveTracker tracker(quiet_scene(1), {});
  BearingScan scan;
  for (int k = 0; k < 3; ++k) {
    const auto step = tracker.step(scan);
    ASSERT_TRUE(step);
    EXPECT_TRUE(step->tracks.empty());
  }
  PassiveTracker without_scene(scene_of_three(), {});
  EXPECT_TRUE(without_scene.step(scan));
}

TEST(PassiveTracker, GivesTheSameOnAnyNumberOfThreads) {
  for (const auto association : {TrackAssociation::kJoint, TrackAssociation::kFixesFirst}) {
    PassiveTrackOptions options;
    options.association = association;
    options.estimate_bias = true;
    const auto recording = simulate::simulate_passive(busy_scene(), 1002);
    PassiveTracker one(recording->scene, options), three(recording->scene, options);
    for (const auto& scan : recording->scans) {
      const auto a = *one.step(scan, 1), b = *three.step(scan, 3);
      ASSERT_EQ(a.track_of_bearing, b.track_of_bearing);
      ASSERT_EQ(a.tracks.size(), b.tracks.size());
      for (std::size_t t = 0; t < a.tracks.size(); ++t) {
        ASSERT_EQ(a.tracks[t].id, b.tracks[t].id);
        ASSERT_EQ(a.tracks[t].state.mean, b.tracks[t].state.mean);
        ASSERT_EQ(a.tracks[t].state.covariance, b.tracks[t].state.covariance);
      }
    }
  }
}

}  // namespace
}  // namespace scanfuse::triangulate
