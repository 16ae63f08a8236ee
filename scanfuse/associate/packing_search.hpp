#pragma once

#include <chrono>
#include <span>
#include <vector>

#include "scanfuse/associate/packing_core.hpp"

/// The recursion of `PriceAndBranch` on one component.
namespace scanfuse::associate {

/// When to stop, and whether several threads may be used.
struct SearchLimits {
  std::chrono::steady_clock::time_point deadline;
  int max_branches = 0;
  int threads = 1;
};

/// A part of a packing with what is known of it so far.
struct SearchPart {
  PackingCore core;
  std::vector<double> prices;       ///< feasible
  std::vector<std::int32_t> start;  ///< a packing, local columns
  double threshold = 0;             ///< a packing of this weight or less is of no interest
  double temperature = 0;           ///< where annealing goes on, 0: from the beginning
};

/// What a search found: a packing of the part (columns of the whole), and a proof, its last step
/// the claim about the part (no steps: the part has no columns).
struct SearchOutcome {
  std::vector<std::int32_t> chosen;
  double primal = 0;
  double bound = 0;
  std::vector<ProofStep> proof;
  PackingDiagnostics diagnostics;
};

[[nodiscard]] SearchOutcome search_part(SearchPart part, const SearchLimits& limits);

}  // namespace scanfuse::associate
