#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "scanfuse/associate/packing_core.hpp"

namespace scanfuse::associate {

/// The linear programme of a small core: max w x, A x <= 1, x >= 0.
struct LinearOptimum {
  std::vector<double> prices;  ///< by row; to be made exactly feasible by `feasible_prices`
  std::vector<double> shares;  ///< x by column
  int pivots = 0;
  bool optimal = false;  ///< else: out of pivots; the prices are no bound before they are repaired
};

/// Primal simplex with the inverse of the basis, started at `start` (a packing). The right-hand
/// side is 1 + small different numbers, since packings are so degenerate that pivots would stand
/// still; the prices do not depend on it. Memory: rows^2 doubles.
[[nodiscard]] LinearOptimum solve_linear(const PackingCore& core,
                                         std::span<const std::int32_t> start, int most_pivots);

}  // namespace scanfuse::associate
