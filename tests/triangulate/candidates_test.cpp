#include "scanfuse/triangulate/candidates.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "scanfuse/simulate/passive.hpp"
#include "scanfuse/triangulate/closest_points.hpp"
#include "scanfuse/triangulate/epipolar_index.hpp"
#include "triangulate/scene_of_three.hpp"

namespace scanfuse::triangulate {
namespace {

simulate::PassiveRecording crowd(int targets, std::uint64_t seed, int sensors = 4) {
  simulate::PassiveOptions options;
  options.targets = targets;
  options.sensors = sensors;
  options.noise_rad = 0.003;
  options.detection_probability = 0.9;
  options.false_alarms = 3;
  options.sensor_layout = simulate::SensorLayout::kRandom;
  options.target_layout = simulate::TargetLayout::kRandom;
  return *simulate::simulate_passive(options, seed);
}

TEST(EpipolarIndex, FindsEveryPairThatMeets) {
  for (const std::uint64_t seed : {1U, 2U, 3U, 4U}) {
    const auto recording = crowd(60, seed);
    const auto lines = lines_of_sight(recording.scans[0], recording.scene);
    std::vector<LineOfSight> first, second;
    for (const LineOfSight& line : lines) {
      if (line.sensor == 0) first.push_back(line);
      if (line.sensor == 1) second.push_back(line);
    }
    const EpipolarIndex index(first.front().origin_m, second);
    for (const LineOfSight& line : first) {
      std::multiset<std::int32_t> found;
      index.for_partners(line, 4, [&](std::int32_t j) { found.insert(j); });
      for (std::size_t j = 0; j < second.size(); ++j) {
        const auto met = closest_points(line, second[j]);
        const auto times = found.count(static_cast<std::int32_t>(j));
        EXPECT_LE(times, 1U);
        if (met && met->sigmas_apart < 3) {
          EXPECT_EQ(times, 1U);
        }
      }
      EXPECT_LT(found.size(), second.size());
    }
  }
}

/// Members of a column as text, for sets.
std::set<std::vector<std::int32_t>> columns_of(const Candidates& candidates) {
  std::set<std::vector<std::int32_t>> columns;
  for (std::size_t k = 0; k < candidates.size(); ++k) {
    const auto column = candidates.column(k);
    EXPECT_TRUE(columns.emplace(column.begin(), column.end()).second) << "found twice";
  }
  return columns;
}

/// All tuples of bearings of different sensors, weighed one by one.
void try_all(const BearingScan& scan, const PassiveScene& scene, const ScenePrior& prior,
             std::size_t next, std::vector<std::int32_t>& members,
             std::set<std::vector<std::int32_t>>& worth) {
  if (members.size() >= 2) {
    std::vector<LineOfSight> lines;
    for (const auto m : members) {
      const Bearing& b = scan.bearings[static_cast<std::size_t>(m)];
      lines.push_back(line_of_sight(scene.sensors[static_cast<std::size_t>(b.sensor)], b));
    }
    const auto at = most_likely(lines);
    // Well inside all gates, so that their slack decides nothing.
    if (at && at->chi2 < 8 && EvidenceCost{}({lines, *at}, scene, prior) > 3) worth.insert(members);
  }
  for (std::size_t i = next; i < scan.bearings.size(); ++i) {
    if (!members.empty() &&
        scan.bearings[static_cast<std::size_t>(members.back())].sensor == scan.bearings[i].sensor) {
      continue;
    }
    members.push_back(static_cast<std::int32_t>(i));
    try_all(scan, scene, prior, i + 1, members, worth);
    members.pop_back();
  }
}

// What is missing from the columns is dominated: one bearing less weighs as much.
TEST(Candidates, HoldEveryHypothesisThatIsWorthIt) {
  for (const std::uint64_t seed : {5U, 6U}) {
    const auto recording = crowd(6, seed, 3);
    const auto prior = scene_prior(recording.scene, recording.scans[0]).prior;
    const auto found = find_candidates(recording.scans[0], recording.scene, prior, EvidenceCost{});
    const auto columns = columns_of(found);
    std::set<std::vector<std::int32_t>> worth;
    std::vector<std::int32_t> members;
    try_all(recording.scans[0], recording.scene, prior, 0, members, worth);
    ASSERT_FALSE(worth.empty());
    for (const auto& tuple : worth) {
      bool there = columns.contains(tuple);
      for (std::size_t m = 0; m < tuple.size() && !there && tuple.size() > 2; ++m) {
        auto fewer = tuple;
        fewer.erase(fewer.begin() + static_cast<std::ptrdiff_t>(m));
        there = columns.contains(fewer);
      }
      EXPECT_TRUE(there);
    }
  }
}

TEST(Candidates, AreTheSameOnAnyNumberOfThreads) {
  const auto recording = crowd(150, 7);
  const auto prior = scene_prior(recording.scene, recording.scans[0]).prior;
  const auto find = [&](int threads) {
    return find_candidates(recording.scans[0], recording.scene, prior, EvidenceCost{}, {}, threads);
  };
  const auto one = find(1), three = find(3);
  EXPECT_EQ(one.members, three.members);
  EXPECT_EQ(one.weights, three.weights);
  EXPECT_GT(one.size(), 150U);
}

TEST(Candidates, NarrowTheGateBeforeTheyGiveUp) {
  const auto recording = crowd(200, 8);
  const auto prior = scene_prior(recording.scene, recording.scans[0]).prior;
  CandidateOptions few;
  few.most_candidates = 1000;
  const auto found =
      find_candidates(recording.scans[0], recording.scene, prior, EvidenceCost{}, few);
  EXPECT_LT(found.gate_probability, few.gate_probability);
  EXPECT_TRUE(found.too_many || found.size() <= 1000U);
  if (found.too_many) {
    EXPECT_EQ(found.size(), 0U);
  }
}

TEST(Candidates, NarrowTheGateWhereThereAreTooManyPairs) {
  const auto recording = crowd(200, 8);
  const auto prior = scene_prior(recording.scene, recording.scans[0]).prior;
  const auto find = [&](int most_pairs) {
    CandidateOptions options;
    options.most_pairs = most_pairs;
    return find_candidates(recording.scans[0], recording.scene, prior, EvidenceCost{}, options);
  };
  const auto all = find(20000000);
  ASSERT_FALSE(all.too_many);
  const auto fewer = find(static_cast<int>(all.tried) - 1);
  EXPECT_LT(fewer.gate_probability, all.gate_probability);
  EXPECT_FALSE(fewer.too_many);
  EXPECT_LT(fewer.tried, all.tried);
  const auto none = find(1000);
  EXPECT_TRUE(none.too_many);
  EXPECT_EQ(none.size(), 0U);
}

// Two sensors at one place cannot locate, but each adds to what the third locates.
TEST(Candidates, SensorsAtOnePlaceShareATarget) {
  PassiveScene scene = testing::scene_of_three({0, 0, 0}, 0.001);
  scene.sensors.push_back(scene.sensors[0]);
  scene.sensors[1] = scene.sensors[0];
  scene.volume_m = PassiveScene::Volume{{{0, 40e3}, {0, 40e3}, {0, 11e3}}};
  scene.expected_targets = 1;
  BearingScan scan;
  scan.bearings = testing::bearings_to(scene, {20e3, 20e3, 8e3}, 0.5, 3);
  const auto found = find_candidates(scan, scene, scene_prior(scene, scan).prior, EvidenceCost{});
  EXPECT_TRUE(columns_of(found).contains({0, 1, 2, 3}));
}

}  // namespace
}  // namespace scanfuse::triangulate
