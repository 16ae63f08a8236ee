#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "scanfuse/evaluate/sequence.hpp"

namespace scanfuse::evaluate {

/// The object's box; none where the truth does not tell heading and extent.
[[nodiscard]] std::optional<Box2> box_of(const TruthObject& object);

/// Similarity of all pairs of a frame, max(0, 1 - d / s) or the IoU of their boxes, and which of
/// them may match in CLEAR and identity metrics: similarity at least `match_similarity` and d <=
/// match_m.
[[nodiscard]] Eigen::MatrixXd similarity(const ScoredFrame& frame, const EvaluateOptions& options);
[[nodiscard]] Eigen::Array<bool, Eigen::Dynamic, Eigen::Dynamic> matchable(
    const ScoredFrame& frame, const EvaluateOptions& options);

/// A truth object and the track that follows it, as indices into the frame's lists.
struct MatchedPair {
  int truth = 0;
  int track = 0;
};

/// The pairs of each frame: pairs of the frame before are kept where they may still match, then the
/// sum of similarities is greatest; an optimal assignment, not greedy [Bernardin2008].
[[nodiscard]] std::vector<std::vector<MatchedPair>> match_frames(const Sequence& sequence,
                                                                 const EvaluateOptions& options);

struct ClearMetrics {
  std::optional<double> mota;    ///< 1 - (FN + FP + IDSW) / truth objects; none without truth
  std::optional<double> motp_m;  ///< mean centre distance of the matches
  std::int64_t true_positives = 0;
  std::int64_t false_positives = 0;
  std::int64_t false_negatives = 0;
  std::int64_t identity_switches = 0;
  std::int64_t fragmentations = 0;
  int mostly_tracked = 0;  ///< objects matched in more than 80 % of their frames
  int partly_tracked = 0;  ///< in 20 to 80 %
  int mostly_lost = 0;
};

/// [Bernardin2008] with the counting rules of TrackEval [Luiten2021]: a switch is counted against
/// the last track that the object ever had; a frame without any truth or without any track does not
/// interrupt.
[[nodiscard]] ClearMetrics clear_metrics(const Sequence& sequence,
                                         const std::vector<std::vector<MatchedPair>>& matches);

}  // namespace scanfuse::evaluate
