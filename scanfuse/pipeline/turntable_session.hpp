#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "scanfuse/camera/calibrate_camera.hpp"
#include "scanfuse/camera/stripe.hpp"
#include "scanfuse/core/diagnostics.hpp"
#include "scanfuse/io/session/session_folder.hpp"
#include "scanfuse/types/image.hpp"
#include "scanfuse/types/turntable.hpp"

/// From the files of a turntable session to what a calibration works on: images decoded, boards and
/// stripes found, scans read.
namespace scanfuse::pipeline {

struct SessionLoadOptions {
  int threads = 0;
  camera::BoardOptions boards;
  camera::StripeOptions stripes;
  camera::CameraCalibrationOptions camera;
  /// Keep small copies of the images for a report, at most this wide; 0: none.
  int thumbnail_width_px = 0;
  /// Called with positions done and all; true asks to stop. From one thread at a time.
  std::function<bool(std::size_t, std::size_t)> progress;
};

/// A small copy of an image: `scale` of its pixels fit into one of the copy's.
struct Thumbnail {
  Image image;
  double scale = 1;
};

struct LoadedSession {
  TurntableFeatures features;                       ///< positions in order of their angle
  std::vector<io::LeftOut> left_out;                ///< positions (by number in `features`) and why
  std::optional<camera::CameraCalibration> camera;  ///< where it was calibrated from images
  Thumbnail board;
  std::vector<Thumbnail> stripes;  ///< one a position where thumbnails were asked for
  double seconds_files = 0;        ///< session.toml, scans, features.json
  double seconds_boards = 0;       ///< camera and board images
  double seconds_stripes = 0;
  bool stopped = false;
  Diagnostics diagnostics;
};

/// Reads a session and finds in its images what is to be found; positions that cannot be used are
/// listed with the reason and left without stripe or scan. The same files give the same result with
/// any number of threads. Errors: what concerns the whole session (no board image, a board of
/// another size, no camera, fewer than three positions).
[[nodiscard]] Result<LoadedSession> load_turntable_session(const std::filesystem::path& folder,
                                                           const SessionLoadOptions& options = {});

/// The camera from chessboard images of a folder. Images without the board are listed.
struct CameraFromImages {
  camera::CameraCalibration calibration;
  std::vector<std::filesystem::path> used;  ///< one for each of calibration.views
  std::vector<std::string> left_out;        ///< "img_3.png: ..."
};
[[nodiscard]] Result<CameraFromImages> calibrate_camera_from(
    const std::vector<std::filesystem::path>& images, const BoardSpec& board,
    const SessionLoadOptions& options = {});

}  // namespace scanfuse::pipeline
