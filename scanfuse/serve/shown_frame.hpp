#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "scanfuse/pipeline/perception.hpp"
#include "scanfuse/types/track.hpp"
#include "scanfuse/types/truth.hpp"

namespace scanfuse::serve {

/// A return as the viewer draws it, world frame.
struct ShownPoint {
  Eigen::Vector3d position_m = Eigen::Vector3d::Zero();
  float intensity = 0;
  std::uint16_t cluster = 0;  ///< 0: in none, else 1 + its number
  std::uint8_t layer = 0;
};

/// A straight part of an outline, world frame.
struct ShownLine {
  Eigen::Vector2d first_m = Eigen::Vector2d::Zero();
  Eigen::Vector2d last_m = Eigen::Vector2d::Zero();
  std::uint32_t cluster = 0;
};

/// A line of sight of a sensor that tells directions, world frame.
struct ShownRay {
  Eigen::Vector3d from_m = Eigen::Vector3d::Zero();
  Eigen::Vector3d to_m = Eigen::Vector3d::Zero();
  std::uint32_t sensor = 0;
  std::int32_t target = -1;  ///< of the same scan; -1: taken for a false alarm
};

/// What of a rig an edge belongs to.
enum class RigPart : std::uint32_t { kCamera, kAxis, kLidar, kBoard };

/// A straight line of a rig, world frame.
struct ShownEdge {
  Eigen::Vector3d from_m = Eigen::Vector3d::Zero();
  Eigen::Vector3d to_m = Eigen::Vector3d::Zero();
  RigPart part = RigPart::kCamera;
};

/// Everything the viewer draws of one scan. `step` stands in the world frame.
struct ShownFrame {
  StepResult step;
  std::uint32_t sensor = 0;  ///< its number among the sensors seen
  std::vector<ShownPoint> points;
  std::vector<std::int32_t> detection_of_cluster;  ///< -1: none was made of it
  std::vector<ShownLine> lines;
  std::vector<ShownRay> rays;
  std::vector<ShownEdge> edges;
};

/// The number of the cluster that each return belongs to, plus one; 0 for those in none. A return
/// stands with the point of the virtual scan that stands for its bearing if it lies within 0.5 m of
/// that point's range.
[[nodiscard]] std::vector<std::uint16_t> label_returns(const pipeline::PosedScan& posed,
                                                       const VirtualScan& flat,
                                                       const Clusters& clusters);

/// The returns in the world, each at the time it was fired, so that what stands still is straight.
[[nodiscard]] std::vector<ShownPoint> place_returns(const pipeline::PosedScan& posed);

/// What `perception` made of the scan in its last step. `scale` as in PipelineOptions.
[[nodiscard]] ShownFrame show(const pipeline::PosedScan& posed, const StepResult& step,
                              const pipeline::Perception& perception, double scale);

/// A step in the world frame, whatever its frame was.
[[nodiscard]] StepResult in_world(StepResult step);

}  // namespace scanfuse::serve
