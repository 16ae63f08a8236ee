#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "scanfuse/evaluate/amota.hpp"
#include "scanfuse/evaluate/by_range.hpp"
#include "scanfuse/evaluate/clear.hpp"
#include "scanfuse/evaluate/errors.hpp"
#include "scanfuse/evaluate/gospa.hpp"
#include "scanfuse/evaluate/hota.hpp"
#include "scanfuse/evaluate/identity.hpp"
#include "scanfuse/evaluate/options.hpp"

namespace scanfuse::evaluate {

struct ClassMetrics {
  std::optional<double> precision;  ///< of the tracks said to be of the class; none without any
  std::optional<double> recall;     ///< of the objects that are of the class; none without any
};

/// Which track followed an object at a frame.
struct FollowedBy {
  std::int64_t frame = 0;
  std::int64_t track_id = 0;
  friend bool operator==(const FollowedBy&, const FollowedBy&) = default;
};

/// Everything `evaluate` measures. Two kinds of match: CLEAR, identity and HOTA ask for similarity
/// (with the defaults a centre within 1 m); errors, consistency, classes, ghosts and `followed_by`
/// take every pair within match_m, so that a poor estimate shows as an error and not as a miss.
struct Evaluation {
  std::int64_t frames = 0;
  ClearMetrics clear;
  IdentityMetrics identity;
  HotaMetrics hota;
  SetMetrics sets;
  RmseMetrics rmse;
  ConsistencyMetrics consistency;
  AverageMetrics average;
  std::optional<double> ghosts_per_frame;  ///< tracks that follow no object; none without frames
  std::optional<double> ghost_movers_per_frame;  ///< tracks that move where no object is
  /// From an object's first scan to the first in which a confirmed track followed it; median over
  /// the objects that were followed.
  std::optional<double> time_to_confirm_s;
  std::optional<double> bev_iou;  ///< mean over wide matches whose truth tells heading and extent
  std::map<ObjectClass, ClassMetrics> detection;  ///< classes that truth or tracks have
  std::map<ObjectClass, std::vector<RangeMetrics>> detection_by_range;
  std::map<ObjectClass, std::map<ObjectClass, std::int64_t>> confusion;  ///< [truth][track], pairs
  std::map<std::int64_t, std::vector<FollowedBy>> followed_by;  ///< truth id -> frames, ascending

  /// The tracks that followed the truth object, frame by frame; empty when there were none.
  [[nodiscard]] std::vector<FollowedBy> identities_of(std::int64_t truth_id) const;
};

/// Scores tracks against truth. Deterministic; never NaN: what cannot be computed is empty.
/// How truth and tracks are brought together stands at `make_sequence`.
[[nodiscard]] Evaluation evaluate(std::span<const StepResult> steps,
                                  std::span<const TruthFrame> truth,
                                  const EvaluateOptions& options = {});

/// One JSON object with the keys that scripts rely on (docs/metrics.md); empty values are null.
[[nodiscard]] std::string to_json(const Evaluation& evaluation);

/// A table for people.
[[nodiscard]] std::string to_text(const Evaluation& evaluation);

}  // namespace scanfuse::evaluate
