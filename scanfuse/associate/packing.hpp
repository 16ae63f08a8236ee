#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <utility>
#include <vector>

#include "scanfuse/core/options.hpp"
#include "scanfuse/core/result.hpp"

/// Measurements of many sensors joined into targets: a sparse weighted set packing. Sees only
/// numbers.
namespace scanfuse::associate {

/// Rows are measurements, each of one set (its sensor). Columns are candidate tuples of 2 to 64
/// rows, at most one of each set, with a weight: what is gained over calling those rows clutter.
///
///   maximise  sum_j w_j x_j    so that  sum over columns j of row i of x_j <= 1,  x_j in {0, 1}
///
/// A row in no chosen column is clutter. Columns of weight <= 0 are never chosen. Weights are
/// logarithms where probabilities are asked for; the optimum does not care.
struct Packing {
  std::vector<std::int32_t> set_of_row;
  std::vector<std::size_t> starts{0};  ///< members of column j: [starts[j], starts[j + 1])
  std::vector<std::int32_t> members;   ///< rows
  std::vector<double> weights;         ///< by column

  [[nodiscard]] std::size_t rows() const { return set_of_row.size(); }
  [[nodiscard]] std::size_t columns() const { return weights.size(); }
  [[nodiscard]] std::span<const std::int32_t> column(std::size_t j) const {
    return std::span{members}.subspan(starts[j], starts[j + 1] - starts[j]);
  }
  void add(std::span<const std::int32_t> rows_of_column, double weight);
};

/// An error that names the column (or row) at fault: a weight that is NaN or infinite, a row out of
/// range, fewer than 2 or more than 64 rows, two rows of one set, starts that do not ascend.
[[nodiscard]] Result<void> check_packing(const Packing& packing);

/// One step of the proof that no packing of some columns weighs more than a bound.
///
/// kPrices: prices u >= 0 of rows with sum of u over each column >= its weight, so the bound is
///   D = sum u. With a threshold T it is better: a packing with a column of reduced cost
///   r = u(column) - w weighs D - r at most. Columns with D - r <= T are set aside, the others go
///   to the only child (-1: none are left): bound = max(T, the child's bound).
/// kSplit: children that share no row and hold all columns: bound = the sum of theirs.
/// kBranch: a packing holds `branch_column` or it does not. Two children: columns that share no row
///   with it (bound + its weight), and all but it; -1 where there are none, with bound 0.
struct ProofStep {
  enum class Kind : std::uint8_t { kPrices, kSplit, kBranch };
  Kind kind = Kind::kPrices;
  std::vector<std::int32_t> columns;  ///< what the claim is about
  std::vector<std::int32_t> rows;     ///< kPrices: all rows of those columns
  std::vector<double> prices;         ///< kPrices: by `rows`
  double threshold = -std::numeric_limits<double>::infinity();  ///< kPrices
  std::int32_t branch_column = -1;                              ///< kBranch
  std::vector<std::int32_t> children;                           ///< steps with smaller indices
};

/// Rows that are joined by columns of positive weight, and what is known of them.
struct PackingComponent {
  std::vector<std::int32_t> rows;     ///< ascending
  std::vector<std::int32_t> columns;  ///< of positive weight, ascending
  double primal = 0;                  ///< weight of the chosen columns
  double dual = 0;                    ///< no packing weighs more
  bool proved = false;                ///< primal >= dual - 1e-9 max(1, |dual|)
  std::int32_t proof = -1;            ///< the step that proves `dual`
};

/// How far primal and dual had come.
struct PackingRound {
  double primal = 0;
  double dual = 0;
};

/// How the answer came about.
struct PackingDiagnostics {
  std::int64_t sweeps = 0;        ///< over all rows, of price updates
  std::int64_t pivots = 0;        ///< of the simplex
  std::int64_t branches = 0;      ///< of the search tree
  std::int64_t largest_core = 0;  ///< columns of the largest part that had to be branched on
  bool out_of_time = false;
  bool out_of_nodes = false;  ///< branches, or numbers in the proof (40 million a part)
  /// Sums over the components, each after its k-th round of prices and packings (before it was cut
  /// into parts) or as it ended; none by greedy choice.
  std::vector<PackingRound> rounds;
};

/// (dual - primal) / dual, 0 where there is nothing to gain.
[[nodiscard]] double relative_gap(double primal, double dual);

struct PackingSolution {
  std::vector<std::int32_t> chosen;  ///< columns, ascending
  double primal = 0;
  double dual = 0;
  bool proved = false;  ///< every component is
  std::vector<PackingComponent> components;
  std::vector<ProofStep> proof;  ///< the certificate; see `check_bound`
  PackingDiagnostics diagnostics;

