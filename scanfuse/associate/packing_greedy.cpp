#include <numeric>
#include <utility>

#include "scanfuse/associate/packing.hpp"
#include "scanfuse/associate/packing_core.hpp"
#include "scanfuse/associate/packing_prices.hpp"
#include "scanfuse/associate/packing_primal.hpp"

namespace scanfuse::associate {
namespace {

/// One component: columns from the heaviest on; even prices, lowered where they can be.
void append_greedy(PackingSolution& solution, const PackingCore& core) {
  const auto packing = greedy_packing(core, by_weight(core));
  auto prices = feasible_prices(core, even_prices(core));
  const double dual = std::accumulate(prices.begin(), prices.end(), 0.0);
  ProofStep step;
  step.columns = core.columns;
  step.rows = core.rows;
  step.prices = std::move(prices);
  PackingComponent component{core.rows, core.columns, packing.weight, dual};
  component.proof = static_cast<std::int32_t>(solution.proof.size());
  solution.proof.push_back(std::move(step));
  solution.components.push_back(std::move(component));
  for (const auto j : packing.chosen) {
    solution.chosen.push_back(core.columns[static_cast<std::size_t>(j)]);
  }
}

}  // namespace

Result<PackingSolution> GreedyPacking::operator()(const Packing& packing) const {
  if (auto fine = check_packing(packing); !fine) return tl::unexpected(fine.error());
  const auto whole = core_of(packing);
  PackingSolution solution;
  for (const auto& core : split_core(whole, std::vector<char>(whole.columns.size(), 1))) {
    append_greedy(solution, core);
  }
  finish_solution(solution);
  return solution;
}

}  // namespace scanfuse::associate
