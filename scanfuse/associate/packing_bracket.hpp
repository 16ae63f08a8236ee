#pragma once

#include <cstdint>
#include <numeric>
#include <span>
#include <vector>

#include "scanfuse/associate/packing_core.hpp"

namespace scanfuse::associate {

[[nodiscard]] inline double total(std::span<const double> values) {
  return std::accumulate(values.begin(), values.end(), 0.0);
}

/// Prices and a packing of a part, and how far apart they are.
struct Bracket {
  std::vector<double> prices;  ///< feasible
  double dual = 0;
  CorePacking best;
  double threshold = 0;        ///< the most of best and what was asked for
  std::vector<double> shares;  ///< a fractional packing, empty where none is known

  [[nodiscard]] double gap() const { return dual - threshold; }
  [[nodiscard]] bool closed() const;
};

/// A bracket from feasible or no prices (empty), a packing, and the greedy one.
[[nodiscard]] Bracket open_bracket(const PackingCore& core, std::vector<double> prices,
                                   std::span<const std::int32_t> start, double threshold);

/// Takes over prices, made feasible, where their sum is less.
[[nodiscard]] Bracket with_prices(const PackingCore& core, Bracket bracket,
                                  std::span<const double> prices);

/// Tries packings led by reduced costs and by the shares.
[[nodiscard]] Bracket with_packings(const PackingCore& core, Bracket bracket);

/// 1 for columns that a packing better than the threshold may hold.
[[nodiscard]] std::vector<char> worth_keeping(const PackingCore& core, const Bracket& bracket);

}  // namespace scanfuse::associate
