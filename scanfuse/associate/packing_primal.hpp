#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "scanfuse/associate/packing_core.hpp"

/// Packings that are good, not proved so.
namespace scanfuse::associate {

/// Takes columns in the order given where their rows are still free.
[[nodiscard]] CorePacking greedy_packing(const PackingCore& core,
                                         std::span<const std::int32_t> order);

/// Columns from the heaviest on; ties: the lower one first.
[[nodiscard]] std::vector<std::int32_t> by_weight(const PackingCore& core);

/// Columns whose reduced cost is at most `most`, from the least on; ties: the lower one first.
[[nodiscard]] std::vector<std::int32_t> by_reduced_cost(std::span<const double> costs, double most);

/// Local search: a candidate is put in, the chosen columns in its way are taken out, and the rows
/// they leave are filled again from the candidates, in their order; kept where the weight grows.
/// Until no candidate does any good.
[[nodiscard]] CorePacking improved_packing(const PackingCore& core, const CorePacking& packing,
                                           std::span<const std::int32_t> candidates);

}  // namespace scanfuse::associate
