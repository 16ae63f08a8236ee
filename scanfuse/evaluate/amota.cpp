#include "scanfuse/evaluate/amota.hpp"

#include <algorithm>
#include <vector>

#include "scanfuse/evaluate/clear.hpp"

namespace scanfuse::evaluate {
namespace {

/// Mean class probability of each track, by its index in the sequence.
std::vector<double> track_scores(const Sequence& sequence) {
  std::vector<double> sums(sequence.track_ids.size(), 0), counts(sequence.track_ids.size(), 0);
  for (const auto& frame : sequence.frames) {
    for (std::size_t j = 0; j < frame.tracks.size(); ++j) {
      const auto track = static_cast<std::size_t>(frame.track_index[j]);
      sums[track] += frame.tracks[j].class_probability;
      counts[track] += 1;
    }
  }
  for (std::size_t k = 0; k < sums.size(); ++k) sums[k] /= std::max(counts[k], 1.0);
  return sums;
}

Sequence with_tracks_from(const Sequence& sequence, const std::vector<double>& scores,
                          double threshold) {
  Sequence kept = sequence;
  for (auto& frame : kept.frames) {
    std::vector<Eigen::Index> columns;
    for (std::size_t j = 0; j < frame.tracks.size(); ++j) {
      if (scores[static_cast<std::size_t>(frame.track_index[j])] < threshold) continue;
      const auto to = columns.size();
      if (to != j) {
        frame.tracks[to] = std::move(frame.tracks[j]);
        frame.track_index[to] = frame.track_index[j];
      }
      columns.push_back(static_cast<Eigen::Index>(j));
    }
    frame.tracks.resize(columns.size());
    frame.track_index.resize(columns.size());
    frame.distance_m = Eigen::MatrixXd(frame.distance_m(Eigen::all, columns));
  }
  return kept;
}

/// Thresholds from high to low, no more than there are levels.
std::vector<double> thresholds_of(std::vector<double> scores, int levels) {
  std::sort(scores.begin(), scores.end(), std::greater<>());
  scores.erase(std::unique(scores.begin(), scores.end()), scores.end());
  const auto most = static_cast<std::size_t>(levels);
  if (scores.size() <= most) return scores;
  std::vector<double> some;
  for (std::size_t k = 1; k <= most; ++k) some.push_back(scores[k * scores.size() / most - 1]);
  return some;
}

std::int64_t truth_count(const Sequence& sequence) {
  std::int64_t count = 0;
  for (const auto& frame : sequence.frames) count += std::ssize(frame.truth);
  return count;
}

}  // namespace

AverageMetrics average_metrics(const Sequence& sequence, const EvaluateOptions& options) {
  const auto objects = static_cast<double>(truth_count(sequence));
  if (options.amota_levels <= 0 || objects == 0) return {};
  const auto scores = track_scores(sequence);
  std::vector<ClearMetrics> at;
  for (const double threshold : thresholds_of(scores, options.amota_levels)) {
    const Sequence kept = with_tracks_from(sequence, scores, threshold);
    at.push_back(clear_metrics(kept, match_frames(kept, options)));
  }
  const double levels = options.amota_levels;
  double mota = 0, scaled = 0, motp = 0;
  for (int level = 1; level <= options.amota_levels; ++level) {
    const double recall = level / levels;
    const auto found = std::ranges::find_if(at, [&](const ClearMetrics& m) {
      return static_cast<double>(m.true_positives) >= recall * objects - 1e-9;
    });
    if (found == at.end()) break;
    const auto errors = static_cast<double>(found->false_positives + found->false_negatives +
                                            found->identity_switches);
    mota += 1 - errors / objects;
    // 1 - (errors - (1 - r) objects) / (r objects) at the recall r that the threshold did reach.
    const auto found_objects = static_cast<double>(found->true_positives);
    scaled += std::max(0.0, 1 - (errors - (objects - found_objects)) / found_objects);
    motp += found->motp_m.value_or(0);
  }
  return {mota / levels, scaled / levels, motp / levels};
}

}  // namespace scanfuse::evaluate
