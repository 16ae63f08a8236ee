#pragma once

#include <optional>

#include "scanfuse/evaluate/options.hpp"
#include "scanfuse/evaluate/sequence.hpp"

namespace scanfuse::evaluate {

/// CLEAR metrics averaged over levels of recall [Weng2020]: how good a tracker is whatever score
/// one asks of its tracks. A track's score is the mean of its class probability.
struct AverageMetrics {
  std::optional<double> amota;   ///< mean of MOTA over the levels
  std::optional<double> samota;  ///< the same, each level scaled to reach 1 at its recall
  std::optional<double> amotp_m;
};

/// Levels of recall are 1/n .. 1, n = `amota_levels`; each takes the highest threshold on the score
/// that reaches it (sAMOTA is scaled by the recall reached, which may be more), and a level that
/// none reaches counts 0. Empty without truth or with n = 0.
[[nodiscard]] AverageMetrics average_metrics(const Sequence& sequence,
                                             const EvaluateOptions& options);

}  // namespace scanfuse::evaluate
