#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "scanfuse/core/diagnostics.hpp"
#include "scanfuse/core/result.hpp"
#include "scanfuse/io/session/session_file.hpp"
#include "scanfuse/types/turntable.hpp"

/// The folder of a turntable session (docs/turntable-session.md).
namespace scanfuse::io {

/// The files of one angle of the turntable; empty paths are files that are not there.
struct SessionPosition {
  std::string name;  ///< "position 7"
  double turntable_rad = 0;
  std::filesystem::path stripe;
  std::filesystem::path stripe_off;  ///< the same view with the laser off
  std::filesystem::path scan;
};

struct SessionFolder {
  std::filesystem::path folder;
  SessionFile about;
  std::vector<std::filesystem::path> board_images;   ///< board*.png, in natural order
  std::vector<std::filesystem::path> camera_images;  ///< to calibrate the camera from
  std::vector<SessionPosition> positions;            ///< in the order of the angles in session.toml
  std::filesystem::path features;                    ///< features.json; empty: none
};

/// Lists a session. `stripe_0007.png`, `stripe_0007_off.png` and `scan_0007.csv` belong to the
/// eighth angle (JPEG does as well, and any number of digits). Errors: no session.toml, no angles,
/// a file whose number has no angle, two files of one number.
[[nodiscard]] Result<SessionFolder> open_session(const std::filesystem::path& folder);

/// Positions that could not be read, and why: "scan_0007.csv: ...".
struct LeftOut {
  std::size_t position = 0;
  std::string reason;
};

/// What a session holds besides its images: angles, boards, camera, scans, and everything of
/// features.json where it is there. Positions stay in order; one whose scan is missing or cannot be
/// used has an empty scan and is listed. An error in what all scans share (their unit) is an error.
struct SessionContent {
  TurntableFeatures features;
  std::vector<LeftOut> left_out;
  Diagnostics diagnostics;
};
[[nodiscard]] Result<SessionContent> read_session_content(const SessionFolder& session);

/// The images of a folder, or the one that `path` names; in natural order.
[[nodiscard]] Result<std::vector<std::filesystem::path>> list_images(
    const std::filesystem::path& path);

/// "stripe_0007.png" of the position counted 7.
[[nodiscard]] std::string numbered_name(std::string_view stem, std::size_t position,
                                        std::string_view ending);

}  // namespace scanfuse::io
