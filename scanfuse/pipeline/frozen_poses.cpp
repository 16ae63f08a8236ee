#include "scanfuse/pipeline/frozen_poses.hpp"

#include <algorithm>

namespace scanfuse::pipeline {
namespace {

constexpr int kTimesLonger = 3;
constexpr double kBrake_m_per_s2 = 8;

bool is_same(const Pose3& a, const Pose3& b) {
  return a.translation_m == b.translation_m && a.rotation.coeffs() == b.rotation.coeffs();
}

}  // namespace

void FrozenPoses::add(Time stamp, const Pose3& pose) {
  if (!run_ || !is_same(pose, pose_)) return start_run(stamp, pose);
  if (stamp < run_->to) return;
  run_->to = stamp;
  ++messages_;
  const Duration least = std::max(least_, kTimesLonger * longest_);
  if (!stopped_dead_ || messages_ < least_messages_ || run_->to - run_->from < least) return;
  if (!listed_) spans_.push_back(*run_);
  spans_.back().to = stamp;
  listed_ = true;
}

void FrozenPoses::start_run(Time stamp, const Pose3& pose) {
  if (run_ && stamp <= run_->to) return;
  const double dt = run_ ? to_seconds(stamp - run_->to) : 0;
  const double way_m = (pose.translation_m - pose_.translation_m).norm();
  if (run_ && stopped_dead_) longest_ = std::max(longest_, run_->to - run_->from);
  stopped_dead_ = run_ && way_m / dt > kBrake_m_per_s2 * dt;
  run_ = Span{stamp, stamp};
  pose_ = pose;
  messages_ = 1;
  listed_ = false;
}

std::optional<Time> FrozenPoses::frozen_since(Time stamp) const {
  const auto later =
      std::ranges::upper_bound(spans_, stamp, {}, [](const Span& span) { return span.from; });
  if (later == spans_.begin()) return std::nullopt;
  const Span& span = *std::prev(later);
  if (stamp <= span.from || stamp > span.to) return std::nullopt;
  return span.from;
}

}  // namespace scanfuse::pipeline
