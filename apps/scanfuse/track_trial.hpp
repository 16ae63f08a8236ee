#pragma once

#include <string_view>
#include <vector>

#include "scanfuse/core/result.hpp"
#include "scanfuse/evaluate/evaluate.hpp"
#include "scanfuse/pipeline/perception.hpp"

namespace scanfuse::app {

/// One simulated run through the chain and its score.
struct TrackTrial {
  evaluate::Evaluation score;
  /// Scenario 2 only: target 1 is followed by the same track before and after it was hidden.
  bool identity_kept = false;
};

/// Runs a scenario of `simulate` through the chain. Only objects within the carriageway count, and
/// of the truth only what shows at least `min_visible_points` returns.
[[nodiscard]] Result<TrackTrial> run_trial(std::string_view scenario, std::uint64_t seed,
                                           const pipeline::PerceptionOptions& options,
                                           const evaluate::EvaluateOptions& scoring);

/// What the scenarios of [Lu2018] are scored with: the carriageway, c = 3 m, 3 returns.
[[nodiscard]] evaluate::EvaluateOptions lu2018_scoring();

}  // namespace scanfuse::app
