#pragma once

#include <cstdint>
#include <span>
#include <tuple>
#include <vector>

#include "scanfuse/core/options.hpp"
#include "scanfuse/triangulate/costs.hpp"

namespace scanfuse::triangulate {

struct CandidateOptions {
  double gate_probability = 0.9999;
  int most_candidates = 5000000;
  int most_pairs = 20000000;
  int many_sensors = 13;
  int steps_per_bearing = 1000;

  static constexpr auto fields() {
    using O = CandidateOptions;
    return std::tuple{
        Field{"gate_probability", &O::gate_probability, 0.5, 0.99999999,
              "bearings of one target agree this well, by chi-square, with this probability"},
        Field{"most_candidates", &O::most_candidates, 1000, 100000000,
              "hypotheses kept in a scan; where there are more the gate is narrowed"},
        Field{"most_pairs", &O::most_pairs, 1000, 2000000000,
              "lines of two sensors looked at in a scan; where there are more the gate is "
              "narrowed"},
        Field{"many_sensors", &O::many_sensors, 3, 65,
              "where so many have bearings, hypotheses are left out that lack a bearing which "
              "nothing else wants"},
        Field{"steps_per_bearing", &O::steps_per_bearing, 100, 1000000000,
              "there: places looked for from each first bearing; beyond, the bound of the scan "
              "is that of the bearings and not of the hypotheses"}};
  }
};

/// Hypotheses that could be in the best association: column after column, the bearings (places in
/// the scan, ascending by sensor) and the weight.
struct Candidates {
  std::vector<std::size_t> starts{0};  ///< one more than there are columns
  std::vector<std::int32_t> members;
  std::vector<double> weights;
  std::int64_t tried = 0;       ///< pairs of lines that were looked at
  double gate_probability = 0;  ///< what was used in the end
  bool too_many = false;        ///< more than allowed even with the narrowest gate: no columns
  /// Bearings around which hypotheses were left out that nothing rules out, and prices that cover
  /// those too: no association of these bearings weighs more than the sum.
  std::vector<std::int32_t> cut;
  std::vector<double> cut_prices;
  [[nodiscard]] std::size_t size() const { return weights.size(); }
  [[nodiscard]] std::span<const std::int32_t> column(std::size_t k) const {
    return std::span(members).subspan(starts[k], starts[k + 1] - starts[k]);
  }
};

/// All hypotheses of two or more sensors that pass the chi-square gate, weigh more than nothing and
/// more than each of them without one of its bearings (which could take their place otherwise).
/// Pairs come from an epipolar index and grow sensor by sensor. Memory grows with the hypotheses.
/// Where `many_sensors` or more have bearings, those are left out too that cannot be in an optimum
/// because they leave out a bearing that nothing else wants (contested_growth.hpp); all costs but
/// the literal one.
/// Columns come in the same order on any number of threads.
[[nodiscard]] Candidates find_candidates(const BearingScan& scan, const PassiveScene& scene,
                                         const ScenePrior& prior, const Cost& cost,
                                         const CandidateOptions& options = {}, int threads = 1);

/// A scan's lines of sight, in the order of its bearings.
[[nodiscard]] std::vector<LineOfSight> lines_of_sight(const BearingScan& scan,
                                                      const PassiveScene& scene);

}  // namespace scanfuse::triangulate
