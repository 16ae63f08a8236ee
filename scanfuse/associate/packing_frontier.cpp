#include "scanfuse/associate/packing_frontier.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>

#include "scanfuse/associate/log_sums.hpp"

namespace scanfuse::associate {
namespace {

constexpr int kSlots = 256;

FrontierKey bit_of_slot(int slot) {
  FrontierKey key{};
  key[static_cast<std::size_t>(slot / 64)] = std::uint64_t{1} << (slot % 64);
  return key;
}
bool overlap(const FrontierKey& a, const FrontierKey& b) {
  return ((a[0] & b[0]) | (a[1] & b[1]) | (a[2] & b[2]) | (a[3] & b[3])) != 0;
}
FrontierKey with(FrontierKey a, const FrontierKey& b) {
  for (std::size_t i = 0; i < a.size(); ++i) a[i] |= b[i];
  return a;
}
FrontierKey without(FrontierKey a, const FrontierKey& b) {
  for (std::size_t i = 0; i < a.size(); ++i) a[i] &= ~b[i];
  return a;
}

/// Rows in the order in which a search in breadth meets them.
std::vector<std::size_t> in_breadth(const PackingCore& core, std::size_t start) {
  std::vector<std::size_t> order;
  std::vector<char> seen(core.rows.size(), 0), done(core.columns.size(), 0);
  const auto visit = [&](std::size_t row) {
    if (!std::exchange(seen[row], 1)) order.push_back(row);
  };
  for (std::size_t root = 0; root < core.rows.size(); ++root) {
    visit(root == 0 ? start : root - 1 < start ? root - 1 : root);
    for (std::size_t k = order.size() - 1; k < order.size(); ++k) {
      for (const auto j : core.row(order[k])) {
        if (std::exchange(done[static_cast<std::size_t>(j)], 1)) continue;
        for (const auto row : core.column(static_cast<std::size_t>(j))) {
          visit(static_cast<std::size_t>(row));
        }
      }
    }
  }
  return order;
}

}  // namespace

Frontier::Frontier(const PackingCore& core, std::span<const double> prices) {
  if (core.rows.empty()) return;
  order_ = in_breadth(core, in_breadth(core, 0).back());
  place_slots(core, prices);
}

/// Gives each row a bit from when a column first speaks of it until its own turn has come.
void Frontier::place_slots(const PackingCore& core, std::span<const double> prices) {
  std::vector<std::size_t> level(order_.size());
  for (std::size_t k = 0; k < order_.size(); ++k) level[order_[k]] = k;
  options_.resize(order_.size());
  for (std::size_t j = 0; j < core.columns.size(); ++j) {
    std::size_t first = order_.size();
    for (const auto row : core.column(j)) {
      first = std::min(first, level[static_cast<std::size_t>(row)]);
    }
    options_[first].push_back(
        {static_cast<std::int32_t>(j), {}, std::max(0.0, reduced_cost(core, prices, j))});
  }
  std::vector<int> slot(order_.size(), -1), open;
  for (int s = kSlots; s-- > 0;) open.push_back(s);
  const auto bit = [&](std::size_t row) {
    if (slot[row] < 0 && open.empty()) fits_ = false;
    if (!fits_) return FrontierKey{};
    if (slot[row] < 0) slot[row] = open.back(), open.pop_back();
    return bit_of_slot(slot[row]);
  };
  for (std::size_t k = 0; k < order_.size() && fits_; ++k) {
    own_.push_back(bit(order_[k]));
    free_loss_.push_back(prices[order_[k]]);
    for (auto& option : options_[k]) {
      for (const auto row : core.column(static_cast<std::size_t>(option.column))) {
        option.rows = with(option.rows, bit(static_cast<std::size_t>(row)));
      }
    }
    if (fits_) open.push_back(slot[order_[k]]);
  }
}

std::vector<Frontier::Move> Frontier::moves(std::size_t level, std::span<const FrontierKey> states,
                                            std::span<const double> losses, double cut) const {
  std::vector<Move> result;
  for (std::uint32_t s = 0; s < states.size(); ++s) {
    if (overlap(states[s], own_[level])) {
      result.push_back({without(states[s], own_[level]), s, -1, 0});
      continue;
    }
    if (losses[s] + free_loss_[level] <= cut)
      result.push_back({states[s], s, -1, free_loss_[level]});
    for (const auto& option : options_[level]) {
      if (overlap(states[s], option.rows) || losses[s] + option.loss > cut) continue;
      result.push_back(
          {without(with(states[s], option.rows), own_[level]), s, option.column, option.loss});
    }
  }
  std::ranges::sort(result, {},
                    [](const Move& move) { return std::tie(move.to, move.from, move.column); });
  return result;
}

namespace {

/// The sums from the left, level by level, with the moves that made them.
class Summation {
 public:
  Summation(const Frontier& frontier, const FrontierLimits& limits)
      : frontier_(frontier), limits_(limits) {}

