#pragma once

#include <Eigen/Core>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "scanfuse/core/diagnostics.hpp"
#include "scanfuse/core/result.hpp"
#include "scanfuse/io/recording.hpp"
#include "scanfuse/types/track.hpp"
#include "scanfuse/types/truth.hpp"

namespace scanfuse::pipeline {

struct TopicTruthOptions {
  std::vector<std::string> topics;  ///< PoseStamped, PoseWithCovarianceStamped, Odometry
  ObjectClass object_class = ObjectClass::kVehicle;
  std::optional<Eigen::Vector2d> size_m;  ///< length, width
  /// Centre of the box from the pose, along the object's own axes.
  Eigen::Vector2d offset_m = Eigen::Vector2d::Zero();
};

/// Truth at the stamps of the steps, in the frame of the topics ("world"): one object a topic, with
/// ids 1, 2, ... in their order, its pose interpolated between messages. A step gives a frame only
/// where every object's pose is known: between two messages (no farther apart than 0.1 s or three
/// times the usual) and not frozen; all others are counted in `diagnostics`. An error where a topic
/// has no pose, or none at any step.
[[nodiscard]] Result<std::vector<TruthFrame>> truth_from_topics(io::RecordingReader& recording,
                                                                const TopicTruthOptions& options,
                                                                std::span<const StepResult> steps,
                                                                Diagnostics& diagnostics);

}  // namespace scanfuse::pipeline
