#pragma once

#include <array>
#include <compare>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "scanfuse/associate/packing_core.hpp"

/// Counting over all packings of a core, row after row. A state is the set of later rows that are
/// used already; states that agree are joined, so the work grows with the width of the core and not
/// with the number of packings.
///
/// Packings are weighed by what they lose against prices u: the loss is the sum of reduced costs of
/// their columns plus the prices of rows that stay free, and weight = sum of u - loss.
namespace scanfuse::associate {

struct FrontierLimits {
  double cut = std::numeric_limits<double>::infinity();  ///< greater losses are left out
  std::size_t states = 100000;                           ///< at one row
  std::size_t moves = 1000000;                           ///< in all
};

/// Sums over the packings of a core within limits.
struct FrontierSum {
  double log_total = 0;        ///< ln of the sum of exp(-loss)
  std::vector<double> shares;  ///< by column: the part of that sum with it
};

/// None where the limits are too narrow.
[[nodiscard]] std::optional<FrontierSum> sum_packings(const PackingCore& core,
                                                      std::span<const double> prices,
                                                      const FrontierLimits& limits);

struct RankedPacking {
  double loss = 0;
  std::vector<std::int32_t> chosen;  ///< columns of the core, ascending
};

/// Packings of least loss, ascending.
struct FrontierRanking {
  std::vector<RankedPacking> packings;
  bool complete = true;  ///< else the limit on states was met: better ones may be missing
};

/// At most `count` packings, all with a loss up to the cut.
[[nodiscard]] FrontierRanking rank_packings(const PackingCore& core, std::span<const double> prices,
                                            std::size_t count, const FrontierLimits& limits);

/// Which rows are used, among those that are open at some time: 256 at most.
using FrontierKey = std::array<std::uint64_t, 4>;

/// The order of rows and what may happen at each.
class Frontier {
 public:
  /// A state taken on: by leaving the row free (column -1, also where it is used) or by a column.
  struct Move {
    FrontierKey to{};
    std::uint32_t from = 0;
    std::int32_t column = -1;
    double loss = 0;
  };

  Frontier(const PackingCore& core, std::span<const double> prices);

  [[nodiscard]] bool fits() const { return fits_; }
  [[nodiscard]] std::size_t levels() const { return order_.size(); }
  /// Moves out of the states at a level, those of one target state together, in a fixed
  /// order.
  [[nodiscard]] std::vector<Move> moves(std::size_t level, std::span<const FrontierKey> states,
                                        std::span<const double> losses, double cut) const;

 private:
  void order_rows(const PackingCore& core);
  [[nodiscard]] std::size_t last_reached(const PackingCore& core, std::size_t start) const;
  void place_slots(const PackingCore& core, std::span<const double> prices);

  struct Option {
    std::int32_t column;
    FrontierKey rows;
    double loss;
  };
  std::vector<std::size_t> order_;            ///< rows by level
  std::vector<FrontierKey> own_;              ///< by level: the row's bit
  std::vector<double> free_loss_;             ///< by level
  std::vector<std::vector<Option>> options_;  ///< by level: columns whose first row it is
  bool fits_ = true;
};

}  // namespace scanfuse::associate
