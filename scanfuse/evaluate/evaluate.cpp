#include "scanfuse/evaluate/evaluate.hpp"

#include <algorithm>

#include "scanfuse/geometry/overlap.hpp"

namespace scanfuse::evaluate {
namespace {

struct ClassCount {
  std::int64_t truth = 0;
  std::int64_t tracks = 0;
  std::int64_t right = 0;
};

std::optional<double> share_of(std::int64_t part, std::int64_t whole) {
  if (whole == 0) return std::nullopt;
  return static_cast<double>(part) / static_cast<double>(whole);
}

void score_classes(const Sequence& sequence, const std::vector<std::vector<MatchedPair>>& matches,
                   Evaluation& result) {
  std::map<ObjectClass, ClassCount> counts;
  for (std::size_t k = 0; k < matches.size(); ++k) {
    const auto& frame = sequence.frames[k];
    for (const auto& object : frame.truth) counts[object.object_class].truth += 1;
    for (const auto& track : frame.tracks) counts[track.object_class].tracks += 1;
    for (const auto& pair : matches[k]) {
      const auto is = frame.truth[pair.truth].object_class;
      const auto said = frame.tracks[pair.track].object_class;
      result.confusion[is][said] += 1;
      if (is == said) counts[is].right += 1;
    }
  }
  for (const auto& [name, count] : counts) {
    result.detection[name] = {share_of(count.right, count.tracks),
                              share_of(count.right, count.truth)};
  }
}

void follow(const Sequence& sequence, const std::vector<std::vector<MatchedPair>>& matches,
            Evaluation& result) {
  std::int64_t ghosts = 0;
  for (std::size_t k = 0; k < matches.size(); ++k) {
    const auto& frame = sequence.frames[k];
    ghosts += static_cast<std::int64_t>(frame.tracks.size() - matches[k].size());
    for (const auto& pair : matches[k]) {
      result.followed_by[frame.truth[pair.truth].id].push_back(
          {frame.frame, frame.tracks[pair.track].id});
    }
  }
  result.ghosts_per_frame = share_of(ghosts, result.frames);
}

bool moves_where_nothing_is(const Track& track, const ScoredFrame& frame,
                            const EvaluateOptions& options) {
  if (!(track.speed_m_per_s > options.ghost_speed_m_per_s)) return false;
  return std::ranges::none_of(frame.truth, [&](const TruthObject& object) {
    return (object.position_m - track.box.centre_m).norm() <= options.ghost_distance_m;
  });
}

void count_ghost_movers(const Sequence& sequence, const EvaluateOptions& options,
                        Evaluation& result) {
  std::int64_t ghosts = 0;
  for (const auto& frame : sequence.frames) {
    ghosts += std::ranges::count_if(
        frame.tracks, [&](const Track& t) { return moves_where_nothing_is(t, frame, options); });
  }
  result.ghost_movers_per_frame = share_of(ghosts, result.frames);
}

void time_confirmations(const Sequence& sequence,
                        const std::vector<std::vector<MatchedPair>>& matches, Evaluation& result) {
  std::vector<std::optional<Time>> first_seen(sequence.truth_ids.size());
  std::vector<std::optional<double>> waited_s(sequence.truth_ids.size());
  for (std::size_t k = 0; k < matches.size(); ++k) {
    const auto& frame = sequence.frames[k];
    for (const int object : frame.truth_index) {
      auto& first = first_seen[static_cast<std::size_t>(object)];
      if (!first) first = frame.stamp;
    }
    for (const auto& pair : matches[k]) {
      const auto object =
          static_cast<std::size_t>(frame.truth_index[static_cast<std::size_t>(pair.truth)]);
      if (!waited_s[object]) waited_s[object] = to_seconds(frame.stamp - *first_seen[object]);
    }
  }
  std::vector<double> all;
  for (const auto& wait : waited_s) {
    if (wait) all.push_back(*wait);
  }
  if (all.empty()) return;
  const auto middle = all.begin() + std::ssize(all) / 2;
  std::nth_element(all.begin(), middle, all.end());
  result.time_to_confirm_s = *middle;
}

void average_overlap(const Sequence& sequence, const std::vector<std::vector<MatchedPair>>& matches,
                     Evaluation& result) {
  double sum = 0;
  std::int64_t count = 0;
  for (std::size_t k = 0; k < matches.size(); ++k) {
    const auto& frame = sequence.frames[k];
    for (const auto& pair : matches[k]) {
      const auto box = box_of(frame.truth[static_cast<std::size_t>(pair.truth)]);
      if (!box) continue;
      sum += intersection_over_union(*box, frame.tracks[static_cast<std::size_t>(pair.track)].box);
      ++count;
    }
  }
  if (count > 0) result.bev_iou = sum / static_cast<double>(count);
}

}  // namespace

std::vector<FollowedBy> Evaluation::identities_of(std::int64_t truth_id) const {
  const auto found = followed_by.find(truth_id);
  return found == followed_by.end() ? std::vector<FollowedBy>{} : found->second;
}

Evaluation evaluate(std::span<const StepResult> steps, std::span<const TruthFrame> truth,
                    const EvaluateOptions& options) {
  const Sequence sequence = make_sequence(steps, truth, options);
  EvaluateOptions wide = options;
  wide.match_similarity = 0;
  const auto near = match_frames(sequence, wide);

  Evaluation result;
  result.frames = static_cast<std::int64_t>(sequence.frames.size());
  result.clear = clear_metrics(sequence, match_frames(sequence, options));
  result.identity = identity_metrics(sequence, options);
  result.hota = hota_metrics(sequence, options);
  result.sets = set_metrics(sequence, options);
  result.rmse = rmse_metrics(sequence, near);
  result.consistency = consistency_metrics(sequence, near);
  score_classes(sequence, near, result);
  follow(sequence, near, result);
  result.average = average_metrics(sequence, options);
  result.detection_by_range = metrics_by_range(sequence, near, options.ring_m);
  count_ghost_movers(sequence, options, result);
  time_confirmations(sequence, near, result);
  average_overlap(sequence, near, result);
  return result;
}

}  // namespace scanfuse::evaluate
