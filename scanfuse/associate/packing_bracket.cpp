#include "scanfuse/associate/packing_bracket.hpp"

#include <algorithm>
#include <tuple>
#include <utility>

#include "scanfuse/associate/packing_prices.hpp"
#include "scanfuse/associate/packing_primal.hpp"

namespace scanfuse::associate {
namespace {

constexpr double kClosed = 1e-11;       ///< a gap of this share of the bound is none
constexpr std::size_t kCandidates = 3;  ///< of local search, by row of the core

void offer(const PackingCore& core, Bracket& bracket, std::span<const std::int32_t> order) {
  auto packing = improved_packing(core, greedy_packing(core, order), order);
  if (packing.weight <= bracket.best.weight) return;
  bracket.best = std::move(packing);
  bracket.threshold = std::max(bracket.threshold, bracket.best.weight);
}

}  // namespace

bool Bracket::closed() const { return gap() <= kClosed * dual; }

Bracket open_bracket(const PackingCore& core, std::vector<double> prices,
                     std::span<const std::int32_t> start, double threshold) {
  Bracket bracket;
  bracket.prices = feasible_prices(core, prices.empty() ? even_prices(core) : std::move(prices));
  bracket.dual = total(bracket.prices);
  bracket.best.chosen.assign(start.begin(), start.end());
  for (const auto j : start) bracket.best.weight += core.weights[static_cast<std::size_t>(j)];
  auto greedy = greedy_packing(core, by_weight(core));
  if (greedy.weight > bracket.best.weight) bracket.best = std::move(greedy);
  bracket.threshold = std::max(threshold, bracket.best.weight);
  return bracket;
}

Bracket with_prices(const PackingCore& core, Bracket bracket, std::span<const double> prices) {
  auto feasible = feasible_prices(core, {prices.begin(), prices.end()});
  const double dual = total(feasible);
  if (dual >= bracket.dual) return bracket;
  bracket.dual = dual;
  bracket.prices = std::move(feasible);
  return bracket;
}

Bracket with_packings(const PackingCore& core, Bracket bracket) {
  const auto costs = reduced_costs(core, bracket.prices);
  auto order = by_reduced_cost(costs, bracket.gap());
  order.resize(std::min(order.size(), kCandidates * core.rows.size()));
  offer(core, bracket, order);
  std::ranges::sort(order, {}, [&](auto column) {
    const auto j = static_cast<std::size_t>(column);
    return std::tuple{-bracket.shares[j], costs[j], column};
  });
  offer(core, bracket, order);
  return bracket;
}

std::vector<char> worth_keeping(const PackingCore& core, const Bracket& bracket) {
  std::vector<char> kept(core.columns.size(), 0);
  for (std::size_t j = 0; j < kept.size(); ++j) {
    const double cost = reduced_cost(core, bracket.prices, j);
    kept[j] = bracket.dual - cost > bracket.threshold ? 1 : 0;
  }
  return kept;
}

}  // namespace scanfuse::associate
