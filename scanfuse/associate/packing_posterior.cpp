#include "scanfuse/associate/packing_posterior.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <tuple>
#include <utility>

#include "scanfuse/associate/packing_core.hpp"
#include "scanfuse/associate/packing_frontier.hpp"
#include "scanfuse/associate/packing_prices.hpp"

namespace scanfuse::associate {
namespace {

constexpr double kCutShrinks = 0.7;  ///< a part too large for one cut is tried with the next
constexpr double kLeastCut = 0.5;    ///< nats; smaller cuts keep the best packing and little else
constexpr std::size_t kLeastStates = 300;

/// Prices that are near the linear optimum, whatever solver made the solution, and not at a corner
/// of it: there, some rows of a column bear all of its price and others may stay free for nothing.
std::vector<double> settled_prices(const PackingCore& core, double mean_weight) {
  SoftPrices soft(core, feasible_prices(core, even_prices(core)));
  for (double share = 0.02; share > 3e-4; share /= 2) soft.sweep(share * mean_weight, 60, 0.02);
  auto prices = soft.prices();
  for (std::size_t j = 0; j < core.columns.size(); ++j) {
    const auto rows = core.column(j);
    const double lift = -reduced_cost(core, prices, j) / static_cast<double>(rows.size());
    if (lift <= 0) continue;
    for (const auto row : rows) prices[static_cast<std::size_t>(row)] += lift;
  }
  return prices;
}

/// A core, its prices, and how much the solution's packing loses against them.
struct PricedPart {
  PackingCore core;
  std::vector<double> prices;
  std::vector<char> chosen;  ///< by column: it is in the solution
  double gap = 0;
};

double gap_of(const PricedPart& part) {
  double gap = std::accumulate(part.prices.begin(), part.prices.end(), 0.0);
  for (std::size_t j = 0; j < part.chosen.size(); ++j) {
    if (part.chosen[j]) gap -= part.core.weights[j];
  }
  return std::max(0.0, gap);
}

std::vector<char> mark_chosen(const PackingCore& core, const PackingSolution& solution) {
  std::vector<char> chosen;
  chosen.reserve(core.columns.size());
  for (const auto column : core.columns) {
    chosen.push_back(std::ranges::binary_search(solution.chosen, column) ? 1 : 0);
  }
  return chosen;
}

PricedPart priced(PackingCore core, const PackingSolution& solution) {
  PricedPart part{std::move(core), {}, {}, 0};
  const auto count = std::max<std::size_t>(1, solution.chosen.size());
  part.chosen = mark_chosen(part.core, solution);
  part.prices = settled_prices(part.core, solution.primal / static_cast<double>(count));
  part.gap = gap_of(part);
  return part;
}

/// The parts that stay when columns of a greater reduced cost are left out.
std::vector<PricedPart> within(const PricedPart& whole, double cost,
                               const PackingSolution& solution) {
  std::vector<char> kept(whole.core.columns.size());
  for (std::size_t j = 0; j < kept.size(); ++j) {
    kept[j] = whole.chosen[j] || reduced_cost(whole.core, whole.prices, j) <= cost ? 1 : 0;
  }
  std::vector<PricedPart> parts;
  for (auto& core : split_core(whole.core, kept)) {
    PricedPart part{std::move(core), {}, {}, 0};
    for (const auto row : rows_within(part.core, whole.core)) {
      part.prices.push_back(whole.prices[static_cast<std::size_t>(row)]);
    }
    part.chosen = mark_chosen(part.core, solution);
    part.gap = gap_of(part);
    parts.push_back(std::move(part));
  }
  return parts;
}

/// Sums of one packing of each list, from the least loss on, `count` at most.
class Merger {
 public:
  explicit Merger(std::size_t count) : count_(count), totals_{{0, 0, 0}} {}

