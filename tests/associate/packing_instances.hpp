#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "scanfuse/associate/packing.hpp"
#include "scanfuse/core/random.hpp"

/// Random packings of many kinds, all from a stream: what solvers and the checker are tested on.
namespace scanfuse::associate::instances {

/// How weights are drawn.
enum class Weights { kUniform, kEqual, kFewIntegers, kBySize, kSigned, kHuge, kTiny };

inline constexpr Weights kAllWeights[] = {
    Weights::kUniform, Weights::kEqual, Weights::kFewIntegers, Weights::kBySize,
    Weights::kSigned,  Weights::kHuge,  Weights::kTiny};

inline double draw_weight(Weights kind, std::size_t size, RandomStream& random) {
  switch (kind) {
    case Weights::kEqual:
      return 1;
    case Weights::kFewIntegers:
      return 1 + static_cast<double>(random.below(3));
    case Weights::kBySize:
      return static_cast<double>(size);
    case Weights::kSigned:
      return random.normal(2, 4);
    case Weights::kHuge:
      return 1e9 * random.uniform();
    case Weights::kTiny:
      return 1e-7 * random.uniform();
    case Weights::kUniform:
      break;
  }
  return random.uniform(0, 10);
}

/// Rows of `sets` sets in turn, `per_set` each.
inline Packing rows_only(int sets, int per_set) {
  Packing packing;
  for (int s = 0; s < sets; ++s) packing.set_of_row.insert(packing.set_of_row.end(), per_set, s);
  return packing;
}

/// Columns of at least two random rows, one of each set at most.
inline Packing random_columns(int sets, int per_set, int columns, Weights kind,
                              RandomStream& random) {
  Packing packing = rows_only(sets, per_set);
  while (static_cast<int>(packing.columns()) < columns) {
    std::vector<std::int32_t> rows;
    for (int s = 0; s < sets; ++s) {
      const auto row =
          static_cast<std::int32_t>(s * per_set + static_cast<int>(random.below(per_set)));
      if (random.chance(0.7)) rows.push_back(row);
    }
    if (rows.size() >= 2) packing.add(rows, draw_weight(kind, rows.size(), random));
  }
  return packing;
}

/// Every tuple with one row of each set: the dense assignment cube.
inline Packing cube(int sets, int per_set, Weights kind, RandomStream& random) {
  Packing packing = rows_only(sets, per_set);
  std::vector<std::int32_t> place(static_cast<std::size_t>(sets), 0);
  for (int digit = 0; digit >= 0;) {
    std::vector<std::int32_t> rows;
    for (int s = 0; s < sets; ++s) rows.push_back(s * per_set + place[static_cast<std::size_t>(s)]);
    packing.add(rows, draw_weight(kind, rows.size(), random));
    for (digit = sets - 1; digit >= 0; --digit) {
      auto& d = place[static_cast<std::size_t>(digit)];
      if (++d < per_set) break;
      d = 0;
    }
  }
  return packing;
}

/// Three columns that exclude each other in pairs, again and again: the linear programme takes half
/// of each.
inline Packing triangles(int count, RandomStream& random) {
  Packing packing = rows_only(3, count);
  for (std::int32_t t = 0; t < count; ++t) {
    const std::int32_t a = t, b = count + t, c = 2 * count + t;
    packing.add(std::vector{a, b}, 5 + random.uniform());
    packing.add(std::vector{b, c}, 5 + random.uniform());
    packing.add(std::vector{a, c}, 5 + random.uniform());
    const auto other = static_cast<std::int32_t>(random.below(static_cast<std::uint64_t>(count)));
    packing.add(std::vector{a, count + other}, 2 * random.uniform());
  }
  return packing;
}

/// The most weight, by trying all packings: for a few columns.
inline double by_brute_force(const Packing& packing, std::size_t from = 0,
                             std::vector<char> used = {}) {
  if (used.empty()) used.assign(packing.rows(), 0);
  double best = 0;
  for (std::size_t j = from; j < packing.columns(); ++j) {
    const auto rows = packing.column(j);
    if (std::ranges::any_of(rows, [&](auto i) { return used[static_cast<std::size_t>(i)]; })) {
      continue;
    }
    auto with = used;
    for (const auto i : rows) with[static_cast<std::size_t>(i)] = 1;
    best = std::max(best, packing.weights[j] + by_brute_force(packing, j + 1, with));
  }
  return best;
}

/// By the default solver, and checked.
inline PackingSolution solved(const Packing& packing, int threads = 1) {
  PriceAndBranch solver;
  solver.options.threads = threads;
  auto solution = solver(packing);
  EXPECT_TRUE(solution) << solution.error().message;
  const auto checked = check_bound(packing, *solution);
  EXPECT_TRUE(checked) << checked.error().message;
  return *solution;
}

}  // namespace scanfuse::associate::instances
