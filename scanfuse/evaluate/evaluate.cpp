#include "scanfuse/evaluate/evaluate.hpp"

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
  return result;
}

}  // namespace scanfuse::evaluate
