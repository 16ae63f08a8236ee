#include "scanfuse/evaluate/clear.hpp"

#include <algorithm>

#include "scanfuse/core/assignment.hpp"
#include "scanfuse/geometry/overlap.hpp"

namespace scanfuse::evaluate {
namespace {

constexpr double kContinuityBonus = 1000;  // more than any sum of similarities decides
constexpr double kRounding = 1e-12;

/// What the count remembers of one truth object.
struct ObjectHistory {
  int last_track = -1;      ///< ever
  int previous_track = -1;  ///< in the frame before
  std::int64_t seen = 0;
  std::int64_t matched = 0;
  std::int64_t starts = 0;  ///< times it went from lost to tracked
};

Eigen::MatrixXd overlaps(const ScoredFrame& frame) {
  Eigen::MatrixXd overlap =
      Eigen::MatrixXd::Zero(std::ssize(frame.truth), std::ssize(frame.tracks));
  for (std::size_t i = 0; i < frame.truth.size(); ++i) {
    const auto box = box_of(frame.truth[i]);
    for (std::size_t j = 0; box && j < frame.tracks.size(); ++j) {
      overlap(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)) =
          intersection_over_union(*box, frame.tracks[j].box);
    }
  }
  return overlap;
}

}  // namespace

std::optional<Box2> box_of(const TruthObject& object) {
  if (!object.heading_rad || !object.length_m || !object.width_m) return std::nullopt;
  return Box2{object.position_m, *object.heading_rad, *object.length_m, *object.width_m};
}

Eigen::MatrixXd similarity(const ScoredFrame& frame, const EvaluateOptions& options) {
  if (options.similarity == SimilarityBy::kBevIou) return overlaps(frame);
  const double reach = std::max(options.similarity_m, options.match_m);
  return (1.0 - frame.distance_m.array() / reach).max(0.0);
}

Eigen::Array<bool, Eigen::Dynamic, Eigen::Dynamic> matchable(const ScoredFrame& frame,
                                                             const EvaluateOptions& options) {
  return similarity(frame, options).array() >= options.match_similarity - kRounding &&
         frame.distance_m.array() <= options.match_m;
}

std::vector<std::vector<MatchedPair>> match_frames(const Sequence& sequence,
                                                   const EvaluateOptions& options) {
  std::vector<std::vector<MatchedPair>> matches(sequence.frames.size());
  std::vector<int> previous(sequence.truth_ids.size(), -1);
  for (std::size_t k = 0; k < matches.size(); ++k) {
    const ScoredFrame& frame = sequence.frames[k];
    if (frame.truth.empty() || frame.tracks.empty()) continue;
    const auto allowed = matchable(frame, options);
    Eigen::MatrixXd cost = -similarity(frame, options);
    for (int i = 0; i < cost.rows(); ++i) {
      for (int j = 0; j < cost.cols(); ++j) {
        if (frame.track_index[j] == previous[frame.truth_index[i]]) cost(i, j) -= kContinuityBonus;
        if (!allowed(i, j)) cost(i, j) = 0;
      }
    }
    std::fill(previous.begin(), previous.end(), -1);
    const auto columns = solve_assignment(cost);
    for (int i = 0; i < cost.rows(); ++i) {
      const int j = columns[i];
      if (j < 0 || !allowed(i, j)) continue;
      matches[k].push_back({i, j});
      previous[frame.truth_index[i]] = frame.track_index[j];
    }
  }
  return matches;
}

namespace {

class ClearCount {
 public:
  explicit ClearCount(const Sequence& sequence) : history_(sequence.truth_ids.size()) {}

  void add(const ScoredFrame& frame, const std::vector<MatchedPair>& pairs) {
    for (const int i : frame.truth_index) history_[i].seen += 1;
    const auto matched = static_cast<std::int64_t>(pairs.size());
    metrics_.true_positives += matched;
    metrics_.false_negatives += static_cast<std::int64_t>(frame.truth.size()) - matched;
    metrics_.false_positives += static_cast<std::int64_t>(frame.tracks.size()) - matched;
    if (frame.truth.empty() || frame.tracks.empty()) return;
    std::vector<int> now(history_.size(), -1);
    for (const auto& pair : pairs) {
      now[frame.truth_index[pair.truth]] = frame.track_index[pair.track];
      distance_sum_m_ += frame.distance_m(pair.truth, pair.track);
    }
    for (std::size_t i = 0; i < history_.size(); ++i) advance(history_[i], now[i]);
  }

  ClearMetrics result() {
    for (const auto& object : history_) judge(object);
    const auto objects = metrics_.true_positives + metrics_.false_negatives;
    const auto errors =
        metrics_.false_negatives + metrics_.false_positives + metrics_.identity_switches;
    if (objects > 0) metrics_.mota = 1.0 - static_cast<double>(errors) / objects;
    if (metrics_.true_positives > 0) metrics_.motp_m = distance_sum_m_ / metrics_.true_positives;
    return metrics_;
  }

 private:
  void advance(ObjectHistory& object, int track) {
    if (track >= 0) {
      if (object.last_track >= 0 && object.last_track != track) metrics_.identity_switches += 1;
      if (object.previous_track < 0) object.starts += 1;
      object.matched += 1;
      object.last_track = track;
    }
    object.previous_track = track;
  }

  void judge(const ObjectHistory& object) {
    const double share = static_cast<double>(object.matched) / static_cast<double>(object.seen);
    (share > 0.8    ? metrics_.mostly_tracked
     : share >= 0.2 ? metrics_.partly_tracked
                    : metrics_.mostly_lost) += 1;
    metrics_.fragmentations += std::max<std::int64_t>(object.starts - 1, 0);
  }

  ClearMetrics metrics_;
  std::vector<ObjectHistory> history_;
  double distance_sum_m_ = 0;
};

}  // namespace

ClearMetrics clear_metrics(const Sequence& sequence,
                           const std::vector<std::vector<MatchedPair>>& matches) {
  ClearCount count(sequence);
  for (std::size_t k = 0; k < matches.size(); ++k) count.add(sequence.frames[k], matches[k]);
  return count.result();
}

}  // namespace scanfuse::evaluate
