#include "scanfuse/triangulate/associate_scan.hpp"

#include <gtest/gtest.h>

#include "scanfuse/evaluate/association_score.hpp"
#include "scanfuse/simulate/passive.hpp"
#include "triangulate/scene_of_three.hpp"

namespace scanfuse::triangulate {
namespace {

using simulate::PassiveOptions;

evaluate::AssociationScore score(const PassiveOptions& options, int runs,
                                 CostMethod cost = CostMethod::kEvidence) {
  evaluate::AssociationScore sum;
  AssociationOptions association;
  association.cost = cost;
  for (int k = 0; k < runs; ++k) {
    const auto recording = simulate::simulate_passive(options, static_cast<std::uint64_t>(k) + 1);
    const auto found = associate_scan(recording->scans[0], recording->scene, association);
    EXPECT_TRUE(found && found->solution.proved);
    EXPECT_TRUE(associate::check_bound(found->packing, found->solution));
    std::vector<Eigen::Vector3d> places;
    for (const auto& target : recording->targets[0]) places.push_back(target.position_m);
    sum.add(recording->scans[0], found->fixes, places);
  }
  return sum;
}

TEST(AssociateScan, JoinsAllBearingsOfQuietTargets) {
  PassiveOptions options;
  options.noise_rad = 1e-5;
  const auto quiet = score(options, 5);
  EXPECT_EQ(quiet.exact_rate(), 1);
  EXPECT_EQ(quiet.ghosts, 0);
  EXPECT_LT(quiet.ospa_m(), 5);
}

// Two targets 0.5 km apart at 5 mrad: a scene whose figures are known (0.776 of tuples right).
TEST(AssociateScan, SeparatesTwoTargetsAsWellAsIsPossible) {
  PassiveOptions options;
  options.targets = 2;
  options.spacing_m = 500;
  EXPECT_NEAR(score(options, 300).exact_rate(), 0.776, 0.05);
}

TEST(AssociateScan, EvidenceBeatsThePrintedCostWithMissesAndClutter) {
  PassiveOptions options;
  options.sensor_layout = simulate::SensorLayout::kRandom;
  options.target_layout = simulate::TargetLayout::kRandom;
  options.detection_probability = 0.9;
  options.false_alarms = 5;
  const auto evidence = score(options, 20), printed = score(options, 20, CostMethod::kRenyiLiteral);
  EXPECT_GT(evidence.f1(), 0.91);
  EXPECT_LT(evidence.ghosts_per_scene(), 1.4);
  EXPECT_LT(printed.f1(), 0.6);
}

TEST(AssociateScan, NoneOneOrUselessBearingsGiveNoFix) {
  const PassiveScene scene = testing::scene_of_three();
  BearingScan scan;
  for (int k = 0; k < 2; ++k) {
    const auto found = associate_scan(scan, scene);
    ASSERT_TRUE(found);
    EXPECT_TRUE(found->fixes.empty());
    EXPECT_TRUE(found->solution.proved);
    EXPECT_EQ(found->target_of_bearing, std::vector<std::int64_t>(scan.bearings.size(), -1));
    scan.bearings.emplace_back();
  }
}

TEST(AssociateScan, FixesHaveDistinctTargetsAndTellWhoSawThem) {
  PassiveOptions options;
  options.detection_probability = 0.8;
  options.false_alarms = 4;
  const auto recording = simulate::simulate_passive(options, 4);
  const auto found = associate_scan(recording->scans[0], recording->scene);
  ASSERT_TRUE(found);
  for (std::size_t t = 0; t < found->fixes.size(); ++t) {
    const Fix& fix = found->fixes[t];
    EXPECT_EQ(fix.target, static_cast<std::int64_t>(t));
    EXPECT_GE(fix.bearings.size(), 2U);
    EXPECT_TRUE(fix.position_m.allFinite() && fix.covariance_m2.allFinite());
    for (const auto place : fix.bearings) {
      EXPECT_EQ(found->target_of_bearing[static_cast<std::size_t>(place)], fix.target);
    }
  }
}

TEST(AssociateScan, AzimuthsAloneFindTargetsInThePlane) {
  PassiveOptions options;
  options.targets = 5;
  options.azimuth_only = true;
  options.noise_rad = 0.001;
  options.sensors = 5;
  options.detection_probability = 0.95;
  options.sensor_layout = simulate::SensorLayout::kRandom;
  options.target_layout = simulate::TargetLayout::kRandom;
  EXPECT_GT(score(options, 20).f1(), 0.8);
}

}  // namespace
}  // namespace scanfuse::triangulate
