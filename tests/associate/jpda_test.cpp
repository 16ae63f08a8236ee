#include "scanfuse/associate/jpda.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <string>

#include "scanfuse/core/random.hpp"

namespace scanfuse::associate {
namespace {

std::vector<GatedPair> random_pairs(int tracks, int detections, double share,
                                    RandomStream& random) {
  std::vector<GatedPair> pairs;
  for (int t = 0; t < tracks; ++t) {
    for (int d = 0; d < detections; ++d) {
      if (random.chance(share)) pairs.push_back({t, d, random.uniform(-12, 3)});
    }
  }
  return pairs;
}

/// Every joint assignment written out: P_D L for a pair, 1 - P_D P_G for a track missed, lambda for
/// a detection left over.
Marginals by_enumeration(int tracks, int detections, const std::vector<GatedPair>& pairs,
                         const JpdaOptions& options) {
  Marginals sums{std::vector<double>(pairs.size(), 0), std::vector<double>(tracks, 0)};
  std::vector<int> pair_of_track(tracks, -1);
  std::vector<bool> taken(detections, false);
  double total = 0;
  const double missed = 1 - options.detection_probability * options.gate_probability;
  const std::function<void(int, double)> descend = [&](int track, double weight) {
    if (track == tracks) {
      for (int d = 0; d < detections; ++d) weight *= taken[d] ? 1 : options.clutter_density;
      total += weight;
      for (int t = 0; t < tracks; ++t) {
        (pair_of_track[t] < 0 ? sums.missed[t] : sums.pair[pair_of_track[t]]) += weight;
      }
      return;
    }
    pair_of_track[track] = -1;
    descend(track + 1, weight * missed);
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      if (pairs[i].track != track || taken[pairs[i].detection]) continue;
      pair_of_track[track] = static_cast<int>(i);
      taken[pairs[i].detection] = true;
      descend(track + 1,
              weight * options.detection_probability * std::exp(pairs[i].log_likelihood));
      taken[pairs[i].detection] = false;
    }
    pair_of_track[track] = -1;
  };
  descend(0, 1);
  for (double& sum : sums.pair) sum /= total;
  for (double& sum : sums.missed) sum /= total;
  return sums;
}

double largest_difference(const Marginals& a, const Marginals& b) {
  double worst = 0;
  for (std::size_t i = 0; i < a.pair.size(); ++i) {
    worst = std::max(worst, std::abs(a.pair[i] - b.pair[i]));
  }
  for (std::size_t t = 0; t < a.missed.size(); ++t) {
    worst = std::max(worst, std::abs(a.missed[t] - b.missed[t]));
  }
  return worst;
}

void expect_marginals(const Marginals& m, int tracks, int detections,
                      const std::vector<GatedPair>& pairs) {
  std::vector<double> row = m.missed, column(detections, 0);
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    EXPECT_GE(m.pair[i], 0);
    row[pairs[i].track] += m.pair[i];
    column[pairs[i].detection] += m.pair[i];
  }
  for (int t = 0; t < tracks; ++t) EXPECT_NEAR(row[t], 1, 1e-12);
  for (int d = 0; d < detections; ++d) EXPECT_LE(column[d], 1 + 1e-12);
}

JpdaOptions random_options(RandomStream& random) {
  return {random.uniform(0.3, 0.99), random.uniform(0.9, 1), std::exp(random.uniform(-9, 1)), 8,
          CrowdMethod::kBeliefPropagation};
}

constexpr CrowdMethod kCrowdMethods[] = {CrowdMethod::kBeliefPropagation, CrowdMethod::kCheap};

/// Never exact.
JpdaOptions approximate(JpdaOptions options, CrowdMethod method) {
  options.exact_up_to = 0;
  options.crowd = method;
  return options;
}

TEST(Jpda, OneTrackAndOneDetectionHaveAClosedForm) {
  const JpdaOptions options{.detection_probability = 0.8, .clutter_density = 0.01};
  const std::vector<GatedPair> pairs = {{0, 0, std::log(0.3)}};
  const Marginals m = joint_probabilities(1, 1, pairs, options);
  const double hit = 0.8 * 0.3, miss = 0.2 * 0.01;
  EXPECT_NEAR(m.pair[0], hit / (hit + miss), 1e-15);
  EXPECT_NEAR(m.missed[0], miss / (hit + miss), 1e-15);
}