  [[nodiscard]] double gap() const { return relative_gap(primal, dual); }
};

/// Takes columns from the heaviest on (ties: the lower index). Its dual bound is what a few rounds
/// of price lowering give.
struct GreedyPacking {
  [[nodiscard]] Result<PackingSolution> operator()(const Packing& packing) const;
};

struct LagrangianOptions {
  int iterations = 200;
  double gap = 0;  ///< relative; stops when reached

  static constexpr auto fields() {
    using O = LagrangianOptions;
    return std::tuple{
        Field{"iterations", &O::iterations, 1, 100000, "subgradient steps, at most"},
        Field{"gap", &O::gap, 0.0, 1.0, "stop when (dual - primal) / dual is no more"},
    };
  }
};

/// The classic: constraints of all sets but the first two are relaxed with multipliers, what is
/// left is a 2-D assignment; multipliers follow the subgradient with Polyak's step; a packing is
/// recovered by successive 2-D assignments, set after set [Deb1997]. On sparse columns, and any
/// set may miss a target. Proves the optimum only where the relaxation has no gap.
struct LagrangianPacking {
  LagrangianOptions options;
  [[nodiscard]] Result<PackingSolution> operator()(const Packing& packing) const;
};

struct PriceAndBranchOptions {
  double time_limit_s = 60;
  int max_branches = 100000;  ///< of each component: a limit that does not depend on the machine
  int threads = 0;

  static constexpr auto fields() {
    using O = PriceAndBranchOptions;
    return std::tuple{
        Field{"time_limit_s", &O::time_limit_s, 0.0, 1e6,
              "then the best so far is returned with its gap"},
        Field{"max_branches", &O::max_branches, 0, 1000000000,
              "branches of one component, at most"},
        Field{"threads", &O::threads, 0, 1024, "0: one per core"},
    };
  }
};

/// The default. Components; in each, prices by annealed entropic ascent, a packing by greedy choice
/// on reduced costs and local search; columns that the gap rules out are set aside; components
/// again; what stays is small and gets an exact linear programme and branch and bound. The same
/// bytes on any number of threads as long as the time limit is not reached. docs/assignment.md.
struct PriceAndBranch {
  PriceAndBranchOptions options;
  [[nodiscard]] Result<PackingSolution> operator()(const Packing& packing) const;
};

enum class PackingMethod { kPriceAndBranch, kLagrangian, kGreedy };

constexpr auto choices(PackingMethod) {
  using enum PackingMethod;
  return std::array{std::pair{"price_and_branch", kPriceAndBranch},
                    std::pair{"lagrangian", kLagrangian}, std::pair{"greedy", kGreedy}};
}

/// With the options' defaults.
[[nodiscard]] Result<PackingSolution> solve_packing(PackingMethod method, const Packing& packing);

/// Verifies a solution without any of the solvers' code: the chosen columns are a packing and weigh
/// `primal`; the components cover all columns of positive weight and share no rows; every step of
/// the proof holds and none gives more than its component's `dual`; sums and `proved` are true.
/// An error says what is wrong. Tolerance: 1e-9 max(1, |dual|).
[[nodiscard]] Result<void> check_bound(const Packing& packing, const PackingSolution& solution);

}  // namespace scanfuse::associate
