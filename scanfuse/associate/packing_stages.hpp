#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>
#include <tuple>
#include <vector>

#include "scanfuse/associate/associate.hpp"
#include "scanfuse/associate/packing.hpp"
#include "scanfuse/associate/packing_core.hpp"

/// Successive 2-D assignments on sparse columns, for the Lagrangian relaxation [Deb1997].
namespace scanfuse::associate {

inline constexpr std::int32_t kNoRow = -1;
inline constexpr std::int32_t kEmpty = -1;  ///< prefix of a column without rows in the sets so far
inline constexpr std::int32_t kDropped = -2;  ///< the column's prefix was not chosen

/// A value, and the column that has it.
struct Offer {
  double value = 0;
  std::int32_t column = -1;
  void raise(double other, std::size_t j) {
    if (other > value) *this = {other, static_cast<std::int32_t>(j)};
  }
};

/// The best column of a prefix with a row, and what it gains over the two going alone.
struct PairOffer {
  Candidate pair;
  std::int32_t column = -1;
};

/// Sets 0 .. count - 1 of a core and its columns' rows in their order.
struct OrderedCore {
  explicit OrderedCore(const PackingCore& packing_core, const Packing& packing)
      : core(packing_core), set_of_row(packing_core.rows.size()) {
    std::vector<std::int32_t> sets;
    sets.reserve(core.rows.size());
    for (const auto row : core.rows)
      sets.push_back(packing.set_of_row[static_cast<std::size_t>(row)]);
    auto names = sets;
    std::ranges::sort(names);
    names.erase(std::ranges::unique(names).begin(), names.end());
    count = names.size();
    for (std::size_t i = 0; i < sets.size(); ++i) {
      const auto place = std::ranges::lower_bound(names, sets[i]) - names.begin();
      set_of_row[i] = static_cast<std::size_t>(place);
    }
    for (std::size_t j = 0; j < core.columns.size(); ++j) {
      const auto begin = core.members.begin() + core.starts[j];
      std::sort(begin, core.members.begin() + core.starts[j + 1], [&](auto a, auto b) {
        return set_of_row[static_cast<std::size_t>(a)] < set_of_row[static_cast<std::size_t>(b)];
      });
    }
  }

  [[nodiscard]] std::size_t set(std::int32_t row) const {
    return set_of_row[static_cast<std::size_t>(row)];
  }

  PackingCore core;  ///< members of each column in the order of their sets
  std::vector<std::size_t> set_of_row;
  std::size_t count = 0;
};

/// Successive 2-D assignments: chosen prefixes of columns grow set by set.
class Stages {
 public:
  Stages(const OrderedCore& ordered, std::span<const double> prices)
      : ordered_(ordered), core_(ordered.core), rows_(core_.rows.size()) {
    const std::size_t columns = core_.columns.size();
    next_.assign(columns, 0);
    values_ = core_.weights;
    prices_.assign(prices.begin(), prices.end());
    prefixes_.resize(columns);
    for (std::size_t j = 0; j < columns; ++j) {
      for (const auto row : core_.column(j)) {
        if (ordered_.set(row) > 1) values_[j] -= prices_[static_cast<std::size_t>(row)];
      }
      const auto row = row_in(j, 0);
      prefixes_[j] = row == kNoRow ? kEmpty : row;
    }
    prefix_count_ = rows_;  // a prefix of one row carries its number
  }

  /// The best columns for a 2-D assignment of prefixes to rows of one set.
  void assign(std::size_t set) {
    alone_.assign(prefix_count_, {});
    row_alone_.assign(rows_, {});
    collect_alone(set);
    collect_pairs(set);
    std::vector<Candidate> candidates;
    candidates.reserve(pairs_.size());
    for (const auto& offer : pairs_) candidates.push_back(offer.pair);
    assignment_ =
        assign_global(static_cast<int>(prefix_count_), static_cast<int>(rows_), candidates, 0);
  }

