#pragma once

#include <Eigen/LU>

#include "scanfuse/types/camera.hpp"

/// The inverse of Camera::project, and its derivatives.
namespace scanfuse::calibrate {

/// d(raw pixel) / d(normalised image point) at a normalised point (x/z, y/z).
[[nodiscard]] inline Eigen::Matrix2d distortion_jacobian(const Camera& c,
                                                         const Eigen::Vector2d& at) {
  const double x = at.x(), y = at.y(), r2 = x * x + y * y;
  const double q = 1 + r2 * (c.k1 + r2 * (c.k2 + r2 * c.k3));
  const double dq = 2 * (c.k1 + r2 * (2 * c.k2 + r2 * 3 * c.k3));  // dq/dx = dq * x
  Eigen::Matrix2d J;
  J << q + dq * x * x + 2 * c.p1 * y + 6 * c.p2 * x, dq * x * y + 2 * c.p1 * x + 2 * c.p2 * y,
      dq * x * y + 2 * c.p1 * x + 2 * c.p2 * y, q + dq * y * y + 6 * c.p1 * y + 2 * c.p2 * x;
  return Eigen::Vector2d(c.fx_px, c.fy_px).asDiagonal() * J;
}

/// The normalised image point (x/z, y/z) that is seen at a raw pixel, by Newton's method. Not
/// finite where the distortion cannot be inverted: far outside of the image.
[[nodiscard]] inline Eigen::Vector2d undistort(const Camera& camera,
                                               const Eigen::Vector2d& raw_px) {
  Eigen::Vector2d at((raw_px.x() - camera.cx_px) / camera.fx_px,
                     (raw_px.y() - camera.cy_px) / camera.fy_px);
  for (int k = 0; k < 12; ++k) {
    const Eigen::Vector2d miss = raw_px - camera.project({at.x(), at.y(), 1});
    const Eigen::Vector2d step = distortion_jacobian(camera, at).inverse() * miss;
    at += step;
    if (!(step.squaredNorm() > 1e-26)) break;
  }
  return at;
}

/// d(raw pixel) / d(point in the camera frame).
[[nodiscard]] inline Eigen::Matrix<double, 2, 3> projection_jacobian(const Camera& camera,
                                                                     const Eigen::Vector3d& p) {
  Eigen::Matrix<double, 2, 3> normalise;
  normalise << 1 / p.z(), 0, -p.x() / (p.z() * p.z()), 0, 1 / p.z(), -p.y() / (p.z() * p.z());
  return distortion_jacobian(camera, p.head<2>() / p.z()) * normalise;
}

}  // namespace scanfuse::calibrate
