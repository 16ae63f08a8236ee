#include "scanfuse/core/assignment.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "scanfuse/core/random.hpp"

namespace scanfuse {
namespace {

constexpr double kForbidden = std::numeric_limits<double>::infinity();

struct Outcome {
  int pairs = 0;
  double sum = 0;
  [[nodiscard]] bool better_than(const Outcome& other) const {
    return pairs != other.pairs ? pairs > other.pairs : sum < other.sum;
  }
};

Outcome best_by_trying_all(const Eigen::MatrixXd& cost, int row, unsigned used) {
  if (row == cost.rows()) return {};
  Outcome best = best_by_trying_all(cost, row + 1, used);
  for (int column = 0; column < cost.cols(); ++column) {
    if ((used >> column & 1U) != 0 || !std::isfinite(cost(row, column))) continue;
    Outcome rest = best_by_trying_all(cost, row + 1, used | 1U << column);
    rest.pairs += 1;
    rest.sum += cost(row, column);
    if (rest.better_than(best)) best = rest;
  }
  return best;
}

Outcome outcome_of(const Eigen::MatrixXd& cost, const std::vector<int>& columns) {
  Outcome outcome;
  std::vector<bool> used(cost.cols(), false);
  for (int row = 0; row < cost.rows(); ++row) {
    if (columns[row] < 0) continue;
    EXPECT_FALSE(used[columns[row]]) << "column taken twice";
    used[columns[row]] = true;
    outcome.pairs += 1;
    outcome.sum += cost(row, columns[row]);
  }
  return outcome;
}

Eigen::MatrixXd random_costs(RandomStream& random, int rows, int columns, double forbidden_share) {
  Eigen::MatrixXd cost(rows, columns);
  for (double& c : cost.reshaped()) {
    c = random.chance(forbidden_share) ? kForbidden : random.uniform(-50, 50);
  }
  return cost;
}

TEST(SolveAssignment, EqualsTryingAllPairings) {
  RandomStream random(7);
  for (int trial = 0; trial < 400; ++trial) {
    const int rows = 1 + static_cast<int>(random.below(6));
    const int columns = 1 + static_cast<int>(random.below(6));
    const auto cost = random_costs(random, rows, columns, 0.2 * random.below(5));
    const Outcome found = outcome_of(cost, solve_assignment(cost));
    const Outcome best = best_by_trying_all(cost, 0, 0);
    ASSERT_EQ(found.pairs, best.pairs) << cost;
    ASSERT_NEAR(found.sum, best.sum, 1e-9) << cost;
  }
}

TEST(SolveAssignment, EqualsTryingAllPairingsWhenCostsTie) {
  RandomStream random(8);
  for (int trial = 0; trial < 200; ++trial) {
    Eigen::MatrixXd cost(5, 4);
    for (double& c : cost.reshaped()) c = static_cast<double>(random.below(3));
    EXPECT_NEAR(outcome_of(cost, solve_assignment(cost)).sum, best_by_trying_all(cost, 0, 0).sum,
                1e-9);
  }
}

TEST(SolveAssignment, SumDoesNotChangeWhenTransposed) {
  RandomStream random(9);
  for (int trial = 0; trial < 50; ++trial) {
    const auto cost = random_costs(random, 30, 20, 0.7);
    const Eigen::MatrixXd turned = cost.transpose();
    const Outcome a = outcome_of(cost, solve_assignment(cost));
    const Outcome b = outcome_of(turned, solve_assignment(turned));
    EXPECT_EQ(a.pairs, b.pairs);
    EXPECT_NEAR(a.sum, b.sum, 1e-9);
  }
}

TEST(SolveAssignment, LeavesRowsFreeWhereAllIsForbidden) {
  const auto columns = solve_assignment(Eigen::MatrixXd::Constant(3, 2, kForbidden));
  EXPECT_EQ(columns, std::vector<int>(3, -1));
}

TEST(SolveAssignment, OfNothingIsNothing) {
  EXPECT_TRUE(solve_assignment(Eigen::MatrixXd(0, 5)).empty());
  EXPECT_EQ(solve_assignment(Eigen::MatrixXd(4, 0)), std::vector<int>(4, -1));
}

TEST(SolveAssignment, TreatsNotANumberAsForbidden) {
  Eigen::MatrixXd cost(1, 2);
  cost << std::numeric_limits<double>::quiet_NaN(), 3;
  EXPECT_EQ(solve_assignment(cost), std::vector<int>{1});
}

TEST(SolveAssignment, StandsExtremeCosts) {
  Eigen::MatrixXd cost(2, 2);
  cost << 1e308, -1e308, -1e308, 1e308;
  EXPECT_EQ(solve_assignment(cost), (std::vector<int>{1, 0}));
}

}  // namespace
}  // namespace scanfuse
