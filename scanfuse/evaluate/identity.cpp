#include "scanfuse/evaluate/identity.hpp"

#include "scanfuse/core/assignment.hpp"
#include "scanfuse/evaluate/clear.hpp"

namespace scanfuse::evaluate {
namespace {

std::optional<double> id_ratio(double part, double whole) {
  return whole > 0 ? std::optional(part / whole) : std::nullopt;
}

}  // namespace

IdentityMetrics identity_metrics(const Sequence& sequence, const EvaluateOptions& options) {
  Eigen::MatrixXd together = Eigen::MatrixXd::Zero(static_cast<long>(sequence.truth_ids.size()),
                                                   static_cast<long>(sequence.track_ids.size()));
  double truths = 0, estimates = 0;
  for (const auto& frame : sequence.frames) {
    const auto allowed = matchable(frame, options);
    for (int i = 0; i < allowed.rows(); ++i) {
      for (int j = 0; j < allowed.cols(); ++j) {
        if (allowed(i, j)) together(frame.truth_index[i], frame.track_index[j]) += 1;
      }
    }
    truths += static_cast<double>(frame.truth.size());
    estimates += static_cast<double>(frame.tracks.size());
  }
  // Misses and false alarms are what is left over, so the greatest overlap is the least cost.
  const auto track_of_truth = solve_assignment(-together);
  double overlap = 0;
  for (std::size_t i = 0; i < track_of_truth.size(); ++i) {
    if (track_of_truth[i] >= 0) overlap += together(static_cast<long>(i), track_of_truth[i]);
  }
  IdentityMetrics metrics;
  metrics.true_positives = static_cast<std::int64_t>(overlap);
  metrics.false_negatives = static_cast<std::int64_t>(truths - overlap);
  metrics.false_positives = static_cast<std::int64_t>(estimates - overlap);
  metrics.idf1 = id_ratio(2 * overlap, truths + estimates);
  metrics.idp = id_ratio(overlap, estimates);
  metrics.idr = id_ratio(overlap, truths);
  return metrics;
}

}  // namespace scanfuse::evaluate
