#pragma once

#include <array>
#include <optional>

#include "scanfuse/evaluate/sequence.hpp"

namespace scanfuse::evaluate {

/// At one similarity threshold alpha.
struct HotaAtAlpha {
  double alpha = 0;
  double hota = 0;
  double det_a = 0;
  double ass_a = 0;
  double loc_a = 1;  ///< mean similarity of matches; 1 where there is none, as in TrackEval
};

struct HotaMetrics {
  std::optional<double> hota;  ///< means over alpha; none without truth and tracks
  std::optional<double> det_a;
  std::optional<double> ass_a;
  std::optional<double> loc_a;
  std::array<HotaAtAlpha, 19> by_alpha;  ///< 0.05, 0.10, ... 0.95
};

/// Higher order tracking accuracy [Luiten2021]: in each frame one assignment that favours pairs
/// whose whole tracks overlap, then thresholds on similarity.
[[nodiscard]] HotaMetrics hota_metrics(const Sequence& sequence, const EvaluateOptions& options);

}  // namespace scanfuse::evaluate
