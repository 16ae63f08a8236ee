#pragma once

#include <string>
#include <utility>
#include <vector>

#include "scanfuse/io/ros/encode.hpp"
#include "scanfuse/types/track.hpp"

namespace scanfuse::io::ros {

/// visualization_msgs/msg/MarkerArray: everything before is deleted, then a box and a name for each
/// confirmed or coasting track, coloured by class [Okabe2008], paler while it coasts. In the frame
/// that the step's results stand in.
[[nodiscard]] EncodedMessage encode_markers(const StepResult& step);

/// vision_msgs/msg/Detection3DArray (vision_msgs 4): each confirmed or coasting track with its box,
/// its id, and one hypothesis: class by name, probability, the pose again with its covariance (x
/// and y of the position; what is 0 is not known). In the frame that the step's results stand in.
[[nodiscard]] EncodedMessage encode_detections(const StepResult& step);

/// The tracks as edges of tf: from the frame of the results to "track_ID", at the boxes' centres.
[[nodiscard]] std::vector<TransformSample> track_transforms(const StepResult& step);

/// What diagnostic_msgs/msg/DiagnosticStatus calls its level.
enum class DiagnosticLevel : std::uint8_t { kOk = 0, kWarn = 1, kError = 2, kStale = 3 };

struct DiagnosticStatus {
  DiagnosticLevel level = DiagnosticLevel::kOk;
  std::string name;
  std::string message;
  std::vector<std::pair<std::string, std::string>> values;
};

/// diagnostic_msgs/msg/DiagnosticArray.
[[nodiscard]] EncodedMessage encode_diagnostics(Time stamp,
                                                const std::vector<DiagnosticStatus>& status);

}  // namespace scanfuse::io::ros