  bool forward() {
    std::vector<FrontierKey> states{FrontierKey{}};
    std::vector<double> least{0.0};
    sums_.push_back({0.0});
    for (std::size_t level = 0; level < frontier_.levels(); ++level) {
      moves_.push_back(frontier_.moves(level, states, least, limits_.cut));
      total_moves_ += moves_.back().size();
      if (total_moves_ > limits_.moves) return false;
      join(states, least);
      if (states.size() > limits_.states) return false;
    }
    return !states.empty();
  }

  FrontierSum backward(std::size_t columns) const {
    FrontierSum result{sums_.back()[0], std::vector<double>(columns, 0.0)};
    std::vector<double> ahead{0.0};
    for (std::size_t level = frontier_.levels(); level-- > 0;) {
      std::vector<double> before(sums_[level].size(), kNever);
      for (std::size_t k = 0; k < moves_[level].size(); ++k) {
        const auto& move = moves_[level][k];
        const double rest = ahead[targets_[level][k]] - move.loss;
        before[move.from] = log_add(before[move.from], rest);
        if (move.column < 0) continue;
        result.shares[static_cast<std::size_t>(move.column)] +=
            std::exp(sums_[level][move.from] + rest - result.log_total);
      }
      ahead = std::move(before);
    }
    return result;
  }

 private:
  /// Makes the states that the last moves lead to.
  void join(std::vector<FrontierKey>& states, std::vector<double>& least) {
    std::vector<FrontierKey> new_states;
    std::vector<double> new_least, sums;
    targets_.emplace_back();
    for (const auto& move : moves_.back()) {
      const double loss = least[move.from] + move.loss;
      const double sum = sums_.back()[move.from] - move.loss;
      if (new_states.empty() || new_states.back() != move.to) {
        new_states.push_back(move.to);
        new_least.push_back(loss);
        sums.push_back(sum);
      } else {
        new_least.back() = std::min(new_least.back(), loss);
        sums.back() = log_add(sums.back(), sum);
      }
      targets_.back().push_back(static_cast<std::uint32_t>(new_states.size() - 1));
    }
    states = std::move(new_states);
    least = std::move(new_least);
    sums_.push_back(std::move(sums));
  }

  const Frontier& frontier_;
  FrontierLimits limits_;
  std::vector<std::vector<double>> sums_;  ///< by level and state: ln of the sum from the left
  std::vector<std::vector<Frontier::Move>> moves_;
  std::vector<std::vector<std::uint32_t>> targets_;
  std::size_t total_moves_ = 0;
};

/// The few best ways into each state.
class Ranking {
 public:
  Ranking(const Frontier& frontier, std::size_t count, const FrontierLimits& limits)
      : frontier_(frontier), count_(count), limits_(limits) {}