  void add(std::vector<RankedPacking> list) {
    std::vector<Total> sums;
    for (std::uint32_t t = 0; t < totals_.size(); ++t) {
      for (std::uint32_t k = 0; k < list.size(); ++k) {
        if ((t + std::size_t{1}) * (k + std::size_t{1}) > count_)
          break;  // that many sums are at least as good
        sums.push_back({totals_[t].loss + list[k].loss, t, k});
      }
    }
    std::ranges::sort(sums, {},
                      [](const Total& sum) { return std::tie(sum.loss, sum.before, sum.item); });
    if (sums.size() > count_) sums.resize(count_);
    history_.push_back(std::exchange(totals_, std::move(sums)));
    lists_.push_back(std::move(list));
  }

  [[nodiscard]] std::size_t size() const { return totals_.size(); }
  [[nodiscard]] double loss(std::size_t t) const { return totals_[t].loss; }

  /// Columns of the t-th sum.
  [[nodiscard]] std::vector<std::int32_t> chosen(std::size_t t) const {
    std::vector<std::int32_t> columns;
    Total total = totals_[t];
    for (std::size_t k = lists_.size(); k-- > 0;) {
      const auto& part = lists_[k][total.item].chosen;
      columns.insert(columns.end(), part.begin(), part.end());
      total = history_[k][total.before];
    }
    std::ranges::sort(columns);
    return columns;
  }

 private:
  struct Total {
    double loss;
    std::uint32_t before, item;
  };
  std::size_t count_;
  std::vector<Total> totals_;
  std::vector<std::vector<Total>> history_;
  std::vector<std::vector<RankedPacking>> lists_;  ///< columns of the whole packing
};

std::vector<RankedPacking> renumbered(const PackingCore& core, std::vector<RankedPacking> list) {
  for (auto& packing : list) {
    for (auto& j : packing.chosen) j = core.columns[static_cast<std::size_t>(j)];
  }
  return list;
}

RankedPacking solution_of(const PricedPart& part) {
  RankedPacking packing{part.gap, {}};
  for (std::size_t j = 0; j < part.chosen.size(); ++j) {
    if (part.chosen[j]) packing.chosen.push_back(static_cast<std::int32_t>(j));
  }
  return packing;
}

/// The best packings that lose at most so much; `exact` where none of those is missing.
struct Attempt {
  Merger merger;
  double constant = 0;  ///< lost by all: rows that no column kept can use
  bool exact = true;
};

Attempt attempt(const std::vector<PricedPart>& components, double most,
                const PackingSolution& solution, const RankingOptions& options) {
  const auto count = static_cast<std::size_t>(options.count);
  Attempt result{Merger(count)};
  FrontierLimits limits;
  limits.states = static_cast<std::size_t>(options.max_states);
  for (const auto& component : components) {
    result.constant += std::accumulate(component.prices.begin(), component.prices.end(), 0.0);
    for (const auto& part : within(component, most, solution)) {
      result.constant -= std::accumulate(part.prices.begin(), part.prices.end(), 0.0);
      limits.cut = std::max(most, part.gap * (1 + 1e-9));
      auto ranking = rank_packings(part.core, part.prices, count, limits);
      result.exact = result.exact && ranking.complete;
      if (ranking.packings.empty()) ranking.packings.push_back(solution_of(part));
      result.merger.add(renumbered(part.core, std::move(ranking.packings)));
    }
  }
  return result;
}

PackingRanking ranking_of(const Packing& packing, const Attempt& attempt, bool exact) {
  PackingRanking ranking;
  ranking.exact = exact;
  for (std::size_t t = 0; t < attempt.merger.size(); ++t) {
    WeighedPacking weighed{attempt.merger.chosen(t), 0};
    for (const auto j : weighed.chosen) {
      weighed.weight += packing.weights[static_cast<std::size_t>(j)];
    }
    ranking.packings.push_back(std::move(weighed));
  }
  return ranking;
}

/// Adds up the packings of a part. Where that is too much work, columns of a reduced cost above a
/// cut and states of a greater loss are left out, then those above a smaller cut. A state's loss is
/// that of the best way into it: the sum over other ways, however many, is not cut.
class Posterior {
 public:
  Posterior(const PackingSolution& solution, const PosteriorOptions& options,
            PackingPosterior& result)
      : solution_(solution), options_(options), result_(result) {}

