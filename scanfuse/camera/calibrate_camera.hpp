#pragma once

#include <Eigen/Core>
#include <limits>
#include <span>
#include <tuple>
#include <vector>

#include "scanfuse/camera/boards.hpp"
#include "scanfuse/core/options.hpp"
#include "scanfuse/core/result.hpp"
#include "scanfuse/geometry/pose.hpp"
#include "scanfuse/types/camera.hpp"

namespace scanfuse::camera {

struct CameraCalibrationOptions {
  int radial_terms = 2;
  bool tangential = false;
  double outlier_ratio = 4;

  static constexpr auto fields() {
    using O = CameraCalibrationOptions;
    return std::tuple{
        Field{"radial_terms", &O::radial_terms, 0, 3, "radial distortion: k1, k1 k2 or k1 k2 k3"},
        Field{"tangential", &O::tangential, false, true, "also estimate p1 and p2"},
        Field{"outlier_ratio", &O::outlier_ratio, 1.5, 100.0,
              "an image whose rms is this many times the median is left out"},
    };
  }
};

/// One view of a chessboard: what the calibration made of it.
struct CalibratedView {
  bool used = true;   ///< false: left out as an outlier
  double rms_px = 0;  ///< distance of corners from where the model puts them
  Pose3 camera_from_board;
};

/// Intrinsics, as estimated from views of chessboards.
struct CameraCalibration {
  Camera camera;
  double rms_px = 0;  ///< over the corners of all used views, both coordinates together
  std::vector<CalibratedView> views;  ///< one for each board given
  /// Covariance of fx, fy, cx, cy, k1, k2, p1, p2, k3 for independent corner errors of the size
  /// that the residuals show; rows of what was not estimated are zero.
  Eigen::Matrix<double, 9, 9> covariance = Eigen::Matrix<double, 9, 9>::Zero();
};

/// Calibrates a camera from one or more views of flat chessboards (sizes may differ between views).
/// Errors: fewer than 3 views, views that are all parallel to each other (the focal length is then
/// not determined), a board outside the image, a solution that is not finite.
[[nodiscard]] Result<CameraCalibration> calibrate_camera(
    std::span<const DetectedBoard> boards, int width_px, int height_px,
    const CameraCalibrationOptions& options = {});

}  // namespace scanfuse::camera
