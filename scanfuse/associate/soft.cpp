#include <cmath>

#include "scanfuse/associate/associate.hpp"

namespace scanfuse::associate {

void Associator::jpda(int tracks, int detections, std::span<const Candidate> candidates,
                      double unassigned_cost) {
  pairs_.clear();
  for (const Candidate& c : candidates) pairs_.push_back({c.track, c.detection, -c.cost / 2});
  JpdaOptions odds;  // P_D / (lambda (1 - P_D P_G)) = exp(unassigned_cost / 2)
  odds.detection_probability = 0.5;
  odds.gate_probability = 1;
  odds.clutter_density = std::exp(-unassigned_cost / 2);
  shares_ = &jpda_(tracks, detections, pairs_, odds);
  claimed_.assign(static_cast<std::size_t>(detections), 0);
  likeliest_.assign(static_cast<std::size_t>(tracks), 0);
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    const auto track = static_cast<std::size_t>(candidates[i].track);
    const auto detection = static_cast<std::size_t>(candidates[i].detection);
    const double share = shares_->pair[i];
    claimed_[detection] += share;
    if (claimed_[detection] > 0.5) assignment_.track_of_detection[detection] = candidates[i].track;
    if (share <= likeliest_[track] || shares_->missed[track] >= 0.5) continue;
    likeliest_[track] = share;
    assignment_.detection_of_track[track] = candidates[i].detection;
  }
}

}  // namespace scanfuse::associate
