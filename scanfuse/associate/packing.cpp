#include "scanfuse/associate/packing.hpp"

#include <algorithm>
#include <cmath>

namespace scanfuse::associate {
namespace {

constexpr std::size_t kMostRows = 64;

Result<void> check_starts(const Packing& packing) {
  using enum Error::Code;
  const auto& starts = packing.starts;
  if (starts.size() != packing.columns() + 1 || starts.front() != 0 ||
      starts.back() != packing.members.size()) {
    return fail(kMalformed, "packing: {} starts and {} members do not fit {} columns",
                starts.size(), packing.members.size(), packing.columns());
  }
  for (std::size_t j = 0; j < packing.columns(); ++j) {
    if (starts[j] > starts[j + 1]) {
      return fail(kMalformed, "packing: starts descend at column {}", j);
    }
  }
  return {};
}

Result<void> check_column(const Packing& packing, std::size_t j) {
  using enum Error::Code;
  const auto rows = packing.column(j);
  if (!std::isfinite(packing.weights[j])) {
    return fail(kOutOfRange, "packing: the weight of column {} is {}, it must be finite", j,
                packing.weights[j]);
  }
  if (rows.size() < 2 || rows.size() > kMostRows) {
    return fail(kOutOfRange, "packing: column {} has {} rows, 2 to {} are allowed", j, rows.size(),
                kMostRows);
  }
  for (std::size_t a = 0; a < rows.size(); ++a) {
    if (rows[a] < 0 || static_cast<std::size_t>(rows[a]) >= packing.rows()) {
      return fail(kOutOfRange, "packing: column {} names row {}, there are {}", j, rows[a],
                  packing.rows());
    }
    const auto set = packing.set_of_row[static_cast<std::size_t>(rows[a])];
    for (std::size_t b = 0; b < a; ++b) {
      if (packing.set_of_row[static_cast<std::size_t>(rows[b])] == set) {
        return fail(kMalformed, "packing: column {} has rows {} and {} of one set, {}", j, rows[b],
                    rows[a], set);
      }
    }
  }
  return {};
}

}  // namespace

void Packing::add(std::span<const std::int32_t> rows_of_column, double weight) {
  members.insert(members.end(), rows_of_column.begin(), rows_of_column.end());
  starts.push_back(members.size());
  weights.push_back(weight);
}

Result<void> check_packing(const Packing& packing) {
  if (auto fine = check_starts(packing); !fine) return fine;
  for (std::size_t j = 0; j < packing.columns(); ++j) {
    if (auto fine = check_column(packing, j); !fine) return fine;
  }
  return {};
}

double relative_gap(double primal, double dual) { return dual > 0 ? (dual - primal) / dual : 0; }

Result<PackingSolution> solve_packing(PackingMethod method, const Packing& packing) {
  switch (method) {
    case PackingMethod::kLagrangian:
      return LagrangianPacking{}(packing);
    case PackingMethod::kGreedy:
      return GreedyPacking{}(packing);
    case PackingMethod::kPriceAndBranch:
      break;
  }
  return PriceAndBranch{}(packing);
}

}  // namespace scanfuse::associate
