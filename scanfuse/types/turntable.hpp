#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <array>
#include <limits>
#include <string>
#include <vector>

#include "scanfuse/geometry/pose.hpp"
#include "scanfuse/types/camera.hpp"

namespace scanfuse {

/// A chessboard, counted by its inner corners. Board frame: origin at the first corner, x along a
/// row, y along a column, z = x cross y; corner (row, column) lies at (column, row) * square.
struct BoardSpec {
  int rows = 0;
  int columns = 0;
  double square_m = 0;
};

/// One return of a 2D lidar. Lidar frame [Liu2023, sec. 1.4]: x at angle 0, y at 90 degrees.
struct BeamReturn {
  double angle_rad = 0;
  double range_m = 0;  ///< NaN where nothing came back
  double intensity = std::numeric_limits<double>::quiet_NaN();
};

/// What was seen at one angle of the turntable.
struct TurntablePosition {
  std::string name;          ///< for messages: the file it came from
  double turntable_rad = 0;  ///< as commanded
  /// Points on the centre line of the laser stripe on each board, raw image (distorted) pixels.
  std::array<std::vector<Eigen::Vector2d>, 2> stripe_px;
  std::vector<BeamReturn> scan;  ///< ascending in angle
};

/// All that a turntable calibration works on, after detection in images [Liu2023].
struct TurntableFeatures {
  Camera camera;
  std::array<BoardSpec, 2> boards;
  /// Corners in row-major order, raw image (distorted) pixels.
  std::array<std::vector<Eigen::Vector2d>, 2> corners_px;
  std::vector<TurntablePosition> positions;
};

/// A 2D lidar on a turntable, seen from a camera that does not turn.
struct Rig {
  Eigen::Vector3d axis_direction = Eigen::Vector3d::UnitZ();  ///< unit, camera frame
  Eigen::Vector3d axis_point_m = Eigen::Vector3d::Zero();     ///< the point nearest to the camera
  Pose3 camera_from_lidar;                                    ///< at turntable angle 0
  double range_bias_m = 0;  ///< true range = measured range - bias
  double angle_scale = 1;   ///< true turn = scale * commanded turn

  /// Small changes, in this order: axis direction along u and v, axis point along u and v, lidar
  /// rotation (camera frame, left: exp(w) R), lidar translation, range bias, angle scale; u and v
  /// are the columns of axis_basis(axis_direction). Rows of what was not estimated are zero.
  static constexpr int kParameters = 12;
  Eigen::Matrix<double, kParameters, kParameters> covariance =
      Eigen::Matrix<double, kParameters, kParameters>::Zero();

  /// The arc that was calibrated; beyond it the covariance extrapolates.
  double first_turntable_rad = 0;
  double last_turntable_rad = 0;

  /// Where the lidar is at an angle of the turntable.
  [[nodiscard]] Pose3 pose(double turntable_rad) const {
    const Eigen::Quaterniond turn(Eigen::AngleAxisd(angle_scale * turntable_rad, axis_direction));
    const Pose3 about_axis{turn, axis_point_m - turn * axis_point_m};
    return about_axis * camera_from_lidar;
  }
};

/// Two unit vectors u, v that make u, v, n a right-handed frame; smooth but for n = -z.
[[nodiscard]] inline Eigen::Matrix<double, 3, 2> axis_basis(const Eigen::Vector3d& n) {
  const Eigen::Quaterniond turn = turn_z_to(n);
  Eigen::Matrix<double, 3, 2> basis;
  basis << turn * Eigen::Vector3d::UnitX(), turn * Eigen::Vector3d::UnitY();
  return basis;
}

/// A point of an assembled cloud, with where it came from.
struct CloudPoint {
  Eigen::Vector3d position_m = Eigen::Vector3d::Zero();
  double intensity = std::numeric_limits<double>::quiet_NaN();
  int profile = -1;  ///< which scan; -1: not known
  int beam = -1;     ///< which beam of the scan, counted by its angle; -1: not known
};

}  // namespace scanfuse
