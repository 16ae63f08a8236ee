#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "scanfuse/core/result.hpp"
#include "scanfuse/types/turntable.hpp"

/// `rig.toml`: a calibrated lidar on a turntable (docs/turntable-session.md).
namespace scanfuse::io {

/// A rig, and the camera that saw it where the file names one.
struct RigFile {
  Rig rig;
  std::optional<Camera> camera;
};

/// Errors name line and column: an axis that is no unit vector, a rotation that is none, a
/// covariance that is not symmetric or not positive semidefinite. Small departures (1e-6) are
/// mended.
[[nodiscard]] Result<RigFile> parse_rig(std::string_view text, const std::string& name);
[[nodiscard]] Result<RigFile> read_rig(const std::filesystem::path& path);

/// As text that reads back as the same numbers.
[[nodiscard]] std::string rig_text(const RigFile& file);
[[nodiscard]] Result<void> write_rig(const std::filesystem::path& path, const RigFile& file);

}  // namespace scanfuse::io
