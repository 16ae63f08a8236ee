#include "scanfuse/track/lost.hpp"

#include <vector>

#include "scanfuse/track/steps.hpp"

namespace scanfuse::track {

void LostTargets::keep(const Target& target) {
  if (target.is_known && target.is_trusted) targets_.push_back(target);
}

void LostTargets::advance(Time stamp, double dt_s, const TrackerOptions& options) {
  predict(targets_, dt_s, options);
  std::erase_if(targets_, [&](const Target& target) {
    return to_seconds(stamp - target.seen) > options.lost_s || is_vague(target, options);
  });
}

std::optional<Target> LostTargets::find(const Detection& detection, const TrackerOptions& options) {
  auto best = targets_.end();
  double least = unassigned_cost(options);
  for (auto target = targets_.begin(); target != targets_.end(); ++target) {
    const auto cost = pair_cost(*target, detection, options);
    if (!cost || *cost >= least || !are_alike(*target, detection)) continue;
    least = *cost;
    best = target;
  }
  if (best == targets_.end()) return std::nullopt;
  std::optional<Target> found(*best);
  targets_.erase(best);
  found->is_trusted = false;
  found->status = TrackStatus::kTentative;
  found->history = 0;
  found->age_frames = 0;
  return found;
}

}  // namespace scanfuse::track
