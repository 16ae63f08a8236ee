#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "scanfuse/core/result.hpp"
#include "scanfuse/types/track.hpp"
#include "scanfuse/types/truth.hpp"

namespace scanfuse::io::mcap {

// Our own messages in JSON; docs/mcap.md describes them. Metres, seconds, radians.

[[nodiscard]] std::string tracks_json(const StepResult& step);      ///< scanfuse.Tracks
[[nodiscard]] std::string detections_json(const StepResult& step);  ///< scanfuse.Detections
[[nodiscard]] std::string truth_json(const TruthFrame& truth);      ///< scanfuse.Truth
/// foxglove.FrameTransform
[[nodiscard]] std::string transform_json(Time stamp, std::string_view parent,
                                         std::string_view child, const Pose3& parent_from_child);

/// Back from scanfuse.Tracks: tracks, poses, stamp, frame and sensor; no detections.
[[nodiscard]] Result<StepResult> tracks_from_json(std::span<const std::byte> bytes);
/// Back from scanfuse.Detections.
[[nodiscard]] Result<std::vector<Detection>> detections_from_json(std::span<const std::byte> bytes);
/// Back from scanfuse.Truth.
[[nodiscard]] Result<TruthFrame> truth_from_json(std::span<const std::byte> bytes);

/// The JSON schema of one of the messages above, or of foxglove.SceneUpdate, by its name.
[[nodiscard]] std::string_view json_schema(std::string_view name);

}  // namespace scanfuse::io::mcap
