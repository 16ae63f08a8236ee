#pragma once

#include <cstdint>
#include <vector>

#include "scanfuse/associate/packing.hpp"
#include "scanfuse/associate/packing_posterior.hpp"
#include "scanfuse/triangulate/candidates.hpp"

namespace scanfuse::triangulate {

struct AssociationOptions {
  CostMethod cost = CostMethod::kEvidence;
  double alpha = 0.5;
  associate::PackingMethod solver = associate::PackingMethod::kPriceAndBranch;
  double time_limit_s = 60;
  bool posterior = true;
  int posterior_moves = 20000;
  CandidateOptions candidates;

  static constexpr auto fields() {
    using O = AssociationOptions;
    return std::tuple{
        Field{"cost", &O::cost, "what a hypothesis is worth"},
        Field{"alpha", &O::alpha, 0.01, 1.0, "order of Renyi's divergence"},
        Field{"solver", &O::solver, "how the best association is found"},
        Field{"time_limit_s", &O::time_limit_s, 0.0, 1e6,
              "of a scan's solver; then the best so far is returned with its gap"},
        Field{"posterior", &O::posterior, "tell how probable each target and member is"},
        Field{"posterior_moves", &O::posterior_moves, 1, 1000000000,
              "steps of the exact count in one component; beyond, light rivals are left out"}};
  }
};

/// Which bearings of a scan belong together, where that puts the targets, and how good the answer
/// is: no other association weighs more than `dual`.
struct ScanAssociation {
  std::vector<Fix> fixes;                       ///< ordered by their first bearing
  std::vector<std::int64_t> target_of_bearing;  ///< Fix::target, -1 for clutter
  /// How probable that is, by bearing: that it is of that target, or clutter. 1 without
  /// `posterior`.
  std::vector<double> probability_of_bearing;
  associate::Packing packing;  ///< the hypotheses that were weighed
  associate::PackingSolution solution;
  /// solution.dual, and more where hypotheses of many sensors had to be left out unproved.
  double dual = 0;
  bool proved = false;           ///< the solution is, and none had to be
  std::size_t cut_bearings = 0;  ///< around which some had to be
  EstimatedPrior prior;
  std::int64_t pairs_tried = 0;
  double solver_seconds = 0;    ///< wall time; the rest of the result does not depend on it
  double gate_probability = 0;  ///< narrower than asked for where there were too many hypotheses

  [[nodiscard]] double gap() const { return associate::relative_gap(solution.primal, dual); }
};

/// The hypotheses of a scan as columns over its bearings.
struct WeighedHypotheses {
  associate::Packing packing;
  std::int64_t pairs_tried = 0;
  double gate_probability = 0;
  std::vector<std::int32_t> cut;  ///< as in Candidates
  std::vector<double> cut_prices;
};

/// A bound on all hypotheses from one on those that were weighed: components with bearings around
/// which some were left out are bounded by those bearings' prices.
[[nodiscard]] double bound_on_all(const WeighedHypotheses& weighed,
                                  const associate::PackingSolution& solution);

/// An error where there are more than allowed at any gate.
[[nodiscard]] Result<WeighedHypotheses> weigh_hypotheses(const BearingScan& scan,
                                                         const PassiveScene& scene,
                                                         const ScenePrior& prior,
                                                         const AssociationOptions& options,
                                                         int threads);

/// A packing by the solver that the options name.
[[nodiscard]] Result<associate::PackingSolution> solve(const associate::Packing& packing,
                                                       const AssociationOptions& options,
                                                       int threads);

/// A fix's existence_probability is the posterior of the hypotheses that hold more than half of its
/// bearings (no two of them can be true at once); without `posterior` that of its own evidence.
///
/// The bearings must name sensors of the scene and hold finite angles: what the readers of io
/// check. An error where there are more hypotheses than allowed at any gate. A scan with bearings
/// of fewer than two sensors has no fixes.
[[nodiscard]] Result<ScanAssociation> associate_scan(const BearingScan& scan,
                                                     const PassiveScene& scene,
                                                     const AssociationOptions& options = {},
                                                     int threads = 1);

}  // namespace scanfuse::triangulate
