#include "scanfuse/triangulate/contested_growth.hpp"

#include <gtest/gtest.h>

#include "scanfuse/simulate/passive.hpp"
#include "scanfuse/triangulate/associate_scan.hpp"

namespace scanfuse::triangulate {
namespace {

simulate::PassiveRecording scene_of(int targets, int sensors, double noise_rad, std::uint64_t seed,
                                    double spacing_m = 0) {
  simulate::PassiveOptions options;
  options.targets = targets;
  options.sensors = sensors;
  options.noise_rad = noise_rad;
  options.detection_probability = 0.9;
  options.false_alarms = 5;
  options.sensor_layout = simulate::SensorLayout::kRandom;
  options.target_layout =
      spacing_m > 0 ? simulate::TargetLayout::kCluster : simulate::TargetLayout::kRandom;
  options.spacing_m = spacing_m;
  return *simulate::simulate_passive(options, seed);
}

ScanAssociation associated(const simulate::PassiveRecording& scene, int many_sensors,
                           int steps_per_bearing = 20000) {
  AssociationOptions options;
  options.posterior = false;
  options.candidates.many_sensors = many_sensors;
  options.candidates.steps_per_bearing = steps_per_bearing;
  return *associate_scan(scene.scans[0], scene.scene, options);
}

// What is left out is in no optimum: the best of what is kept weighs as much as the best of all.
TEST(ContestedGrowth, LosesNoOptimum) {
  int fewer = 0;
  for (const auto& [targets, sensors, noise_rad, spacing_m] :
       {std::tuple{10, 7, 0.003, 0.0}, std::tuple{15, 4, 0.005, 0.0},
        std::tuple{4, 6, 0.005, 300.0}, std::tuple{3, 6, 0.01, 500.0}}) {
    for (std::uint64_t seed = 1; seed <= 6; ++seed) {
      const auto scene = scene_of(targets, sensors, noise_rad, seed, spacing_m);
      const auto all = associated(scene, 65), kept = associated(scene, 3);
      ASSERT_TRUE(all.proved);
      EXPECT_NEAR(kept.solution.primal, all.solution.primal, 1e-6 * all.solution.primal)
          << targets << " targets, " << sensors << " sensors, seed " << seed;
      EXPECT_GE(kept.dual, all.solution.primal * (1 - 1e-9));
      EXPECT_LE(kept.packing.columns(), all.packing.columns());
      fewer += kept.packing.columns() < all.packing.columns() ? 1 : 0;
    }
  }
  EXPECT_GT(fewer, 12);
}

// All subsets would be 2^64; the answer is there, and the gap says that it is not proved.
TEST(ContestedGrowth, FindsTargetsOfSixtyFourSensors) {
  const auto scene = scene_of(20, 64, 0.001, 1);
  const auto found = associated(scene, 7, 300);
  EXPECT_EQ(found.fixes.size(), 20U);
  EXPECT_LT(found.packing.columns(), 2000U);
  EXPECT_LT(found.gap(), 0.15);
  EXPECT_EQ(found.proved, found.cut_bearings == 0);
}

// Too few steps: less may be found, and the bound says so. It holds for the optimum all the same.
TEST(ContestedGrowth, TellsWhatIsCut) {
  const auto scene = scene_of(15, 7, 0.005, 3);
  const auto all = associated(scene, 65), cut = associated(scene, 7, 2);
  EXPECT_FALSE(cut.proved);
  EXPECT_GT(cut.cut_bearings, 0U);
  EXPECT_GT(cut.gap(), 0.0);
  EXPECT_GE(cut.dual, all.solution.primal);
}

// Prices of bearings cover every hypothesis, worth its place or not.
TEST(PairGraph, PricesCoverAllHypotheses) {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    const auto scene = scene_of(15, 5, 0.004, seed);
    AssociationOptions options;
    const auto prior = scene_prior(scene.scene, scene.scans[0]).prior;
    const auto weighed = weigh_hypotheses(scene.scans[0], scene.scene, prior, options, 1);
    ASSERT_TRUE(weighed);
    options.candidates.many_sensors = 3;
    options.candidates.steps_per_bearing = 100;
    const Cost cost = EvidenceCost{};
    const auto lines = lines_of_sight(scene.scans[0], scene.scene);
    const auto sensors = lines_by_sensor(lines, scene.scene);
    std::vector<std::vector<EpipolarIndex>> pairs(sensors.size());
    for (std::size_t a = 0; a < sensors.size(); ++a) {
      for (std::size_t b = a + 1; b < sensors.size(); ++b) {
        pairs[a].emplace_back(sensors[a].origin_m, sensors[b].lines);
      }
    }
    const Gate gate(0.9999, sensors.size());
    const GrowthScene growth{scene.scene, prior, cost, gate, std::sqrt(gate.of(1))};
    const PairGraph graph = pair_graph(sensors, pairs, growth, 1);
    const auto prices = covering_prices(graph);
    std::vector<double> price_of(lines.size(), 0);
    for (std::size_t n = 0; n < graph.size(); ++n) {
      price_of[static_cast<std::size_t>(graph.places[n])] = prices[n];
    }
    for (std::size_t k = 0; k < weighed->packing.columns(); ++k) {
      double sum = 0;
      for (const auto row : weighed->packing.column(k)) {
        sum += price_of[static_cast<std::size_t>(row)];
      }
      ASSERT_GE(sum, weighed->packing.weights[k] * (1 - 1e-9));
    }
  }
}

TEST(ContestedGrowth, GivesTheSameOnAnyNumberOfThreads) {
  const auto scene = scene_of(30, 10, 0.002, 4);
  AssociationOptions options;
  const auto one = *associate_scan(scene.scans[0], scene.scene, options, 1);
  const auto three = *associate_scan(scene.scans[0], scene.scene, options, 3);
  EXPECT_EQ(one.packing.members, three.packing.members);
  EXPECT_EQ(one.packing.weights, three.packing.weights);
  EXPECT_EQ(one.solution.chosen, three.solution.chosen);
}

}  // namespace
}  // namespace scanfuse::triangulate
