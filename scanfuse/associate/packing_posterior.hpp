#pragma once

#include <cstdint>
#include <limits>
#include <tuple>
#include <vector>

#include "scanfuse/associate/packing.hpp"

/// More than the one best packing: the next ones, and how probable each column is.
namespace scanfuse::associate {

struct RankingOptions {
  int count = 10;
  int max_states = 20000;

  static constexpr auto fields() {
    using O = RankingOptions;
    return std::tuple{
        Field{"count", &O::count, 1, 100000, "how many packings"},
        Field{"max_states", &O::max_states, 1, 100000000,
              "of one part at one row; beyond, better packings may be missed and it is said"},
    };
  }
};

struct WeighedPacking {
  std::vector<std::int32_t> chosen;  ///< columns, ascending
  double weight = 0;
};

/// From the heaviest on; ties in an order that is the same on every run.
struct PackingRanking {
  std::vector<WeighedPacking> packings;
  bool exact = false;  ///< no packing that is missing weighs more than the last
};

/// The packings of most weight; fewer where there are fewer. Prices say which columns can be in
/// them: packings that lose at most L against the dual bound hold no column of a reduced cost above
/// L. What is left falls apart, each part gives its best, and sums of parts are merged in order;
/// L grows until enough are found. `solution` is one of the same packing; its prices are used.
[[nodiscard]] Result<PackingRanking> best_packings(const Packing& packing,
                                                   const PackingSolution& solution,
                                                   const RankingOptions& options = {});

struct PosteriorOptions {
  int max_moves = 300000;
  double cut = 12;

  static constexpr auto fields() {
    using O = PosteriorOptions;
    return std::tuple{
        Field{"max_moves", &O::max_moves, 1, 1000000000,
              "steps of the exact count in one part; beyond, improbable columns are left out"},
        Field{"cut", &O::cut, 1.0, 1e6,
              "where the exact count is too much: choices that lose more are left out (nats), "
              "and more of them where that is too much still"},
    };
  }
};

/// P(column) = sum of exp(weight) over packings that hold it, by the sum over all packings.
struct PackingPosterior {
  std::vector<double> column;   ///< by column; 0 where the weight is not positive
  std::vector<double> clutter;  ///< by row: it is in no column
  /// By component of the solution: somewhere in it choices were left out that make a packing
  /// lighter by more than this (nats); infinity: none were, the probabilities are exact; 0: a
  /// part was so large that its 100 best packings stand for all.
  std::vector<double> cut;
  std::vector<char> exact;  ///< by component
};

/// Weights must be logarithms of odds against clutter (nats).
[[nodiscard]] Result<PackingPosterior> packing_posterior(const Packing& packing,
                                                         const PackingSolution& solution,
                                                         const PosteriorOptions& options = {});

}  // namespace scanfuse::associate
