#include "scanfuse/associate/packing_posterior.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <vector>

#include "associate/packing_instances.hpp"
#include "associate/packing_scenes.hpp"

namespace scanfuse::associate {
namespace {

using instances::solved;
using instances::Weights;

/// Calls `visit` with every packing of columns of positive weight, the empty one too.
void every_packing(const Packing& packing,
                   const std::function<void(const std::vector<std::int32_t>&, double)>& visit) {
  std::vector<char> used(packing.rows(), 0);
  std::vector<std::int32_t> chosen;
  const std::function<void(std::size_t, double)> descend = [&](std::size_t from, double weight) {
    visit(chosen, weight);
    for (std::size_t j = from; j < packing.columns(); ++j) {
      const auto rows = packing.column(j);
      const auto taken = [&](auto i) { return used[static_cast<std::size_t>(i)] != 0; };
      if (!(packing.weights[j] > 0) || std::ranges::any_of(rows, taken)) continue;
      for (const auto i : rows) used[static_cast<std::size_t>(i)] = 1;
      chosen.push_back(static_cast<std::int32_t>(j));
      descend(j + 1, weight + packing.weights[j]);
      chosen.pop_back();
      for (const auto i : rows) used[static_cast<std::size_t>(i)] = 0;
    }
  };
  descend(0, 0);
}

std::vector<Packing> small_packings(std::uint64_t stream) {
  std::vector<Packing> packings;
  for (const auto kind : {Weights::kUniform, Weights::kEqual, Weights::kFewIntegers,
                          Weights::kBySize, Weights::kSigned, Weights::kTiny}) {
    for (std::uint64_t trial = 0; trial < 15; ++trial) {
      RandomStream random(trial, stream);
      const int sets = 2 + static_cast<int>(trial % 5);
      packings.push_back(instances::random_columns(sets, 2 + static_cast<int>(random.below(4)),
                                                   5 + static_cast<int>(random.below(11)), kind,
                                                   random));
    }
  }
  return packings;
}

TEST(BestPackings, AreThoseThatTryingAllFinds) {
  for (const auto& packing : small_packings(1)) {
    std::vector<double> weights;
    every_packing(packing, [&](const auto&, double weight) { weights.push_back(weight); });
    std::ranges::sort(weights, std::greater{});
    for (const int count : {1, 7, 100000}) {
      const auto ranking = best_packings(packing, solved(packing), {.count = count});
      ASSERT_TRUE(ranking) << ranking.error().message;
      EXPECT_TRUE(ranking->exact);
      const auto expected = std::min(weights.size(), static_cast<std::size_t>(count));
      ASSERT_EQ(ranking->packings.size(), expected);
      for (std::size_t k = 0; k < expected; ++k) {
        EXPECT_NEAR(ranking->packings[k].weight, weights[k], 1e-9 * std::max(1.0, weights[0]));
      }
    }
  }
}

TEST(BestPackings, AreDifferentPackings) {
  for (const auto& packing : small_packings(2)) {
    const auto ranking = best_packings(packing, solved(packing), {.count = 200});
    ASSERT_TRUE(ranking);
    std::vector<std::vector<std::int32_t>> seen;
    for (const auto& ranked : ranking->packings) {
      std::vector<char> used(packing.rows(), 0);
      for (const auto j : ranked.chosen) {
        for (const auto i : packing.column(static_cast<std::size_t>(j))) {
          EXPECT_EQ(std::exchange(used[static_cast<std::size_t>(i)], 1), 0);
        }
      }
      seen.push_back(ranked.chosen);
    }
    std::ranges::sort(seen);
    EXPECT_TRUE(std::ranges::adjacent_find(seen) == seen.end());
  }
}

TEST(BestPackings, OfALargeSceneStartWithTheOptimumAndDescend) {
  RandomStream random(4);
  auto scene = scenes::box(200, 4, random);
  scene.noise_rad = 2e-3;
  scene.false_alarms = 5;
  const auto packing = scenes::packing_of(scene, random);
  const auto solution = solved(packing);
  ASSERT_TRUE(solution.proved);
  const auto ranking = best_packings(packing, solution, {.count = 25});
  ASSERT_TRUE(ranking);
  EXPECT_TRUE(ranking->exact);
  ASSERT_EQ(ranking->packings.size(), 25U);
  EXPECT_NEAR(ranking->packings[0].weight, solution.primal, 1e-9 * solution.primal);
  for (std::size_t k = 1; k < 25; ++k) {
    EXPECT_LE(ranking->packings[k].weight, ranking->packings[k - 1].weight + 1e-9);
  }
}

// Each next packing of a scene is the optimum once the better ones are forbidden, here by brute
// force over which column of the first is left out.
TEST(BestPackings, TheSecondIsTheBestWithoutAColumnOfTheFirstOrWithOneMore) {
  RandomStream random(5);
  auto scene = scenes::box(15, 3, random);
  scene.noise_rad = 5e-3;
  scene.false_alarms = 3;
  const auto packing = scenes::packing_of(scene, random);
  const auto first = solved(packing);
  double second = 0;
  for (const auto j : first.chosen) {
    Packing without = packing;
    without.weights[static_cast<std::size_t>(j)] = 0;
    second = std::max(second, solved(without).primal);
  }
  const auto ranking = best_packings(packing, first, {.count = 2});
  ASSERT_TRUE(ranking);
  ASSERT_EQ(ranking->packings.size(), 2U);
  EXPECT_NEAR(ranking->packings[1].weight, second, 1e-9 * second);
}

TEST(PackingPosterior, IsTheShareOfAllPackings) {
  for (const auto& packing : small_packings(3)) {
    double total = 0;
    std::vector<double> column(packing.columns(), 0.0), clutter(packing.rows(), 0.0);
    every_packing(packing, [&](const auto& chosen, double weight) {
      const double share = std::exp(weight);
      total += share;
      std::vector<char> used(packing.rows(), 0);
      for (const auto j : chosen) {
        column[static_cast<std::size_t>(j)] += share;
        for (const auto i : packing.column(static_cast<std::size_t>(j))) {
          used[static_cast<std::size_t>(i)] = 1;
        }
      }
      for (std::size_t i = 0; i < used.size(); ++i) clutter[i] += used[i] ? 0 : share;
    });
    const auto posterior = packing_posterior(packing, solved(packing));
    ASSERT_TRUE(posterior) << posterior.error().message;
    for (const auto exact : posterior->exact) EXPECT_TRUE(exact);
    for (std::size_t j = 0; j < column.size(); ++j) {
      EXPECT_NEAR(posterior->column[j], column[j] / total, 1e-10);
    }
    for (std::size_t i = 0; i < clutter.size(); ++i) {
      EXPECT_NEAR(posterior->clutter[i], clutter[i] / total, 1e-10);
    }
  }
}

TEST(PackingPosterior, WeightsOfThousandsOfNatsAreFine) {
  Packing packing = instances::rows_only(2, 2);
  packing.add(std::vector{0, 2}, 5000);
  packing.add(std::vector{0, 3}, 5000 + std::log(3));
  const auto posterior = packing_posterior(packing, solved(packing));
  ASSERT_TRUE(posterior);
  EXPECT_NEAR(posterior->column[0], 0.25, 1e-9);
  EXPECT_NEAR(posterior->column[1], 0.75, 1e-9);
  EXPECT_NEAR(posterior->clutter[0], 0, 1e-9);
  EXPECT_NEAR(posterior->clutter[1], 1, 1e-9);
}

TEST(PackingPosterior, OfNothingIsClutter) {
  Packing packing = instances::rows_only(2, 3);
  packing.add(std::vector{0, 3}, -2);
  const auto posterior = packing_posterior(packing, solved(packing));
  ASSERT_TRUE(posterior);
  EXPECT_EQ(posterior->column[0], 0);
  for (const double p : posterior->clutter) EXPECT_EQ(p, 1);
}

// Where the exact count is too much, what is left out hardly matters.
TEST(PackingPosterior, NarrowLimitsChangeItLittle) {
  int narrowed = 0;
  for (std::uint64_t seed = 0; seed < 8; ++seed) {
    RandomStream random(seed, 6);
    const auto packing = scenes::packing_of(scenes::line(8, 1, random), random);
    const auto solution = solved(packing);
    const auto exact = packing_posterior(packing, solution, {.max_moves = 100000000});
    const auto narrow = packing_posterior(packing, solution, {.max_moves = 20000});
    ASSERT_TRUE(exact && narrow);
    EXPECT_TRUE(std::ranges::all_of(exact->exact, [](char e) { return e != 0; }));
    narrowed += std::ranges::any_of(narrow->exact, [](char e) { return e == 0; }) ? 1 : 0;
    for (std::size_t j = 0; j < packing.columns(); ++j) {
      EXPECT_NEAR(exact->column[j], narrow->column[j], 0.02);
    }
  }
  EXPECT_GT(narrowed, 0);
}

// Of what is said with 0.9 to 1, 97 % is right, in crowded scenes with misses and clutter too.
TEST(PackingPosterior, MeansWhatItSays) {
  int sure = 0, sure_and_right = 0, even = 0, even_and_right = 0;
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    RandomStream random(seed, 8);
    auto scene = scenes::box(20 + 20 * static_cast<int>(seed % 3), 3, random);
    scene.noise_rad = 5e-3;
    scene.false_alarms = 5;
    const auto truth = scenes::labelled(scene, random);
    const auto posterior = packing_posterior(truth.packing, solved(truth.packing));
    ASSERT_TRUE(posterior);
    for (std::size_t j = 0; j < truth.packing.columns(); ++j) {
      const double p = posterior->column[j];
      const int right = truth.is_right(j) ? 1 : 0;
      if (p >= 0.9) ++sure, sure_and_right += right;
      if (p >= 0.4 && p < 0.6) ++even, even_and_right += right;
    }
  }
  std::printf("said with 0.9 to 1: %d, right: %d; with 0.4 to 0.6: %d, right: %d\n", sure,
              sure_and_right, even, even_and_right);
  EXPECT_GE(sure_and_right, 0.97 * sure);
  EXPECT_NEAR(even_and_right, 0.5 * even, 4 * std::sqrt(0.25 * even));
}

TEST(PackingPosterior, RefusesASolutionOfAnotherPacking) {
  Packing packing = instances::rows_only(2, 2);
  packing.add(std::vector{0, 2}, 1);
  const auto solution = solved(packing);
  packing.weights[0] = 2;
  EXPECT_FALSE(packing_posterior(packing, solution));
  EXPECT_FALSE(best_packings(packing, solution));
}

}  // namespace
}  // namespace scanfuse::associate
