#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "scanfuse/core/result.hpp"
#include "scanfuse/types/turntable.hpp"

/// `session.toml`, the file that says what a turntable session is about
/// (docs/turntable-session.md).
namespace scanfuse::io {

/// How scan files are to be understood.
struct LidarConventions {
  double angle_unit_rad = kPi / 180;      ///< radians of one unit of angle
  double range_unit_m = 1;                ///< metres of one unit of range
  bool clockwise = false;                 ///< angles grow clockwise, seen from the lidar's z
  double zero_rad = 0;                    ///< added to angles, after the direction is applied
  std::vector<double> invalid_ranges{0};  ///< codes, in the file's unit; negative ranges always are
  double min_range_m = 0.01;
  double max_range_m = 100;
  std::string recording;  ///< one file with all scans instead of scan_0000.csv; empty: none
};

/// A chessboard of a session.
struct SessionBoard {
  BoardSpec spec;
  std::string image;  ///< of this board alone; empty: the session's board*.png show both
};

/// Images to calibrate the camera from.
struct CameraImages {
  std::string folder;
  BoardSpec board;
};

/// session.toml as read. The parts that a file leaves out are absent: a folder of scans to assemble
/// needs neither camera nor boards.
struct SessionFile {
  std::optional<Camera> camera;
  std::optional<CameraImages> camera_images;
  std::vector<SessionBoard> boards;   ///< none or two
  std::vector<double> turntable_rad;  ///< one angle for each position; may be empty
  LidarConventions lidar;
};

/// Errors name line and column: unknown keys, values out of range, a camera given twice, a board
/// count other than two, angles in both forms.
[[nodiscard]] Result<SessionFile> parse_session_file(std::string_view text,
                                                     const std::string& name);
[[nodiscard]] Result<SessionFile> read_session_file(const std::filesystem::path& path);

/// As text that reads back as the same.
[[nodiscard]] std::string session_file_text(const SessionFile& session);

}  // namespace scanfuse::io