  /// Columns of the relaxed problem's optimum: of the assignment just made, and all columns of
  /// positive value without a row so far.
  [[nodiscard]] std::vector<std::int32_t> relaxed() const {
    std::vector<std::int32_t> columns;
    for (const auto& offer : pairs_) {
      if (matched(offer.pair.track) == offer.pair.detection) columns.push_back(offer.column);
    }
    for (std::size_t p = 0; p < prefix_count_; ++p) {
      if (matched(static_cast<int>(p)) < 0 && alone_[p].column >= 0) {
        columns.push_back(alone_[p].column);
      }
    }
    for (std::size_t r = 0; r < rows_; ++r) {
      if (assignment_.track_of_detection[r] < 0 && row_alone_[r].column >= 0) {
        columns.push_back(row_alone_[r].column);
      }
    }
    for (std::size_t j = 0; j < prefixes_.size(); ++j) {
      if (prefixes_[j] == kEmpty && row_in(j, 1) == kNoRow && values_[j] > 0) {
        columns.push_back(static_cast<std::int32_t>(j));
      }
    }
    return columns;
  }

  [[nodiscard]] double value(std::int32_t j) const { return values_[static_cast<std::size_t>(j)]; }

  /// Prices of the first two sets that prove the 2-D assignment: what a prefix or row gains alone,
  /// and its part of the pairs' further gains. Those parts start with the prefixes and move to the
  /// rows as far as other pairs demand.
  [[nodiscard]] std::vector<double> assignment_prices() const {
    std::vector<double> prefix(prefix_count_, 0.0), row(rows_, 0.0), gain(prefix_count_, 0.0);
    for (const auto& offer : pairs_) {
      const auto [track, detection, cost] = offer.pair;
      if (matched(track) == detection) gain[static_cast<std::size_t>(track)] = -cost;
    }
    prefix = gain;
    bool moved = true;
    for (std::size_t round = 0; moved && round <= rows_; ++round) {
      moved = false;
      for (const auto& offer : pairs_) {
        const auto t = static_cast<std::size_t>(offer.pair.track);
        const auto d = static_cast<std::size_t>(offer.pair.detection);
        const double wanted = -offer.pair.cost - prefix[t];
        if (wanted <= row[d] + 1e-13 * std::abs(offer.pair.cost)) continue;
        row[d] = wanted;
        const int partner = assignment_.track_of_detection[d];
        if (partner < 0) continue;
        const auto other = static_cast<std::size_t>(partner);
        prefix[other] = std::max(0.0, gain[other] - wanted);
        moved = true;
      }
    }
    std::vector<double> prices(rows_, 0.0);
    for (std::size_t i = 0; i < rows_; ++i) {
      prices[i] = prefix[i] + alone_[i].value + row[i] + row_alone_[i].value;
    }
    return prices;
  }

  /// Keeps the columns whose prefix was chosen, and numbers the longer prefixes.
  void advance(std::size_t set) {
    std::vector<std::int32_t> of_prefix(prefix_count_, kDropped), of_row(rows_, kDropped);
    std::int32_t count = 0;
    for (std::size_t p = 0; p < prefix_count_; ++p) {
      if (matched(static_cast<int>(p)) >= 0 || alone_[p].column >= 0) of_prefix[p] = count++;
    }
    for (std::size_t r = 0; r < rows_; ++r) {
      const bool starts = assignment_.track_of_detection[r] < 0 && row_alone_[r].column >= 0;
      if (starts) of_row[r] = count++;
    }
    for (std::size_t j = 0; j < prefixes_.size(); ++j) {
      if (prefixes_[j] == kDropped) continue;
      prefixes_[j] = longer_prefix(j, row_in(j, set), of_prefix, of_row);
    }
    prefix_count_ = static_cast<std::size_t>(count);
    step_over(set);
  }

