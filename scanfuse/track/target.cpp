#include "scanfuse/track/target.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace scanfuse::track {

namespace {

bool tells_classes(const ClassProbabilities& p) {
  return std::any_of(p.begin(), p.end(), [](double value) { return value > 0; });
}

BeliefMotion motion_of(const Target& target) {
  const Eigen::Vector2d v = target.velocity_m_per_s();
  const double variance = target.state.covariance(kVx, kVx) + target.state.covariance(kVy, kVy);
  return {target.position_m(), v.norm(), std::sqrt(std::max(variance / 2, 0.0))};
}

}  // namespace

bool is_clutter(const Target& target) {
  return target.class_probability[static_cast<std::size_t>(ObjectClass::kOther)] > 0.5;
}

void believe(Target& target, const Detection& detection, Time stamp, const BeliefModel* model) {
  if (model == nullptr || !tells_classes(detection.class_probability)) return;
  target.belief.add({detection.class_probability, detection.cues, target.position_m(), stamp},
                    *model);
  target.class_probability = target.belief.probabilities(motion_of(target), *model);
}

ObjectClass class_of(const Target& target) {
  if (tells_classes(target.class_probability)) {
    const auto& p = target.class_probability;
    return static_cast<ObjectClass>(std::max_element(p.begin(), p.end()) - p.begin());
  }
  const auto best = std::max_element(target.class_weight.begin(), target.class_weight.end());
  return static_cast<ObjectClass>(best - target.class_weight.begin());
}

ObjectClass user_class_of(const Target& target) {
  if (!tells_classes(target.class_probability)) return class_of(target);
  const auto& p = target.class_probability;
  const auto other = p.begin() + static_cast<std::ptrdiff_t>(ObjectClass::kOther);
  return static_cast<ObjectClass>(std::max_element(p.begin(), other) - p.begin());
}

namespace {

/// Errors are counted from zero velocity then: E[v v'] = P + v v'.
void stand(Track& track) {
  Eigen::Vector4d v = track.state.mean;
  v(kX) = v(kY) = 0;
  track.state.covariance += v * v.transpose();
  track.state.mean -= v;
  track.speed_m_per_s = track.accel_m_per_s2 = track.yaw_rate_rad_per_s = 0;
}

}  // namespace

Track to_track(const Target& target, double moving_from) {
  Track track;
  track.id = target.id;
  track.object_class = class_of(target);
  // One imagined detection of no class keeps a young track from certainty.
  const double sum = std::accumulate(target.class_weight.begin(), target.class_weight.end(), 1.0);
  track.class_probability = target.class_weight[static_cast<std::size_t>(track.object_class)] / sum;
  if (tells_classes(target.class_probability)) {
    track.class_probability =
        target.class_probability[static_cast<std::size_t>(track.object_class)];
  }
  track.status = target.status;
  if (target.status == TrackStatus::kConfirmed && target.missed_frames > 0) {
    track.status = TrackStatus::kCoasting;
  }
  if (!target.is_trusted || is_clutter(target)) track.status = TrackStatus::kTentative;
  track.box = target.box();
  track.z_m = target.z_m;
  track.height_m = target.height_m;
  track.state.mean = target.state.mean.head<4>();
  track.state.covariance = target.state.covariance.topLeftCorner<4, 4>();
  track.speed_m_per_s = target.velocity_m_per_s().norm();
  track.accel_m_per_s2 = target.accel_m_per_s2;
  track.yaw_rate_rad_per_s = target.heading.mean(1);
  track.moving_probability = target.moving;
  const bool stands = target.status == TrackStatus::kConfirmed && target.moving < moving_from;
  if (stands) stand(track);
  track.age_frames = target.age_frames;
  track.missed_frames = target.missed_frames;
  track.detection = target.detection;
  track.nis = target.nis;
  return track;
}

}  // namespace scanfuse::track
