#pragma once

#include <Eigen/Core>
#include <optional>

#include "scanfuse/types/bearing.hpp"

namespace scanfuse::triangulate {

/// A bearing made ready: where it starts, where it points, how sharp it is. World frame.
///
/// What is compared is the point's direction in the plane that touches the unit sphere where the
/// bearing points, along `left` (growing azimuth) and `up` (growing elevation). For small errors
/// that is (cos(elevation) d azimuth, d elevation); unlike angles it stays smooth near the zenith
/// and where azimuth jumps by 2 pi.
struct LineOfSight {
  Eigen::Vector3d origin_m = Eigen::Vector3d::Zero();
  Eigen::Vector3d direction = Eigen::Vector3d::UnitX();  ///< unit; azimuth only: on the horizon
  Eigen::Vector3d left = Eigen::Vector3d::UnitY();
  Eigen::Vector3d up = Eigen::Vector3d::UnitZ();
  double sigma_left_rad = 0;
  double sigma_up_rad = 0;       ///< 0 where the sensor tells azimuth only
  double sigma_azimuth_rad = 0;  ///< as the sensor counts it, about its z axis
  double elevation_rad = 0;
  std::int32_t sensor = 0;
  [[nodiscard]] bool tells_elevation() const { return sigma_up_rad > 0; }
  [[nodiscard]] int dimensions() const { return tells_elevation() ? 2 : 1; }
  /// ln |2 pi R| / 2 in the tangent plane.
  [[nodiscard]] double log_spread() const;
};

[[nodiscard]] LineOfSight line_of_sight(const PassiveSensor& sensor, const Bearing& bearing);

/// Where a point is against a line of sight: (along left, along up) of its direction, and how that
/// changes with the point. Azimuth only: the second row is zero.
struct Sight {
  Eigen::Vector2d offset_rad = Eigen::Vector2d::Zero();
  Eigen::Matrix<double, 2, 3> jacobian_rad_per_m = Eigen::Matrix<double, 2, 3>::Zero();
};

/// Empty for a point at the sensor or behind it.
[[nodiscard]] std::optional<Sight> sight(const LineOfSight& line, const Eigen::Vector3d& point_m);

/// Azimuth and elevation of a point in a sensor's frame [Lu2015, eqs. 1-2, with atan2], and their
/// derivative by the point (2 x 3, world frame). At the sensor's zenith the derivative of azimuth
/// has no bound; it is cut at 1e9 rad/m.
struct Direction {
  double azimuth_rad = 0;
  double elevation_rad = 0;
  Eigen::Matrix<double, 2, 3> jacobian_rad_per_m = Eigen::Matrix<double, 2, 3>::Zero();
};
[[nodiscard]] Direction direction_to(const PassiveSensor& sensor, const Eigen::Vector3d& point_m);

/// Whether a sensor could see a point.
[[nodiscard]] bool in_field_of_view(const PassiveSensor& sensor, const Eigen::Vector3d& point_m);

}  // namespace scanfuse::triangulate