  /// The heaviest column of each prefix that is left.
  [[nodiscard]] CorePacking packing() const {
    std::vector<Offer> best(prefix_count_);
    for (std::size_t j = 0; j < prefixes_.size(); ++j) {
      if (prefixes_[j] >= 0)
        best[static_cast<std::size_t>(prefixes_[j])].raise(core_.weights[j], j);
    }
    CorePacking result;
    for (const auto& offer : best) {
      if (offer.column < 0) continue;
      result.chosen.push_back(offer.column);
      result.weight += offer.value;
    }
    std::ranges::sort(result.chosen);
    return result;
  }

  /// To the next set: its prices are no longer a matter of the future.
  void step_over(std::size_t set) {
    for (std::size_t j = 0; j < prefixes_.size(); ++j) {
      if (row_in(j, set) != kNoRow) ++next_[j];
      const auto row = row_in(j, set + 1);
      if (set >= 1 && row != kNoRow) values_[j] += prices_[static_cast<std::size_t>(row)];
    }
  }

 private:
  /// The column's row in a set; sets are asked for in turn.
  [[nodiscard]] std::int32_t row_in(std::size_t j, std::size_t set) const {
    const auto rows = core_.column(j);
    if (next_[j] >= rows.size() || ordered_.set(rows[next_[j]]) != set) return kNoRow;
    return rows[next_[j]];
  }
  [[nodiscard]] int matched(int prefix) const {
    return assignment_.detection_of_track[static_cast<std::size_t>(prefix)];
  }

  void collect_alone(std::size_t set) {
    for (std::size_t j = 0; j < prefixes_.size(); ++j) {
      const auto row = row_in(j, set);
      if (prefixes_[j] >= 0 && row == kNoRow) {
        alone_[static_cast<std::size_t>(prefixes_[j])].raise(values_[j], j);
      } else if (prefixes_[j] == kEmpty && row != kNoRow) {
        row_alone_[static_cast<std::size_t>(row)].raise(values_[j], j);
      }
    }
  }

  void collect_pairs(std::size_t set) {
    pairs_.clear();
    for (std::size_t j = 0; j < prefixes_.size(); ++j) {
      const auto row = row_in(j, set);
      if (prefixes_[j] < 0 || row == kNoRow) continue;
      const double gain = values_[j] - alone_[static_cast<std::size_t>(prefixes_[j])].value -
                          row_alone_[static_cast<std::size_t>(row)].value;
      if (gain > 0) pairs_.push_back({{prefixes_[j], row, -gain}, static_cast<std::int32_t>(j)});
    }
    std::ranges::sort(pairs_, [](const PairOffer& a, const PairOffer& b) {
      return std::tuple{a.pair.track, a.pair.detection, a.pair.cost, a.column} <
             std::tuple{b.pair.track, b.pair.detection, b.pair.cost, b.column};
    });
    const auto same = [](const PairOffer& a, const PairOffer& b) {
      return a.pair.track == b.pair.track && a.pair.detection == b.pair.detection;
    };
    pairs_.erase(std::ranges::unique(pairs_, same).begin(), pairs_.end());
  }

  [[nodiscard]] std::int32_t longer_prefix(std::size_t j, std::int32_t row,
                                           std::span<const std::int32_t> of_prefix,
                                           std::span<const std::int32_t> of_row) const {
    if (prefixes_[j] == kEmpty) {
      return row == kNoRow ? kEmpty : of_row[static_cast<std::size_t>(row)];
    }
    const int match = matched(prefixes_[j]);
    return match == row ? of_prefix[static_cast<std::size_t>(prefixes_[j])] : kDropped;
  }

  const OrderedCore& ordered_;
  const PackingCore& core_;
  std::size_t rows_;
  std::size_t prefix_count_ = 0;
  std::vector<std::size_t> next_;       ///< first member of each column in sets to come
  std::vector<double> values_;          ///< by column: weight less prices of sets to come
  std::vector<double> prices_;          ///< by row
  std::vector<std::int32_t> prefixes_;  ///< by column
  std::vector<Offer> alone_;            ///< by prefix: the best column without a row of the set
  std::vector<Offer> row_alone_;        ///< by row: the best column without rows before it
  std::vector<PairOffer> pairs_;
  Assignment assignment_;
};

}  // namespace scanfuse::associate