  /// The cut that was needed, infinity for none.
  double add(const PricedPart& part, double cut) {
    FrontierLimits limits;
    limits.moves = static_cast<std::size_t>(options_.max_moves);
    limits.cut = cut + part.gap * (1 + 1e-9);
    if (const auto sum = sum_packings(part.core, part.prices, limits)) {
      for (std::size_t j = 0; j < sum->shares.size(); ++j) {
        result_.column[static_cast<std::size_t>(part.core.columns[j])] = sum->shares[j];
      }
      return cut;
    }
    const double next = std::isinf(cut) ? options_.cut : kCutShrinks * cut;
    if (next < kLeastCut) return by_ranking(part);
    double least = next;
    for (const auto& inner : within(part, next + part.gap, solution_)) {
      least = std::min(least, add(inner, next));
    }
    return least;
  }

 private:
  /// The last resort: a few of the best packings stand for all.
  double by_ranking(const PricedPart& part) {
    FrontierLimits limits;
    limits.states = kLeastStates;
    auto ranking = rank_packings(part.core, part.prices, 100, limits);
    if (ranking.packings.empty()) ranking.packings.push_back(solution_of(part));
    double total = 0;
    for (const auto& packing : ranking.packings) {
      total += std::exp(ranking.packings[0].loss - packing.loss);
    }
    for (const auto& packing : ranking.packings) {
      const double share = std::exp(ranking.packings[0].loss - packing.loss) / total;
      for (const auto j : packing.chosen) {
        const auto column = part.core.columns[static_cast<std::size_t>(j)];
        result_.column[static_cast<std::size_t>(column)] += share;
      }
    }
    return 0;
  }

  const PackingSolution& solution_;
  const PosteriorOptions& options_;
  PackingPosterior& result_;
};

std::vector<PackingCore> components_of(const Packing& packing) {
  const auto whole = core_of(packing);
  return split_core(whole, std::vector<char>(whole.columns.size(), 1));
}

/// By row: what its columns leave.
std::vector<double> clutter_of(const Packing& packing, std::span<const double> columns) {
  std::vector<double> clutter(packing.rows(), 1.0);
  for (std::size_t j = 0; j < packing.columns(); ++j) {
    for (const auto i : packing.column(j)) clutter[static_cast<std::size_t>(i)] -= columns[j];
  }
  for (auto& p : clutter) p = std::clamp(p, 0.0, 1.0);
  return clutter;
}

}  // namespace

Result<PackingRanking> best_packings(const Packing& packing, const PackingSolution& solution,
                                     const RankingOptions& options) {
  if (auto fine = check_bound(packing, solution); !fine) return tl::unexpected(fine.error());
  std::vector<PricedPart> components;
  double gap = 0, dual = 0;
  for (auto& core : components_of(packing)) {
    components.push_back(priced(std::move(core), solution));
    gap += components.back().gap;
    for (const double price : components.back().prices) dual += price;
  }
  const auto chosen = std::max<std::size_t>(1, solution.chosen.size());
  double most = gap + 0.05 * dual / static_cast<double>(chosen);
  while (true) {
    const auto tried = attempt(components, most, solution, options);
    const bool enough = tried.merger.size() == static_cast<std::size_t>(options.count) &&
                        tried.constant + tried.merger.loss(tried.merger.size() - 1) <= most;
    if (enough || most >= dual || !tried.exact) {
      return ranking_of(packing, tried, tried.exact);
    }
    most = 2 * most < dual ? 2 * most : std::numeric_limits<double>::infinity();
  }
}

Result<PackingPosterior> packing_posterior(const Packing& packing, const PackingSolution& solution,
                                           const PosteriorOptions& options) {
  if (auto fine = check_bound(packing, solution); !fine) return tl::unexpected(fine.error());
  PackingPosterior result;
  result.column.assign(packing.columns(), 0.0);
  Posterior posterior(solution, options, result);
  for (auto& core : components_of(packing)) {
    const auto part = priced(std::move(core), solution);
    result.cut.push_back(posterior.add(part, std::numeric_limits<double>::infinity()));
    result.exact.push_back(std::isinf(result.cut.back()) ? 1 : 0);
  }
  result.clutter = clutter_of(packing, result.column);
  return result;
}

}  // namespace scanfuse::associate
