#include "scanfuse/estimate/kalman.hpp"
#include "scanfuse/track/steps.hpp"

namespace scanfuse::track {

std::span<const Gaussian<kStates>> mixed_states(std::span<const Target> targets,
                                                std::span<const Detection> detections,
                                                std::span<const associate::Candidate> candidates,
                                                const associate::Marginals& shares,
                                                const TrackerOptions& options,
                                                Workspace& workspace) {
  auto& mixed = workspace.mixed;
  mixed.resize(targets.size());
  for (std::size_t t = 0; t < targets.size(); ++t) {
    mixed[t].mean.setZero();  // until the end: how far the mean moves
    mixed[t].covariance = shares.missed[t] * targets[t].state.covariance;
  }
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    const auto t = static_cast<std::size_t>(candidates[i].track);
    const Target& target = targets[t];
    const double share = shares.pair[i];
    if (share <= 0) continue;
    const Measurement m =
        measure(detections[static_cast<std::size_t>(candidates[i].detection)], target, options);
    const auto one = estimate::update_considering(target.state, m.position, m.H, kLength);
    const StateVector moved = one.mean - target.state.mean;
    mixed[t].mean += share * moved;
    mixed[t].covariance += share * (one.covariance + moved * moved.transpose());
  }
  for (std::size_t t = 0; t < targets.size(); ++t) {
    mixed[t].covariance -= mixed[t].mean * mixed[t].mean.transpose();
    mixed[t].mean += targets[t].state.mean;
  }
  return mixed;
}

}  // namespace scanfuse::track
