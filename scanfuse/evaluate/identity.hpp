#pragma once

#include <cstdint>
#include <optional>

#include "scanfuse/evaluate/sequence.hpp"

namespace scanfuse::evaluate {

struct IdentityMetrics {
  std::optional<double> idf1;  ///< none without truth and tracks
  std::optional<double> idp;
  std::optional<double> idr;
  std::int64_t true_positives = 0;
  std::int64_t false_positives = 0;
  std::int64_t false_negatives = 0;
};

/// One track for each truth object over the whole recording, chosen so that most pairs of frames
/// agree [Ristani2016]. A pair agrees where it may match in CLEAR.
[[nodiscard]] IdentityMetrics identity_metrics(const Sequence& sequence,
                                               const EvaluateOptions& options);

}  // namespace scanfuse::evaluate
