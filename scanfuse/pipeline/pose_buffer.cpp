#include "scanfuse/pipeline/pose_buffer.hpp"

#include <algorithm>

namespace scanfuse::pipeline {
namespace {

double share(Time from, Time to, Time stamp) {
  return to_seconds(stamp - from) / to_seconds(to - from);
}

}  // namespace

void PoseBuffer::add(Time stamp, const Pose3& pose) {
  const auto place = samples_.begin() + static_cast<std::ptrdiff_t>(first_after(stamp));
  if (place != samples_.begin() && std::prev(place)->stamp == stamp) {
    std::prev(place)->pose = pose;
  } else {
    samples_.insert(place, Sample{stamp, pose});
  }
}

std::size_t PoseBuffer::first_after(Time stamp) const {
  const auto later = [](Time t, const Sample& sample) { return t < sample.stamp; };
  return static_cast<std::size_t>(std::upper_bound(samples_.begin(), samples_.end(), stamp, later) -
                                  samples_.begin());
}

std::optional<PoseBuffer::Found> PoseBuffer::at(Time stamp) const {
  if (samples_.empty()) return std::nullopt;
  if (samples_.size() == 1) return Found{samples_[0].pose, samples_[0].stamp != stamp};
  const bool outside = stamp < samples_.front().stamp || stamp > samples_.back().stamp;
  const Time reached =
      std::clamp(stamp, samples_.front().stamp - kReach, samples_.back().stamp + kReach);
  const std::size_t after = std::clamp<std::size_t>(first_after(reached), 1, samples_.size() - 1);
  const Sample& a = samples_[after - 1];
  const Sample& b = samples_[after];
  return Found{interpolate(a.pose, b.pose, share(a.stamp, b.stamp, reached)), outside};
}

PoseBuffer::Twist PoseBuffer::twist_at(Time stamp) const {
  if (samples_.size() < 2) return {};
  // A baseline of several samples where they come fast: differences of noisy neighbours are
  // useless.
  constexpr auto kHalfBase = std::chrono::milliseconds(50);
  std::size_t after = std::clamp<std::size_t>(first_after(stamp), 1, samples_.size() - 1);
  std::size_t before = after - 1;
  while (before > 0 && stamp - samples_[before].stamp < kHalfBase) --before;
  while (after + 1 < samples_.size() && samples_[after].stamp - stamp < kHalfBase) ++after;
  const double dt = to_seconds(samples_[after].stamp - samples_[before].stamp);
  const Pose2 step = samples_[before].pose.planar().inverse() * samples_[after].pose.planar();
  // Over the baseline the axes turned by half the step on average.
  const Pose2 half{0, 0, step.heading_rad / 2};
  const Eigen::Vector2d moved = half.inverse() * Eigen::Vector2d(step.x_m, step.y_m);
  return {moved.x() / dt, moved.y() / dt, step.heading_rad / dt};
}

bool PoseBuffer::covers(Time stamp) const {
  return !samples_.empty() && samples_.back().stamp >= stamp;
}

void PoseBuffer::forget_before(Time stamp) {
  while (samples_.size() > 2 && samples_[1].stamp < stamp) samples_.pop_front();
}

}  // namespace scanfuse::pipeline
