#pragma once

#include <cstdint>
#include <vector>

#include "scanfuse/associate/packing.hpp"
#include "scanfuse/triangulate/candidates.hpp"

namespace scanfuse::triangulate {

struct AssociationOptions {
  CostMethod cost = CostMethod::kEvidence;
  double alpha = 0.5;
  associate::PackingMethod solver = associate::PackingMethod::kPriceAndBranch;
  double time_limit_s = 60;
  CandidateOptions candidates;

  static constexpr auto fields() {
    using O = AssociationOptions;
    return std::tuple{Field{"cost", &O::cost, "what a hypothesis is worth"},
                      Field{"alpha", &O::alpha, 0.01, 1.0, "order of Renyi's divergence"},
                      Field{"solver", &O::solver, "how the best association is found"},
                      Field{"time_limit_s", &O::time_limit_s, 0.0, 1e6,
                            "of a scan's solver; then the best so far is returned with its gap"}};
  }
};

/// Which bearings of a scan belong together, where that puts the targets, and how good the answer
/// is: no other association weighs more than `solution.dual`.
struct ScanAssociation {
  std::vector<Fix> fixes;                       ///< ordered by their first bearing
  std::vector<std::int64_t> target_of_bearing;  ///< Fix::target, -1 for clutter
  associate::Packing packing;                   ///< the hypotheses that were weighed
  associate::PackingSolution solution;
  EstimatedPrior prior;
  std::int64_t pairs_tried = 0;
  double gate_probability = 0;  ///< narrower than asked for where there were too many hypotheses
};

/// The bearings must name sensors of the scene and hold finite angles: what the readers of io
/// check. An error where there are more hypotheses than allowed at any gate. A scan with bearings
/// of fewer than two sensors has no fixes.
[[nodiscard]] Result<ScanAssociation> associate_scan(const BearingScan& scan,
                                                     const PassiveScene& scene,
                                                     const AssociationOptions& options = {},
                                                     int threads = 1);

}  // namespace scanfuse::triangulate
