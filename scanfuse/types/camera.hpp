#pragma once

#include <Eigen/Core>

namespace scanfuse {

/// A pinhole camera with radial and tangential distortion (Brown), as OpenCV numbers it.
/// Camera frame: x right, y down, z forward; the centre of the top-left pixel is (0, 0).
///
///   x' = x/z, y' = y/z, r2 = x'^2 + y'^2, q = 1 + k1 r2 + k2 r2^2 + k3 r2^3
///   u = fx (x' q + 2 p1 x' y' + p2 (r2 + 2 x'^2)) + cx
///   v = fy (y' q + p1 (r2 + 2 y'^2) + 2 p2 x' y') + cy
struct Camera {
  int width_px = 0;
  int height_px = 0;
  double fx_px = 0;
  double fy_px = 0;
  double cx_px = 0;
  double cy_px = 0;
  double k1 = 0;
  double k2 = 0;
  double p1 = 0;
  double p2 = 0;
  double k3 = 0;

  /// Image point of a point in the camera frame; only z > 0 has a meaning.
  [[nodiscard]] Eigen::Vector2d project(const Eigen::Vector3d& p) const {
    const double x = p.x() / p.z(), y = p.y() / p.z();
    const double r2 = x * x + y * y;
    const double q = 1 + r2 * (k1 + r2 * (k2 + r2 * k3));
    return {fx_px * (x * q + 2 * p1 * x * y + p2 * (r2 + 2 * x * x)) + cx_px,
            fy_px * (y * q + p1 * (r2 + 2 * y * y) + 2 * p2 * x * y) + cy_px};
  }
};

}  // namespace scanfuse