  FrontierRanking run() {
    std::vector<FrontierKey> states{FrontierKey{}};
    ways_.push_back({{Way{}}});
    for (std::size_t level = 0; level < frontier_.levels(); ++level) {
      std::vector<double> least;
      for (const auto& ways : ways_.back()) least.push_back(ways[0].loss);
      states = advance(frontier_.moves(level, states, least, limits_.cut));
    }
    FrontierRanking result;
    result.complete = complete_;
    if (states.empty()) return result;
    for (std::uint32_t rank = 0; rank < ways_.back()[0].size(); ++rank) {
      result.packings.push_back(trace(rank));
    }
    return result;
  }

 private:
  struct Way {
    double loss = 0;
    std::uint32_t from = 0, rank = 0;  ///< the state before, and which of its ways
    std::int32_t column = -1;
  };

  std::vector<FrontierKey> advance(const std::vector<Frontier::Move>& moves) {
    std::vector<FrontierKey> states;
    std::vector<std::vector<Way>> ways;
    for (const auto& move : moves) {
      if (states.empty() || states.back() != move.to) {
        states.push_back(move.to);
        ways.emplace_back();
      }
      const auto& before = ways_.back()[move.from];
      for (std::uint32_t rank = 0; rank < before.size(); ++rank) {
        const double loss = before[rank].loss + move.loss;
        if (loss > limits_.cut) break;
        ways.back().push_back({loss, move.from, rank, move.column});
      }
    }
    for (auto& list : ways) {
      std::ranges::sort(list, {}, [](const Way& way) {
        return std::tie(way.loss, way.from, way.rank, way.column);
      });
      if (list.size() > count_) list.resize(count_);
    }
    return keep_best(states, std::move(ways));
  }

  /// Leaves out states beyond the limit, those of greatest least loss.
  std::vector<FrontierKey> keep_best(const std::vector<FrontierKey>& states,
                                     std::vector<std::vector<Way>> ways) {
    std::vector<std::size_t> kept(states.size());
    std::iota(kept.begin(), kept.end(), std::size_t{0});
    if (kept.size() > limits_.states) {
      complete_ = false;
      std::ranges::sort(kept, {}, [&](std::size_t s) { return std::pair{ways[s][0].loss, s}; });
      kept.resize(limits_.states);
      std::ranges::sort(kept);
    }
    std::vector<FrontierKey> result;
    ways_.emplace_back();
    for (const auto s : kept) {
      result.push_back(states[s]);
      ways_.back().push_back(std::move(ways[s]));
    }
    return result;
  }

  [[nodiscard]] RankedPacking trace(std::uint32_t rank) const {
    RankedPacking packing;
    packing.loss = ways_.back()[0][rank].loss;
    std::uint32_t state = 0;
    for (std::size_t level = frontier_.levels(); level > 0; --level) {
      const auto& way = ways_[level][state][rank];
      if (way.column >= 0) packing.chosen.push_back(way.column);
      state = way.from;
      rank = way.rank;
    }
    std::ranges::sort(packing.chosen);
    return packing;
  }

  const Frontier& frontier_;
  std::size_t count_;
  FrontierLimits limits_;
  std::vector<std::vector<std::vector<Way>>> ways_;  ///< by level and state, from the least loss on
  bool complete_ = true;
};

}  // namespace

std::optional<FrontierSum> sum_packings(const PackingCore& core, std::span<const double> prices,
                                        const FrontierLimits& limits) {
  const Frontier frontier(core, prices);
  if (!frontier.fits()) return std::nullopt;
  Summation summation(frontier, limits);
  if (!summation.forward()) return std::nullopt;
  return summation.backward(core.columns.size());
}

FrontierRanking rank_packings(const PackingCore& core, std::span<const double> prices,
                              std::size_t count, const FrontierLimits& limits) {
  const Frontier frontier(core, prices);
  if (!frontier.fits()) return {{}, false};
  return Ranking(frontier, count, limits).run();
}

}  // namespace scanfuse::associate
