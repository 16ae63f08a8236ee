#pragma once

#include <Eigen/Core>

#include "scanfuse/geometry/pose.hpp"
#include "scanfuse/types/scan.hpp"

namespace scanfuse::preprocess {

/// The scan turned into the levelled sensor frame: origin at the sensor, axes of the ego frame (x
/// forward, z up). The translation of `ego_from_sensor` is not applied. The beam pattern follows a
/// turn about z; with roll or pitch its columns no longer are bearings, and it is dropped.
[[nodiscard]] Scan level(Scan scan, const Pose3& ego_from_sensor);

/// Moves every return to where it would have been seen at the scan's stamp by a sensor that travels
/// with the ego vehicle: its twist at the ego origin is constant during the sweep. Beam columns
/// keep the beam's own direction. Static world becomes straight; objects keep their own motion.
[[nodiscard]] Scan deskew(Scan scan, const Eigen::Vector2d& velocity_ego_m_per_s,
                          double yaw_rate_rad_per_s, const Pose3& ego_from_sensor);

}  // namespace scanfuse::preprocess