TEST(Jpda, AgreesWithTheSumOverAllJointAssignments) {
  RandomStream random(61);
  double worst = 0;
  for (int run = 0; run < 400; ++run) {
    const int tracks = 1 + static_cast<int>(random.below(run < 200 ? 4 : 6));
    const int detections = 1 + static_cast<int>(random.below(run < 200 ? 4 : 6));
    const auto pairs = random_pairs(tracks, detections, random.uniform(0.2, 1), random);
    const JpdaOptions options = random_options(random);
    const Marginals m = joint_probabilities(tracks, detections, pairs, options);
    worst =
        std::max(worst, largest_difference(m, by_enumeration(tracks, detections, pairs, options)));
  }
  RecordProperty("worst", ::testing::PrintToString(worst));
  EXPECT_LT(worst, 1e-12);
}

// Small, larger than what is exact, and lopsided.
TEST(Jpda, TracksSumToOneAndDetectionsToNoMore) {
  RandomStream random(62);
  for (const auto& [tracks, detections] : {std::pair{3, 5}, {8, 8}, {20, 20}, {30, 4}, {4, 30}}) {
    for (int run = 0; run < 20; ++run) {
      const auto pairs = random_pairs(tracks, detections, 0.4, random);
      JpdaOptions options = random_options(random);
      for (const CrowdMethod method : kCrowdMethods) {
        options.crowd = method;
        const Marginals m = joint_probabilities(tracks, detections, pairs, options);
        expect_marginals(m, tracks, detections, pairs);
      }
    }
  }
}

TEST(Jpda, NamesOfTracksAndDetectionsDoNotMatter) {
  RandomStream random(63);
  for (const int n : {5, 12}) {
    auto pairs = random_pairs(n, n, 0.5, random);
    const Marginals before = joint_probabilities(n, n, pairs);
    std::reverse(pairs.begin(), pairs.end());
    for (GatedPair& pair : pairs) {
      pair = {(pair.track + 2) % n, n - 1 - pair.detection, pair.log_likelihood};
    }
    const Marginals after = joint_probabilities(n, n, pairs);
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      EXPECT_NEAR(after.pair[pairs.size() - 1 - i], before.pair[i], 1e-12);
    }
    for (int t = 0; t < n; ++t) {
      EXPECT_NEAR(after.missed[(t + 2) % n], before.missed[t], 1e-12);
    }
  }
}

TEST(Jpda, WhatIsFarApartDoesNotInfluenceEachOther) {
  RandomStream random(64);
  const auto left = random_pairs(4, 4, 0.8, random), right = random_pairs(5, 3, 0.8, random);
  auto both = left;
  for (const GatedPair& pair : right) {
    both.push_back({pair.track + 4, pair.detection + 4, pair.log_likelihood});
  }
  const Marginals a = joint_probabilities(4, 4, left), b = joint_probabilities(5, 3, right);
  const Marginals all = joint_probabilities(9, 7, both);
  for (std::size_t i = 0; i < left.size(); ++i) EXPECT_EQ(all.pair[i], a.pair[i]);
  for (std::size_t i = 0; i < right.size(); ++i) EXPECT_EQ(all.pair[left.size() + i], b.pair[i]);
}

TEST(Jpda, NothingGivesMissedTracks) {
  EXPECT_EQ(joint_probabilities(2, 3, {}).missed, (std::vector<double>{1, 1}));
  EXPECT_TRUE(joint_probabilities(0, 3, {}).pair.empty());
  const double never = -std::numeric_limits<double>::infinity();
  const std::vector<GatedPair> pairs = {{0, 0, never}, {1, 0, std::nan("")}};
  const Marginals m = joint_probabilities(2, 1, pairs);
  EXPECT_EQ(m.pair, (std::vector<double>{0, 0}));
  EXPECT_EQ(m.missed, (std::vector<double>{1, 1}));
}

// Likelihoods of exp(+-3000): both tracks want the first detection, the better one gets it.
TEST(Jpda, LikelihoodsOfAnySizeAreFine) {
  const std::vector<GatedPair> pairs = {{0, 0, 3000}, {0, 1, -3000}, {1, 0, 2999}, {1, 1, -3000}};
  const Marginals m = joint_probabilities(2, 2, pairs);
  expect_marginals(m, 2, 2, pairs);
  EXPECT_NEAR(m.pair[0], 1 / (1 + std::exp(-1)), 1e-12);
  EXPECT_NEAR(m.pair[1], 0, 1e-300);
  for (const CrowdMethod method : kCrowdMethods) {
    expect_marginals(joint_probabilities(2, 2, pairs, approximate({}, method)), 2, 2, pairs);
  }
}

