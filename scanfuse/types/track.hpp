#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "scanfuse/core/time.hpp"
#include "scanfuse/geometry/box.hpp"
#include "scanfuse/types/detection.hpp"
#include "scanfuse/types/gaussian.hpp"
#include "scanfuse/types/object_class.hpp"
#include "scanfuse/types/truth.hpp"

namespace scanfuse {

enum class TrackStatus { kTentative, kConfirmed, kCoasting };

constexpr auto choices(TrackStatus) {
  using enum TrackStatus;
  return std::array{std::pair{"tentative", kTentative}, std::pair{"confirmed", kConfirmed},
                    std::pair{"coasting", kCoasting}};
}

/// What is reported of one object at one scan: a value, detached from the filter behind it.
/// In the output frame (world by default); over ground.
struct Track {
  std::int64_t id = 0;
  ObjectClass object_class = ObjectClass::kUnknown;
  double class_probability = 0;
  TrackStatus status = TrackStatus::kTentative;
  Box2 box;
  double z_m = 0;
  double height_m = 0;
  /// x, vx, y, vy (m, m/s): the state order of [Lu2018].
  Gaussian<4> state;
  double speed_m_per_s = 0;
  double moving_probability = 0.5;  ///< that it moves, and does not only seem to
  double accel_m_per_s2 = 0;
  double yaw_rate_rad_per_s = 0;
  int age_frames = 0;
  int missed_frames = 0;
  int detection = -1;  ///< index of the detection folded in at this scan, -1 when none
  double nis = 0;      ///< innovation' S^-1 innovation of that detection, 2 degrees of freedom
};

/// Everything that one scan gave: what writers, reports and metrics take.
struct StepResult {
  Time stamp;
  std::int64_t frame = 0;
  std::string sensor;
  Pose3 world_from_ego;
  Pose3 ego_from_sensor;
  std::string coordinate_frame = "world";  ///< the output frame: "world" or "ego"
  std::vector<Detection> detections;       ///< in the output frame
  std::vector<Track> tracks;               ///< in the output frame
};

}  // namespace scanfuse
