#include "scanfuse/associate/packing.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <numeric>
#include <string>
#include <vector>

#include "associate/packing_instances.hpp"
#include "associate/packing_scenes.hpp"

namespace scanfuse::associate {
namespace {

using instances::solved;
using instances::Weights;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

/// Random packings of every kind of weights, 2 to 6 sets.
std::vector<Packing> many(std::uint64_t stream, int per_kind, int columns) {
  std::vector<Packing> packings;
  for (const auto kind : instances::kAllWeights) {
    for (int trial = 0; trial < per_kind; ++trial) {
      RandomStream random(static_cast<std::uint64_t>(trial), stream);
      packings.push_back(instances::random_columns(
          2 + trial % 5, 2 + static_cast<int>(random.below(5)), columns, kind, random));
    }
  }
  return packings;
}

Packing hard_scene(int targets, std::uint64_t seed) {
  RandomStream random(seed);
  auto scene = scenes::box(targets, 4, random);
  scene.noise_rad = 3e-3;
  scene.false_alarms = 5;
  return scenes::packing_of(scene, random);
}

TEST(PriceAndBranch, FindsWhatTryingAllPackingsFinds) {
  for (const auto& packing : many(1, 20, 14)) {
    const auto solution = solved(packing);
    const double best = instances::by_brute_force(packing);
    EXPECT_TRUE(solution.proved);
    EXPECT_NEAR(solution.primal, best, 1e-9 * best);
  }
}

/// Primal never falls, dual never rises, and the last round is the answer.
void expect_convergence(const PackingSolution& solution) {
  const auto& rounds = solution.diagnostics.rounds;
  const double tolerance = 1e-6 * std::max(1.0, solution.dual);
  ASSERT_FALSE(rounds.empty());
  for (std::size_t k = 1; k < rounds.size(); ++k) {
    EXPECT_GE(rounds[k].primal, rounds[k - 1].primal - tolerance);
    EXPECT_LE(rounds[k].dual, rounds[k - 1].dual + tolerance);
  }
  for (const auto& round : rounds) EXPECT_GE(round.dual, round.primal - tolerance);
  EXPECT_NEAR(rounds.back().primal, solution.primal, tolerance);
  EXPECT_NEAR(rounds.back().dual, solution.dual, tolerance);
}

TEST(PackingRounds, BringPrimalAndDualTogether) {
  auto packings = many(7, 4, 60);
  packings.push_back(hard_scene(40, 5));
  for (const auto& packing : packings) {
    expect_convergence(solved(packing));
    const auto relaxed = LagrangianPacking{}(packing);
    ASSERT_TRUE(relaxed);
    expect_convergence(*relaxed);
  }
}

TEST(PriceAndBranch, TakesNothingWhereThereIsNothing) {
  const auto solution = solved(Packing{});
  EXPECT_THAT(solution.chosen, IsEmpty());
  EXPECT_TRUE(solution.proved);
  EXPECT_EQ(solution.dual, 0);
  EXPECT_EQ(solution.gap(), 0);
}

TEST(PriceAndBranch, TakesASingleColumnIfItGains) {
  Packing packing = instances::rows_only(3, 1);
  packing.add(std::vector{0, 1, 2}, 2.5);
  EXPECT_THAT(solved(packing).chosen, ElementsAre(0));
  for (const double weight : {0.0, -1.0}) {
    packing.weights[0] = weight;
    EXPECT_THAT(solved(packing).chosen, IsEmpty());
  }
}

TEST(PriceAndBranch, LeavesRowsWithoutColumnsAlone) {
  Packing packing = instances::rows_only(2, 100);
  packing.add(std::vector{7, 103}, 1);
  const auto solution = solved(packing);
  EXPECT_THAT(solution.chosen, ElementsAre(0));
  ASSERT_EQ(solution.components.size(), 1U);
  EXPECT_THAT(solution.components[0].rows, ElementsAre(7, 103));
}

TEST(PriceAndBranch, TakesColumnsOfSixtyFourRows) {
  Packing packing = instances::rows_only(64, 2);
  std::vector<std::int32_t> first, second;
  for (std::int32_t s = 0; s < 64; ++s) {
    first.push_back(2 * s);
    second.push_back(2 * s + (s == 5 ? 0 : 1));
  }
  packing.add(first, 3);
  packing.add(second, 2);
  EXPECT_THAT(solved(packing).chosen, ElementsAre(0));
}

TEST(PriceAndBranch, OptimumGrowsWithTheScaleOfWeights) {
  for (const auto& packing : many(2, 6, 40)) {
    const auto before = solved(packing);
    for (const double scale : {1e-6, 0.3, 1e6}) {
      Packing scaled = packing;
      for (auto& w : scaled.weights) w *= scale;
      EXPECT_NEAR(solved(scaled).primal, scale * before.primal, 1e-9 * scale * before.primal);
    }
  }
}

TEST(PriceAndBranch, OrderOfColumnsDoesNotChangeTheOptimum) {
  RandomStream random(3);
  for (const auto& packing : many(3, 6, 40)) {
    std::vector<std::size_t> order(packing.columns());
    std::iota(order.begin(), order.end(), std::size_t{0});
    for (std::size_t i = order.size(); i > 1; --i) std::swap(order[i - 1], order[random.below(i)]);
    Packing shuffled;
    shuffled.set_of_row = packing.set_of_row;
    for (const auto j : order) shuffled.add(packing.column(j), packing.weights[j]);
    const double optimum = solved(packing).primal;
    EXPECT_NEAR(solved(shuffled).primal, optimum, 1e-9 * optimum);
  }
}

TEST(PriceAndBranch, OrderOfRowsDoesNotChangeTheOptimum) {
  RandomStream random(4);
  for (const auto& packing : many(4, 6, 40)) {
    std::vector<std::int32_t> place(packing.rows());
    std::iota(place.begin(), place.end(), 0);
    for (std::size_t i = place.size(); i > 1; --i) std::swap(place[i - 1], place[random.below(i)]);
    Packing renamed = packing;
    for (std::size_t i = 0; i < place.size(); ++i) {
      renamed.set_of_row[static_cast<std::size_t>(place[i])] = packing.set_of_row[i];
    }
    for (auto& row : renamed.members) row = place[static_cast<std::size_t>(row)];
    const double optimum = solved(packing).primal;
    EXPECT_NEAR(solved(renamed).primal, optimum, 1e-9 * optimum);
  }
}

TEST(PriceAndBranch, DominatedColumnsChangeNothing) {
  for (auto packing : many(5, 6, 40)) {
    const double optimum = solved(packing).primal;
    const std::size_t columns = packing.columns();
    for (std::size_t j = 0; j < columns; j += 3) {
      const std::vector<std::int32_t> rows(packing.column(j).begin(), packing.column(j).end());
      packing.add(rows, packing.weights[j] - 0.1 * std::abs(packing.weights[j]));
    }
    EXPECT_NEAR(solved(packing).primal, optimum, 1e-9 * optimum);
  }
}

TEST(PriceAndBranch, OptimumOfTwoPackingsSideBySideIsTheSum) {
  const auto packings = many(6, 6, 30);
  for (std::size_t k = 0; k + 1 < packings.size(); ++k) {
    Packing both = packings[k];
    const auto shift = static_cast<std::int32_t>(both.rows());
    const auto& other = packings[k + 1];
    both.set_of_row.insert(both.set_of_row.end(), other.set_of_row.begin(), other.set_of_row.end());
    for (std::size_t j = 0; j < other.columns(); ++j) {
      std::vector<std::int32_t> rows(other.column(j).begin(), other.column(j).end());
      for (auto& row : rows) row += shift;
      both.add(rows, other.weights[j]);
    }
    const double sum = solved(packings[k]).primal + solved(other).primal;
    EXPECT_NEAR(solved(both).primal, sum, 1e-9 * sum);
  }
}

TEST(PriceAndBranch, AnyNumberOfThreadsGivesTheSameBytes) {
  const auto packing = hard_scene(300, 1);
  const auto one = solved(packing, 1);
  for (const int threads : {2, 3, 8}) {
    const auto more = solved(packing, threads);
    EXPECT_EQ(one.chosen, more.chosen);
    EXPECT_EQ(one.primal, more.primal);
    EXPECT_EQ(one.dual, more.dual);
    ASSERT_EQ(one.proof.size(), more.proof.size());
    for (std::size_t k = 0; k < one.proof.size(); ++k) {
      EXPECT_EQ(one.proof[k].columns, more.proof[k].columns);
      EXPECT_EQ(one.proof[k].prices, more.proof[k].prices);
      EXPECT_EQ(one.proof[k].children, more.proof[k].children);
    }
  }
}

TEST(PriceAndBranch, OutOfTimeItStillGivesAPackingAndATrueBound) {
  const auto packing = hard_scene(300, 2);
  PriceAndBranch solver;
  solver.options.time_limit_s = 0;
  const auto solution = solver(packing);
  ASSERT_TRUE(solution);
  EXPECT_TRUE(check_bound(packing, *solution));
  const double optimum = solved(packing).primal;
  EXPECT_FALSE(solution->proved);
  EXPECT_TRUE(solution->diagnostics.out_of_time);
  EXPECT_GT(solution->gap(), 0);
  EXPECT_LE(solution->primal, optimum);
  EXPECT_GE(solution->dual, optimum);
}

TEST(PriceAndBranch, OutOfBranchesItSaysSo) {
  RandomStream random(5);
  const auto packing = instances::triangles(10, random);
  PriceAndBranch solver;
  solver.options.max_branches = 0;
  const auto solution = solver(packing);
  ASSERT_TRUE(solution);
  EXPECT_TRUE(check_bound(packing, *solution));
  EXPECT_TRUE(solution->diagnostics.out_of_nodes);
  EXPECT_FALSE(solution->proved);
  EXPECT_GE(solution->dual, solved(packing).primal);
}

// Every solver keeps what the checker asks for, and brackets the optimum.
class EveryPackingSolver : public testing::TestWithParam<PackingMethod> {};

TEST_P(EveryPackingSolver, BracketsTheOptimum) {
  auto packings = many(7, 12, 60);
  for (std::uint64_t seed = 0; seed < 10; ++seed) packings.push_back(hard_scene(15, seed));
  for (const auto& packing : packings) {
    const auto solution = solve_packing(GetParam(), packing);
    ASSERT_TRUE(solution) << solution.error().message;
    const auto checked = check_bound(packing, *solution);
    EXPECT_TRUE(checked) << checked.error().message;
    const double optimum = solved(packing).primal;
    EXPECT_LE(solution->primal, optimum * (1 + 1e-9));
    EXPECT_GE(solution->dual, optimum * (1 - 1e-9));
  }
}

TEST_P(EveryPackingSolver, RefusesWhatIsNoPacking) {
  const auto refuses = [](const Packing& packing, const std::string& words) {
    const auto solution = solve_packing(GetParam(), packing);
    ASSERT_FALSE(solution);
    EXPECT_THAT(solution.error().message, HasSubstr(words));
  };
  Packing good = instances::rows_only(3, 2);
  good.add(std::vector{0, 2}, 1);
  good.add(std::vector{1, 4}, 1);
  Packing bad = good;
  bad.weights[1] = std::numeric_limits<double>::quiet_NaN();
  refuses(bad, "weight of column 1 is nan");
  bad.weights[1] = std::numeric_limits<double>::infinity();
  refuses(bad, "weight of column 1 is inf");
  bad = good;
  bad.members[3] = 6;
  refuses(bad, "column 1 names row 6");
  bad.members[3] = -1;
  refuses(bad, "column 1 names row -1");
  bad = good;
  bad.members[3] = 0;
  refuses(bad, "rows 1 and 0 of one set");
  bad.members[3] = 1;
  refuses(bad, "rows 1 and 1 of one set");
  bad = good;
  bad.add(std::vector{3}, 1);
  refuses(bad, "column 2 has 1 rows");
  bad = good;
  bad.starts[1] = 5;
  refuses(bad, "starts descend");
  bad.starts.pop_back();
  refuses(bad, "do not fit");
  bad = instances::rows_only(65, 1);
  std::vector<std::int32_t> rows(65);
  std::iota(rows.begin(), rows.end(), 0);
  bad.add(rows, 1);
  refuses(bad, "has 65 rows");
}

INSTANTIATE_TEST_SUITE_P(All, EveryPackingSolver,
                         testing::Values(PackingMethod::kPriceAndBranch, PackingMethod::kLagrangian,
                                         PackingMethod::kGreedy));

TEST(LagrangianPacking, TwoSetsAreSolvedExactly) {
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    RandomStream random(seed);
    const auto packing =
        instances::random_columns(2, 6, 20, instances::kAllWeights[seed % 7], random);
    const auto solution = LagrangianPacking{}(packing);
    ASSERT_TRUE(solution);
    EXPECT_TRUE(solution->proved) << seed;
  }
}

TEST(LagrangianPacking, IsNearTheOptimumOnLinesOfTargets) {
  double lost = 0, total = 0;
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    RandomStream random(seed);
    const auto packing = scenes::packing_of(scenes::line(20, 0.5, random), random);
    const auto solution = LagrangianPacking{}(packing);
    ASSERT_TRUE(solution);
    const double optimum = solved(packing).primal;
    lost += optimum - solution->primal;
    total += optimum;
    EXPECT_LT(solution->gap(), 0.01);
  }
  EXPECT_LT(lost, 1e-3 * total);
}

TEST(GreedyPacking, TakesTheHeaviestFirst) {
  Packing packing = instances::rows_only(2, 2);
  packing.add(std::vector{0, 2}, 2);
  packing.add(std::vector{0, 3}, 3);
  packing.add(std::vector{1, 3}, 2);
  const auto solution = GreedyPacking{}(packing);
  ASSERT_TRUE(solution);
  EXPECT_THAT(solution->chosen, ElementsAre(1));
  EXPECT_THAT(solved(packing).chosen, ElementsAre(0, 2));
}

}  // namespace
}  // namespace scanfuse::associate
