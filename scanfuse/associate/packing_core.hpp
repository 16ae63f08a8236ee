#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "scanfuse/associate/packing.hpp"

/// What the packing solvers share: a part of a packing with numbers of its own.
namespace scanfuse::associate {

/// Some columns of a packing and the rows they touch. Inside, rows and columns count from 0.
struct PackingCore {
  std::vector<std::int32_t> rows;         ///< their numbers in the whole packing, ascending
  std::vector<std::int32_t> columns;      ///< likewise
  std::vector<std::uint32_t> starts;      ///< by column, into members
  std::vector<std::int32_t> members;      ///< rows
  std::vector<double> weights;            ///< > 0
  std::vector<std::uint32_t> row_starts;  ///< by row, into row_columns
  std::vector<std::int32_t> row_columns;  ///< ascending in each row

  [[nodiscard]] std::span<const std::int32_t> column(std::size_t j) const {
    return std::span{members}.subspan(starts[j], starts[j + 1] - starts[j]);
  }
  [[nodiscard]] std::span<const std::int32_t> row(std::size_t i) const {
    return std::span{row_columns}.subspan(row_starts[i], row_starts[i + 1] - row_starts[i]);
  }
};

/// All columns of positive weight. The packing must have passed `check_packing`.
[[nodiscard]] PackingCore core_of(const Packing& packing);

/// The kept columns (by column: 1 or 0), fallen apart into components, by their first rows. The
/// numbers in `rows` and `columns` remain those of the whole packing.
[[nodiscard]] std::vector<PackingCore> split_core(const PackingCore& core,
                                                  std::span<const char> kept);

/// Where the part's rows stand in the core that it was split from.
[[nodiscard]] std::vector<std::int32_t> rows_within(const PackingCore& part,
                                                    const PackingCore& core);

/// sum of u over the rows of column j, less its weight
[[nodiscard]] inline double reduced_cost(const PackingCore& core, std::span<const double> prices,
                                         std::size_t j) {
  double sum = -core.weights[j];
  for (const auto row : core.column(j)) sum += prices[static_cast<std::size_t>(row)];
  return sum;
}

[[nodiscard]] std::vector<double> reduced_costs(const PackingCore& core,
                                                std::span<const double> prices);

/// Chosen columns of a core, ascending, and their weight.
struct CorePacking {
  std::vector<std::int32_t> chosen;
  double weight = 0;
};

/// All but the rounds: those of a part are no rounds of the whole.
void merge_diagnostics(PackingDiagnostics& sum, const PackingDiagnostics& part);
/// A component's rounds into the sums over components; who has fewer stays at the last.
void add_rounds(PackingDiagnostics& sum, std::vector<PackingRound> rounds);

/// Components of a whole solution from those of its parts: rows, columns, primal and dual are
/// given; sums, `proved` and the order of `chosen` are made here.
void finish_solution(PackingSolution& solution);

}  // namespace scanfuse::associate