TEST(JpdaCrowd, IsExactWhereOneTrackOrOneDetectionIsAlone) {
  RandomStream random(65);
  const JpdaOptions exact = random_options(random);
  for (const auto& [tracks, detections] : {std::pair{1, 6}, {6, 1}}) {
    const auto pairs = random_pairs(tracks, detections, 1, random);
    const Marginals right = joint_probabilities(tracks, detections, pairs, exact);
    for (const CrowdMethod method : kCrowdMethods) {
      const auto options = approximate(exact, method);
      EXPECT_LT(largest_difference(joint_probabilities(tracks, detections, pairs, options), right),
                1e-12);
    }
  }
}

TEST(JpdaCrowd, BeliefPropagationIsExactOnAChain) {
  RandomStream random(68);
  std::vector<GatedPair> pairs;
  for (int t = 0; t < 7; ++t) {
    pairs.push_back({t, t, random.uniform(-12, 3)});
    pairs.push_back({t, t + 1, random.uniform(-12, 3)});
  }
  const JpdaOptions exact = random_options(random);
  const auto options = approximate(exact, CrowdMethod::kBeliefPropagation);
  EXPECT_LT(largest_difference(joint_probabilities(7, 8, pairs, options),
                               joint_probabilities(7, 8, pairs, exact)),
            1e-8);
}

/// Tracks and detections in a square of the plane, with likelihoods of a Gaussian.
std::vector<GatedPair> crowd(int n, double spread_sigmas, RandomStream& random) {
  std::vector<std::pair<double, double>> tracks(n), detections(n);
  for (int i = 0; i < n; ++i) {
    tracks[i] = {random.uniform(0, spread_sigmas), random.uniform(0, spread_sigmas)};
    detections[i] = {tracks[i].first + random.normal(), tracks[i].second + random.normal()};
  }
  std::vector<GatedPair> pairs;
  for (int t = 0; t < n; ++t) {
    for (int d = 0; d < n; ++d) {
      const double m2 = std::pow(tracks[t].first - detections[d].first, 2) +
                        std::pow(tracks[t].second - detections[d].second, 2);
      if (m2 < 13.8) pairs.push_back({t, d, -0.5 * m2 - std::log(2 * std::numbers::pi)});
    }
  }
  return pairs;
}

/// Mean over all pairs, and worst, of how far a method is off in probability.
std::pair<double, double> error_in_a_crowd(CrowdMethod method, double spread_sigmas) {
  RandomStream random(66);
  const JpdaOptions exact{.detection_probability = 0.9, .clutter_density = 0.01};
  const JpdaOptions rough = approximate(exact, method);
  double sum = 0, worst = 0;
  int count = 0;
  for (int run = 0; run < 200; ++run) {
    const auto pairs = crowd(8, spread_sigmas, random);
    const Marginals a = joint_probabilities(8, 8, pairs, exact);
    const Marginals b = joint_probabilities(8, 8, pairs, rough);
    for (std::size_t i = 0; i < pairs.size(); ++i, ++count) {
      sum += std::abs(a.pair[i] - b.pair[i]);
      worst = std::max(worst, std::abs(a.pair[i] - b.pair[i]));
    }
  }
  return {sum / count, worst};
}

TEST(JpdaCrowd, BeliefPropagationErrsLessThanTheCheapFormula) {
  for (const double spread : {4.0, 8.0, 16.0}) {
    const auto good = error_in_a_crowd(CrowdMethod::kBeliefPropagation, spread);
    const auto cheap = error_in_a_crowd(CrowdMethod::kCheap, spread);
    const std::string at = "_at_" + std::to_string(static_cast<int>(spread));
    RecordProperty("belief_propagation" + at, ::testing::PrintToString(good));
    RecordProperty("cheap" + at, ::testing::PrintToString(cheap));
    EXPECT_LT(good.first, cheap.first / 2);
    EXPECT_LT(cheap.first, 0.13);
  }
}

TEST(Jpda, MemoryOfACallDoesNotReachTheNext) {
  RandomStream random(67);
  Jpda jpda;
  for (int run = 0; run < 20; ++run) {
    const int n = 1 + static_cast<int>(random.below(12));
    const auto pairs = random_pairs(n, n, 0.5, random);
    EXPECT_EQ(jpda(n, n, pairs, {}).pair, joint_probabilities(n, n, pairs).pair);
  }
}

}  // namespace
}  // namespace scanfuse::associate
