#include "scanfuse/pipeline/topic_truth.hpp"

#include <algorithm>

#include "scanfuse/core/options.hpp"
#include "scanfuse/pipeline/frozen_poses.hpp"
#include "scanfuse/pipeline/pose_buffer.hpp"

namespace scanfuse::pipeline {
namespace {

constexpr Duration kShortestGap = std::chrono::milliseconds(100);

/// The poses of one object.
class ObjectPoses {
 public:
  void add(const PoseSample& sample) {
    stamps_.push_back(sample.stamp);
    poses_.add(sample.stamp, sample.pose);
    frozen_.add(sample.stamp, sample.pose);
  }
  [[nodiscard]] bool empty() const { return stamps_.empty(); }

  /// To be called once all are there.
  void finish() {
    std::ranges::sort(stamps_);
    std::vector<Duration> gaps;
    gaps.reserve(stamps_.size());
    for (std::size_t i = 1; i < stamps_.size(); ++i) gaps.push_back(stamps_[i] - stamps_[i - 1]);
    if (gaps.empty()) return;
    const auto middle = gaps.begin() + std::ssize(gaps) / 2;
    std::ranges::nth_element(gaps, middle);
    longest_gap_ = std::max(kShortestGap, 3 * *middle);
  }

  /// What keeps the pose at `stamp` from being known; empty where it is.
  [[nodiscard]] std::string_view trouble_at(Time stamp) const {
    const auto after = std::ranges::lower_bound(stamps_, stamp);
    if (after == stamps_.end()) return "scan without a true pose: after the last";
    const bool on_it = *after == stamp;
    if (!on_it && after == stamps_.begin()) return "scan without a true pose: before the first";
    if (!on_it && *after - *std::prev(after) > longest_gap_) {
      return "scan without a true pose: messages are missing";
    }
    return frozen_.frozen_since(stamp) ? "scan without a true pose: it is frozen"
                                       : std::string_view{};
  }

  [[nodiscard]] TruthObject at(Time stamp, const TopicTruthOptions& options) const {
    const Pose2 pose = poses_.at(stamp)->pose.planar();
    const auto twist = poses_.twist_at(stamp);
    const Eigen::Rotation2Dd turn(pose.heading_rad);
    const Eigen::Vector2d lever(-options.offset_m.y(), options.offset_m.x());
    TruthObject object;
    object.object_class = options.object_class;
    object.position_m = pose * options.offset_m;
    object.heading_rad = pose.heading_rad;
    object.velocity_m_per_s = turn * (Eigen::Vector2d(twist.speed_m_per_s, twist.lateral_m_per_s) +
                                      twist.yaw_rate_rad_per_s * lever);
    if (options.size_m) {
      object.length_m = options.size_m->x();
      object.width_m = options.size_m->y();
    }
    return object;
  }

 private:
  std::vector<Time> stamps_;
  PoseBuffer poses_;
  FrozenPoses frozen_;
  Duration longest_gap_ = kShortestGap;
};

Result<std::vector<ObjectPoses>> read_poses(io::RecordingReader& recording,
                                            const std::vector<std::string>& topics) {
  std::vector<std::string> known;
  for (const auto& topic : recording.info().topics) known.push_back(topic.name);
  const std::string name = recording.info().path.string();
  std::vector<ObjectPoses> objects(topics.size());
  while (true) {
    const auto event = recording.next();
    if (!event) return tl::unexpected(event.error());
    if (!*event) break;
    const auto* sample = std::get_if<PoseSample>(&(*event)->payload);
    if (sample == nullptr) continue;
    for (std::size_t k = 0; k < topics.size(); ++k) {
      if (topics[k] == (*event)->topic) objects[k].add(*sample);
    }
  }
  for (std::size_t k = 0; k < topics.size(); ++k) {
    if (objects[k].empty()) {
      return fail(Error::Code::kNotFound,
                  "{}: no pose in topic '{}'; did you mean '{}'? `scanfuse info` lists them", name,
                  topics[k], nearest_name(topics[k], known));
    }
    objects[k].finish();
  }
  return objects;
}

}  // namespace

Result<std::vector<TruthFrame>> truth_from_topics(io::RecordingReader& recording,
                                                  const TopicTruthOptions& options,
                                                  std::span<const StepResult> steps,
                                                  Diagnostics& diagnostics) {
  const auto objects = read_poses(recording, options.topics);
  if (!objects) return tl::unexpected(objects.error());
  std::vector<TruthFrame> frames;
  frames.reserve(steps.size());
  for (const auto& step : steps) {
    TruthFrame frame{step.stamp, step.frame, "world", {}};
    for (std::size_t k = 0; k < objects->size(); ++k) {
      const auto trouble = (*objects)[k].trouble_at(step.stamp);
      if (!trouble.empty()) {
        diagnostics.note(trouble, fmt::format("scan {}, {}", step.frame, options.topics[k]));
        break;
      }
      frame.objects.push_back((*objects)[k].at(step.stamp, options));
      frame.objects.back().id = static_cast<std::int64_t>(k) + 1;
    }
    if (frame.objects.size() == objects->size()) frames.push_back(std::move(frame));
  }
  if (frames.empty()) {
    return fail(Error::Code::kNotFound, "{}: no pose at the time of any scan of the tracks",
                recording.info().path.string());
  }
  return frames;
}

}  // namespace scanfuse::pipeline
