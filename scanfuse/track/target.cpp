#include "scanfuse/track/target.hpp"

#include <algorithm>
#include <numeric>

namespace scanfuse::track {

ObjectClass class_of(const Target& target) {
  const auto best = std::max_element(target.class_weight.begin(), target.class_weight.end());
  return static_cast<ObjectClass>(best - target.class_weight.begin());
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
  track.status = target.status;
  if (target.status == TrackStatus::kConfirmed && target.missed_frames > 0) {
    track.status = TrackStatus::kCoasting;
  }
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
