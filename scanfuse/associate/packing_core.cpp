#include "scanfuse/associate/packing_core.hpp"

#include <algorithm>
#include <cmath>

#include "scanfuse/core/disjoint_sets.hpp"

namespace scanfuse::associate {
namespace {

/// Fills the lists of columns by row.
void index_rows(PackingCore& core) {
  core.row_starts.assign(core.rows.size() + 1, 0);
  for (const auto row : core.members) ++core.row_starts[static_cast<std::size_t>(row) + 1];
  for (std::size_t i = 0; i < core.rows.size(); ++i) core.row_starts[i + 1] += core.row_starts[i];
  auto next = core.row_starts;
  core.row_columns.resize(core.members.size());
  for (std::size_t j = 0; j < core.columns.size(); ++j) {
    for (const auto row : core.column(j)) {
      core.row_columns[next[static_cast<std::size_t>(row)]++] = static_cast<std::int32_t>(j);
    }
  }
}

/// Which part each row of a core goes to, numbered by first rows; -1: rows of no kept column.
struct Parts {
  std::vector<std::int32_t> of_row;
  std::size_t count = 0;
};

Parts connected_parts(const PackingCore& core, std::span<const char> kept) {
  DisjointSets sets;
  sets.reset(core.rows.size());
  std::vector<char> touched(core.rows.size(), 0);
  for (std::size_t j = 0; j < core.columns.size(); ++j) {
    if (!kept[j]) continue;
    const auto rows = core.column(j);
    for (const auto row : rows) {
      touched[static_cast<std::size_t>(row)] = 1;
      sets.join(static_cast<std::uint32_t>(rows[0]), static_cast<std::uint32_t>(row));
    }
  }
  Parts parts{std::vector<std::int32_t>(core.rows.size(), -1)};
  for (std::uint32_t i = 0; i < core.rows.size(); ++i) {
    if (!touched[i]) continue;
    const auto root = sets.find(i);  // the smallest row of its set
    if (root == i) parts.of_row[i] = static_cast<std::int32_t>(parts.count++);
    parts.of_row[i] = parts.of_row[root];
  }
  return parts;
}

void append_column(PackingCore& part, const PackingCore& core, std::size_t j,
                   std::span<const std::int32_t> new_row) {
  if (part.starts.empty()) part.starts.push_back(0);
  part.columns.push_back(core.columns[j]);
  part.weights.push_back(core.weights[j]);
  for (const auto row : core.column(j)) {
    part.members.push_back(new_row[static_cast<std::size_t>(row)]);
  }
  part.starts.push_back(static_cast<std::uint32_t>(part.members.size()));
}

}  // namespace

PackingCore core_of(const Packing& packing) {
  std::vector<std::int32_t> new_row(packing.rows(), -1);
  for (std::size_t j = 0; j < packing.columns(); ++j) {
    if (!(packing.weights[j] > 0)) continue;
    for (const auto row : packing.column(j)) new_row[static_cast<std::size_t>(row)] = 0;
  }
  PackingCore core;
  for (std::size_t i = 0; i < packing.rows(); ++i) {
    if (new_row[i] < 0) continue;
    new_row[i] = static_cast<std::int32_t>(core.rows.size());
    core.rows.push_back(static_cast<std::int32_t>(i));
  }
  core.starts.push_back(0);
  for (std::size_t j = 0; j < packing.columns(); ++j) {
    if (!(packing.weights[j] > 0)) continue;
    core.columns.push_back(static_cast<std::int32_t>(j));
    core.weights.push_back(packing.weights[j]);
    for (const auto row : packing.column(j)) {
      core.members.push_back(new_row[static_cast<std::size_t>(row)]);
    }
    core.starts.push_back(static_cast<std::uint32_t>(core.members.size()));
  }
  index_rows(core);
  return core;
}

std::vector<PackingCore> split_core(const PackingCore& core, std::span<const char> kept) {
  const auto parts = connected_parts(core, kept);
  std::vector<PackingCore> cores(parts.count);
  std::vector<std::int32_t> new_row(core.rows.size(), -1);
  for (std::size_t i = 0; i < core.rows.size(); ++i) {
    if (parts.of_row[i] < 0) continue;
    auto& part = cores[static_cast<std::size_t>(parts.of_row[i])];
    new_row[i] = static_cast<std::int32_t>(part.rows.size());
    part.rows.push_back(core.rows[i]);
  }
  for (std::size_t j = 0; j < core.columns.size(); ++j) {
    if (!kept[j]) continue;
    const auto first = static_cast<std::size_t>(core.members[core.starts[j]]);
    append_column(cores[static_cast<std::size_t>(parts.of_row[first])], core, j, new_row);
  }
  for (auto& part : cores) index_rows(part);
  return cores;
}

std::vector<std::int32_t> rows_within(const PackingCore& part, const PackingCore& core) {
  std::vector<std::int32_t> places;
  places.reserve(part.rows.size());
  auto at = core.rows.begin();
  for (const auto row : part.rows) {
    at = std::lower_bound(at, core.rows.end(), row);
    places.push_back(static_cast<std::int32_t>(at - core.rows.begin()));
  }
  return places;
}

std::vector<double> reduced_costs(const PackingCore& core, std::span<const double> prices) {
  std::vector<double> costs(core.columns.size());
  for (std::size_t j = 0; j < costs.size(); ++j) costs[j] = reduced_cost(core, prices, j);
  return costs;
}

void merge_diagnostics(PackingDiagnostics& sum, const PackingDiagnostics& part) {
  sum.sweeps += part.sweeps;
  sum.pivots += part.pivots;
  sum.branches += part.branches;
  sum.largest_core = std::max(sum.largest_core, part.largest_core);
  sum.out_of_time = sum.out_of_time || part.out_of_time;
  sum.out_of_nodes = sum.out_of_nodes || part.out_of_nodes;
}

void add_rounds(PackingDiagnostics& sum, std::vector<PackingRound> rounds) {
  if (rounds.empty()) return;
  const auto count = std::max(sum.rounds.size(), rounds.size());
  sum.rounds.resize(count, sum.rounds.empty() ? PackingRound{} : sum.rounds.back());
  rounds.resize(count, rounds.back());
  for (std::size_t k = 0; k < count; ++k) {
    sum.rounds[k].primal += rounds[k].primal;
    sum.rounds[k].dual += rounds[k].dual;
  }
}

void finish_solution(PackingSolution& solution) {
  std::ranges::sort(solution.chosen);
  solution.primal = solution.dual = 0;
  solution.proved = true;
  for (auto& component : solution.components) {
    component.dual = std::max(component.dual, component.primal);
    const double tolerance = 1e-9 * std::max(1.0, std::abs(component.dual));
    component.proved = component.primal >= component.dual - tolerance;
    solution.proved = solution.proved && component.proved;
    solution.primal += component.primal;
    solution.dual += component.dual;
  }
}

}  // namespace scanfuse::associate
