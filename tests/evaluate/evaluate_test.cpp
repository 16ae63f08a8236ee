#include "scanfuse/evaluate/evaluate.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <nlohmann/json.hpp>

#include "evaluate/sample.hpp"
#include "scanfuse/core/random.hpp"

namespace scanfuse::evaluate {
namespace {

using sample::object;
using sample::step;
using sample::track;
using sample::truth;

TEST(Evaluate, OfPerfectTracksIsPerfect) {
  std::vector<StepResult> steps;
  std::vector<TruthFrame> truths;
  for (int k = 0; k < 10; ++k) {
    steps.push_back(step(k, {track(7, k, 0), track(8, -k, 5)}));
    truths.push_back(truth(k, {object(1, k, 0), object(2, -k, 5)}));
  }
  const auto e = evaluate(steps, truths);
  EXPECT_EQ(e.frames, 10);
  EXPECT_DOUBLE_EQ(*e.clear.mota, 1);
  EXPECT_DOUBLE_EQ(*e.identity.idf1, 1);
  EXPECT_DOUBLE_EQ(*e.hota.hota, 1);
  EXPECT_DOUBLE_EQ(*e.sets.gospa_m, 0);
  EXPECT_DOUBLE_EQ(*e.sets.ospa2_m, 0);
  EXPECT_DOUBLE_EQ(*e.rmse.position_m, 0);
  EXPECT_DOUBLE_EQ(*e.ghosts_per_frame, 0);
  EXPECT_DOUBLE_EQ(*e.detection.at(ObjectClass::kVehicle).precision, 1);
}

TEST(Evaluate, CountsASwitchWhenTwoTracksTradePlaces) {
  const std::vector steps{step(0, {track(7, 0, 0), track(8, 5, 0)}),
                          step(1, {track(8, 0, 0), track(7, 5, 0)})};
  const std::vector truths{truth(0, {object(1, 0, 0), object(2, 5, 0)}),
                           truth(1, {object(1, 0, 0), object(2, 5, 0)})};
  const auto e = evaluate(steps, truths);
  EXPECT_EQ(e.clear.identity_switches, 2);
  EXPECT_DOUBLE_EQ(*e.clear.mota, 1 - 2.0 / 4);
  EXPECT_EQ(e.identities_of(1), (std::vector<FollowedBy>{{0, 7}, {1, 8}}));
  EXPECT_TRUE(e.identities_of(99).empty());
}

TEST(Evaluate, KeepsAMatchThatIsStillAllowedEvenWhenAnotherTrackIsNearer) {
  const std::vector steps{step(0, {track(7, 0, 0)}), step(1, {track(7, 0.6, 0), track(8, 0.1, 0)})};
  const std::vector truths{truth(0, {object(1, 0, 0)}), truth(1, {object(1, 0, 0)})};
  const auto e = evaluate(steps, truths);
  EXPECT_EQ(e.clear.identity_switches, 0);
  EXPECT_EQ(e.identities_of(1).back().track_id, 7);
}

TEST(Evaluate, DoesNotCountTentativeTracks) {
  auto born = track(7, 0, 0);
  born.status = TrackStatus::kTentative;
  const auto e = evaluate(std::vector{step(0, {born})}, std::vector{truth(0, {object(1, 0, 0)})});
  EXPECT_EQ(e.clear.false_negatives, 1);
  EXPECT_DOUBLE_EQ(*e.ghosts_per_frame, 0);
}

TEST(Evaluate, CountsAPoorEstimateAsAnErrorUpToTheMatchDistance) {
  const auto e =
      evaluate(std::vector{step(0, {track(7, 1.8, 0)})}, std::vector{truth(0, {object(1, 0, 0)})});
  EXPECT_EQ(e.clear.false_negatives, 1);
  EXPECT_DOUBLE_EQ(*e.rmse.position_m, 1.8);
  EXPECT_DOUBLE_EQ(*e.ghosts_per_frame, 0);
}

TEST(Evaluate, IgnoresObjectsWithFewPointsAndWhatTracksThem) {
  auto hidden = object(1, 0, 0);
  hidden.visible_points = 2;
  EvaluateOptions options;
  options.min_visible_points = 3;
  const auto e = evaluate(std::vector{step(0, {track(7, 0, 0), track(8, 20, 0)})},
                          std::vector{truth(0, {hidden, object(2, 20, 0)})}, options);
  EXPECT_DOUBLE_EQ(*e.clear.mota, 1);
  EXPECT_EQ(e.clear.true_positives, 1);
  EXPECT_DOUBLE_EQ(*e.ghosts_per_frame, 0);
}

TEST(Evaluate, IgnoresWhatIsOutsideTheRegion) {
  EvaluateOptions options;
  options.region_x1_m = 10;
  const auto e =
      evaluate(std::vector{step(0, {track(7, 10.2, 0), track(8, 9.9, 5), track(9, 50, 0)})},
               std::vector{truth(0, {object(1, 9.9, 0), object(2, 10.1, 5)})}, options);
  EXPECT_EQ(e.clear.true_positives, 1);
  EXPECT_EQ(e.clear.false_positives, 0);
  EXPECT_EQ(e.clear.false_negatives, 0);
}

TEST(Evaluate, MovesTracksIntoTheFrameOfTheTruth) {
  auto moving = track(7, 13, 4);
  moving.box.heading_rad = kPi / 2;
  moving.state.mean << 13, 0, 4, 2;
  moving.state.covariance = Eigen::Vector4d(1, 2, 3, 4).asDiagonal();
  auto s = step(0, {moving});
  s.world_from_ego = Pose3::from_planar({10, 4, kPi / 2});
  auto seen = object(1, 0, -3);
  seen.heading_rad = 0;
  seen.velocity_m_per_s = Eigen::Vector2d(2, 0);
  auto t = truth(0, {seen});
  t.coordinate_frame = "ego";
  const auto e = evaluate(std::vector{s}, std::vector{t});
  EXPECT_NEAR(*e.rmse.position_m, 0, 1e-12);
  EXPECT_NEAR(*e.rmse.velocity_m_per_s, 0, 1e-12);
  EXPECT_NEAR(*e.rmse.heading_rad, 0, 1e-12);
  const Track there = moved(moving, s.world_from_ego.planar().inverse());
  EXPECT_NEAR(there.state.covariance(0, 0), 3, 1e-12);
  EXPECT_NEAR(there.state.covariance(1, 1), 4, 1e-12);
  s.coordinate_frame = "ego";
  s.tracks = {there};
  EXPECT_NEAR(*evaluate(std::vector{s}, std::vector{t}).rmse.position_m, 0, 1e-12);
}

TEST(Evaluate, MatchesByStampWhenFrameNumbersMeanDifferentThings) {
  std::vector<StepResult> steps;
  std::vector<TruthFrame> truths;
  for (int k = 0; k < 20; ++k) {
    steps.push_back(step(k, {track(7, k, 0)}));
    auto t = truth(k, {object(1, k, 0)});
    t.frame = k + 5;
    truths.push_back(t);
  }
  EXPECT_DOUBLE_EQ(*evaluate(steps, truths).clear.mota, 1);
}

TEST(Evaluate, MatchesByFrameWhenClocksDiffer) {
  std::vector<StepResult> steps;
  std::vector<TruthFrame> truths;
  for (int k = 0; k < 20; ++k) {
    steps.push_back(step(k, {track(7, k, 0)}));
    auto t = truth(k, {object(1, k, 0)});
    t.stamp += std::chrono::hours(1000);
    truths.push_back(t);
  }
  EXPECT_DOUBLE_EQ(*evaluate(steps, truths).clear.mota, 1);
}

TEST(Evaluate, CanSkipScansWithoutTruth) {
  const std::vector steps{step(0, {track(7, 0, 0)}), step(1, {track(7, 0, 0)})};
  const std::vector truths{truth(0, {object(1, 0, 0)})};
  EXPECT_EQ(evaluate(steps, truths).clear.false_positives, 1);
  EvaluateOptions options;
  options.unlisted_frames = UnlistedFrames::kSkip;
  EXPECT_EQ(evaluate(steps, truths, options).clear.false_positives, 0);
}

TEST(Evaluate, TellsAReversedHeadingFromAWrongOne) {
  auto reversed = track(7, 0, 0);
  reversed.box.heading_rad = kPi - 0.1;
  auto ahead = object(1, 0, 0);
  ahead.heading_rad = 0;
  const auto e = evaluate(std::vector{step(0, {reversed})}, std::vector{truth(0, {ahead})});
  EXPECT_NEAR(*e.rmse.heading_rad, kPi - 0.1, 1e-12);
  EXPECT_NEAR(*e.rmse.heading_mod_pi_rad, 0.1, 1e-12);
  EXPECT_DOUBLE_EQ(*e.rmse.heading_reversed_share, 1);
}

TEST(Evaluate, NeesOfMatchedNoiseLiesInItsBand) {
  RandomStream random(3);
  const Eigen::Vector4d sigma(0.3, 0.5, 0.1, 0.8);
  std::vector<StepResult> steps;
  std::vector<TruthFrame> truths;
  for (int k = 0; k < 5000; ++k) {
    auto t = track(7, 0, 0);
    for (int i = 0; i < 4; ++i) t.state.mean[i] = sigma[i] * random.normal();
    t.state.covariance = sigma.array().square().matrix().asDiagonal();
    t.box.centre_m = {t.state.mean[0], t.state.mean[2]};
    auto o = object(1, 0, 0);
    o.velocity_m_per_s = Eigen::Vector2d::Zero();
    steps.push_back(step(k, {t}));
    truths.push_back(truth(k, {o}));
  }
  const auto c = evaluate(steps, truths).consistency;
  EXPECT_NEAR(*c.anees, 4, 0.12);  // sigma of the mean: sqrt(8 / 5000) = 0.04
  EXPECT_NEAR(*c.nees_median, 3.357, 0.12);
  EXPECT_NEAR(*c.nees_inside_95, 0.95, 0.01);
}

TEST(Evaluate, SaysNothingOfConsistencyWithoutACovarianceOfVelocity) {
  auto t = track(7, 0, 0);
  t.state.covariance = Eigen::Vector4d(1, 0, 1, 0).asDiagonal();
  auto o = object(1, 0, 0);
  o.velocity_m_per_s = Eigen::Vector2d::Zero();
  const auto e = evaluate(std::vector{step(0, {t})}, std::vector{truth(0, {o})});
  EXPECT_FALSE(e.consistency.anees);
  EXPECT_FALSE(e.consistency.anis);
}

TEST(Evaluate, OfNothingHasNoNumbersAndNoNotANumber) {
  const auto json = nlohmann::json::parse(to_json(evaluate({}, {})));
  EXPECT_EQ(json["frames"], 0);
  EXPECT_TRUE(json["clear"]["MOTA"].is_null());
  EXPECT_TRUE(json["gospa"]["gospa_m"].is_null());
  EXPECT_TRUE(json["rmse"]["position_m"].is_null());
}

TEST(Evaluate, StandsPositionsThatAreNotFinite) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto e = evaluate(std::vector{step(0, {track(7, nan, 0), track(8, 1e300, -1e300)})},
                          std::vector{truth(0, {object(1, 0, nan), object(2, 0, 0)})});
  EXPECT_EQ(to_json(e).find("nan"), std::string::npos);
  EXPECT_EQ(to_json(e).find("inf"), std::string::npos);
  EXPECT_TRUE(nlohmann::json::accept(to_json(e)));
}

TEST(Evaluate, PrintsTheKeysThatScriptsRelyOn) {
  const auto e =
      evaluate(std::vector{step(0, {track(7, 0.5, 0)})}, std::vector{truth(0, {object(1, 0, 0)})});
  const auto json = nlohmann::json::parse(to_json(e));
  for (const auto* key : {"MOTA", "MOTP_m", "TP", "FP", "FN", "IDSW", "Frag", "MT", "PT", "ML"}) {
    EXPECT_TRUE(json["clear"].contains(key)) << key;
  }
  EXPECT_EQ(json["clear"]["MOTP_m"], 0.5);
  EXPECT_EQ(json["detection"]["vehicle"]["recall"], 1.0);
  EXPECT_EQ(json["confusion"]["vehicle"]["vehicle"], 1);
  EXPECT_TRUE(json["consistency"].contains("nees_inside_95"));
  EXPECT_NE(to_text(e).find("MOTA"), std::string::npos);
}

TEST(Gospa, OfAMissAndAFalseTrackIsTheirPriceTogether) {
  EvaluateOptions options;
  const auto parts = gospa(Eigen::MatrixXd::Constant(1, 1, 100), options);
  EXPECT_DOUBLE_EQ(parts.missed, 2);
  EXPECT_DOUBLE_EQ(parts.false_tracks, 2);
  EXPECT_DOUBLE_EQ(parts.total_m, 2);
  EXPECT_DOUBLE_EQ(gospa(Eigen::MatrixXd(0, 0), options).total_m, 0);
  EXPECT_DOUBLE_EQ(gospa(Eigen::MatrixXd(3, 0), options).missed, 6);
}

TEST(Gospa, IsSymmetricInTruthAndTracks) {
  RandomStream random(5);
  EvaluateOptions options;
  for (int trial = 0; trial < 50; ++trial) {
    Eigen::MatrixXd d(1 + random.below(6), 1 + random.below(6));
    for (double& value : d.reshaped()) value = random.uniform(0, 4);
    EXPECT_NEAR(gospa(d, options).total_m, gospa(d.transpose(), options).total_m, 1e-12);
    EXPECT_NEAR(ospa_m(d, options), ospa_m(d.transpose(), options), 1e-12);
  }
}

TEST(Ospa2, GrowsWhereAnIdentityChangesAndOspaDoesNot) {
  std::vector<StepResult> steady, changing;
  std::vector<TruthFrame> truths;
  for (int k = 0; k < 20; ++k) {
    steady.push_back(step(k, {track(7, k, 0)}));
    changing.push_back(step(k, {track(k < 10 ? 7 : 8, k, 0)}));
    truths.push_back(truth(k, {object(1, k, 0)}));
  }
  EXPECT_DOUBLE_EQ(*evaluate(changing, truths).sets.ospa_m, 0);
  EXPECT_DOUBLE_EQ(*evaluate(steady, truths).sets.ospa2_m, 0);
  EXPECT_GT(*evaluate(changing, truths).sets.ospa2_m, 0.1);
}

TEST(Evaluate, CountsGhostMoversOnlyWhereNothingIsAndOnlyWhenTheyMove) {
  auto ghost = track(7, 20, 0), wall = track(8, 30, 0), near = track(9, 0.3, 0);
  ghost.speed_m_per_s = near.speed_m_per_s = 2;
  const auto e =
      evaluate(std::vector{step(0, {ghost, wall, near})}, std::vector{truth(0, {object(1, 0, 0)})});
  EXPECT_DOUBLE_EQ(*e.ghost_movers_per_frame, 1);
  EXPECT_DOUBLE_EQ(*e.ghosts_per_frame, 2);
}

TEST(Evaluate, TimesTheFirstConfirmedTrackOfAnObject) {
  std::vector<StepResult> steps;
  std::vector<TruthFrame> truths;
  for (int k = 0; k < 10; ++k) {
    steps.push_back(step(k, k < 3 ? std::vector<Track>{} : std::vector{track(7, k, 0)}));
    truths.push_back(truth(k, {object(1, k, 0)}));
  }
  EXPECT_NEAR(*evaluate(steps, truths).time_to_confirm_s, 0.3, 1e-9);
}

TEST(Evaluate, TellsPrecisionAndRecallByRange) {
  const auto e = evaluate(std::vector{step(0, {track(7, 5, 0), track(8, 25, 0)})},
                          std::vector{truth(0, {object(1, 5, 0), object(2, 15, 0)})});
  const auto& rings = e.detection_by_range.at(ObjectClass::kVehicle);
  ASSERT_EQ(rings.size(), 3u);
  EXPECT_DOUBLE_EQ(*rings[0].precision, 1);
  EXPECT_DOUBLE_EQ(*rings[0].recall, 1);
  EXPECT_DOUBLE_EQ(*rings[1].recall, 0);
  EXPECT_FALSE(rings[1].precision.has_value());
  EXPECT_DOUBLE_EQ(*rings[2].precision, 0);
}

TEST(Evaluate, AveragesOverRecallRewardTracksThatKnowWhichAreGhosts) {
  const auto run = [](double score_of_ghost) {
    std::vector<StepResult> steps;
    std::vector<TruthFrame> truths;
    for (int k = 0; k < 10; ++k) {
      auto right = track(7, k, 0), ghost = track(8, k, 50);
      right.class_probability = 0.8;
      ghost.class_probability = score_of_ghost;
      steps.push_back(step(k, {right, ghost}));
      truths.push_back(truth(k, {object(1, k, 0)}));
    }
    return evaluate(steps, truths).average;
  };
  EXPECT_DOUBLE_EQ(*run(0.2).amota, 1);
  EXPECT_DOUBLE_EQ(*run(0.2).samota, 1);
  EXPECT_DOUBLE_EQ(*run(0.9).amota, 0);
  EXPECT_DOUBLE_EQ(*run(0.9).samota, 0);
}

TEST(Evaluate, BoxesThatOverlapLittleDoNotMatchByOverlap) {
  auto sideways = track(7, 0, 0);
  sideways.box = {{0.4, 0}, kPi / 2, 4, 2};
  auto box = object(1, 0, 0);
  box.heading_rad = 0;
  box.length_m = 4;
  box.width_m = 2;
  const std::vector steps{step(0, {sideways})};
  const std::vector truths{truth(0, {box})};
  EvaluateOptions by_overlap;
  by_overlap.similarity = SimilarityBy::kBevIou;
  EXPECT_EQ(evaluate(steps, truths).clear.true_positives, 1);
  EXPECT_EQ(evaluate(steps, truths, by_overlap).clear.true_positives, 0);
  EXPECT_NEAR(*evaluate(steps, truths).bev_iou, 1.0 / 3, 1e-9);
}

}  // namespace
}  // namespace scanfuse::evaluate
