#include "scanfuse/associate/packing_primal.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

namespace scanfuse::associate {
namespace {

/// Swaps columns in and out of a packing.
class Swapper {
 public:
  Swapper(const PackingCore& core, const CorePacking& packing,
          std::span<const std::int32_t> candidates)
      : core_(core), owner_(core.rows.size(), -1), near_starts_(core.rows.size() + 1, 0) {
    for (const auto j : packing.chosen) take(j);
    index(candidates);
  }

  /// Puts a column in if that, after refilling, gains weight.
  bool try_column(std::int32_t column) {
    if (is_chosen(column)) return false;
    find_owners(column);
    double gain = weight(column);
    for (const auto out : removed_) gain -= weight(out);
    for (const auto out : removed_) drop(out);
    take(column);
    added_.assign(1, column);
    gain += refill();
    if (gain > 1e-12 * weight(column)) return true;
    for (const auto in : added_) drop(in);
    for (const auto out : removed_) take(out);
    return false;
  }

  [[nodiscard]] CorePacking packing() const {
    CorePacking result;
    for (std::size_t i = 0; i < owner_.size(); ++i) {
      if (owner_[i] >= 0) result.chosen.push_back(owner_[i]);
    }
    std::ranges::sort(result.chosen);
    const auto repeated = std::ranges::unique(result.chosen);
    result.chosen.erase(repeated.begin(), repeated.end());
    for (const auto j : result.chosen) result.weight += weight(j);
    return result;
  }

 private:
  [[nodiscard]] double weight(std::int32_t j) const {
    return core_.weights[static_cast<std::size_t>(j)];
  }
  [[nodiscard]] std::span<const std::int32_t> rows(std::int32_t j) const {
    return core_.column(static_cast<std::size_t>(j));
  }
  [[nodiscard]] bool is_chosen(std::int32_t j) const {
    return owner_[static_cast<std::size_t>(rows(j)[0])] == j;
  }
  void take(std::int32_t j) {
    for (const auto row : rows(j)) owner_[static_cast<std::size_t>(row)] = j;
  }
  void drop(std::int32_t j) {
    for (const auto row : rows(j)) owner_[static_cast<std::size_t>(row)] = -1;
  }
  [[nodiscard]] bool fits(std::int32_t j) const {
    return std::ranges::all_of(rows(j),
                               [&](auto row) { return owner_[static_cast<std::size_t>(row)] < 0; });
  }

  /// The chosen columns that stand in the way of one.
  void find_owners(std::int32_t j) {
    removed_.clear();
    for (const auto row : rows(j)) {
      const auto owner = owner_[static_cast<std::size_t>(row)];
      if (owner >= 0 && std::ranges::find(removed_, owner) == removed_.end()) {
        removed_.push_back(owner);
      }
    }
  }

  /// Candidates of each row, in their order.
  void index(std::span<const std::int32_t> candidates) {
    for (const auto j : candidates) {
      for (const auto row : rows(j)) ++near_starts_[static_cast<std::size_t>(row) + 1];
    }
    std::partial_sum(near_starts_.begin(), near_starts_.end(), near_starts_.begin());
    near_.resize(near_starts_.back());
    auto next = near_starts_;
    for (const auto j : candidates) {
      for (const auto row : rows(j)) near_[next[static_cast<std::size_t>(row)]++] = j;
    }
  }

  /// Fills rows that the removed columns have left; the weight gained.
  double refill() {
    double gained = 0;
    for (const auto out : removed_) {
      for (const auto left : rows(out)) {
        const auto row = static_cast<std::size_t>(left);
        if (owner_[row] < 0) gained += fill(row);
      }
    }
    return gained;
  }

  double fill(std::size_t row) {
    for (auto k = near_starts_[row]; k < near_starts_[row + 1]; ++k) {
      const auto j = near_[k];
      if (!fits(j)) continue;
      take(j);
      added_.push_back(j);
      return weight(j);
    }
    return 0;
  }

  const PackingCore& core_;
  std::vector<std::int32_t> owner_;  ///< chosen column by row, -1: none
  std::vector<std::size_t> near_starts_;
  std::vector<std::int32_t> near_;
  std::vector<std::int32_t> removed_, added_;
};

}  // namespace

CorePacking greedy_packing(const PackingCore& core, std::span<const std::int32_t> order) {
  CorePacking result;
  std::vector<char> used(core.rows.size(), 0);
  for (const auto j : order) {
    const auto rows = core.column(static_cast<std::size_t>(j));
    if (std::ranges::any_of(rows, [&](auto row) { return used[static_cast<std::size_t>(row)]; })) {
      continue;
    }
    for (const auto row : rows) used[static_cast<std::size_t>(row)] = 1;
    result.chosen.push_back(j);
  }
  std::ranges::sort(result.chosen);
  for (const auto j : result.chosen) result.weight += core.weights[static_cast<std::size_t>(j)];
  return result;
}

std::vector<std::int32_t> by_weight(const PackingCore& core) {
  std::vector<std::int32_t> order(core.columns.size());
  std::iota(order.begin(), order.end(), 0);
  std::ranges::sort(
      order, {}, [&](auto j) { return std::pair{-core.weights[static_cast<std::size_t>(j)], j}; });
  return order;
}

std::vector<std::int32_t> by_reduced_cost(std::span<const double> costs, double most) {
  std::vector<std::int32_t> order;
  for (std::size_t j = 0; j < costs.size(); ++j) {
    if (costs[j] <= most) order.push_back(static_cast<std::int32_t>(j));
  }
  std::ranges::sort(order, {},
                    [&](auto j) { return std::pair{costs[static_cast<std::size_t>(j)], j}; });
  return order;
}

CorePacking improved_packing(const PackingCore& core, const CorePacking& packing,
                             std::span<const std::int32_t> candidates) {
  Swapper swapper(core, packing, candidates);
  constexpr int kRounds = 20;
  bool better = true;
  for (int round = 0; better && round < kRounds; ++round) {
    better = false;
    for (const auto j : candidates) better = swapper.try_column(j) || better;
  }
  auto result = swapper.packing();
  return result.weight > packing.weight ? result : packing;
}

}  // namespace scanfuse::associate
