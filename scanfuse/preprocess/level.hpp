#pragma once

#include <Eigen/Core>

#include "scanfuse/geometry/pose.hpp"
#include "scanfuse/types/scan.hpp"

namespace scanfuse::preprocess {

/// The scan turned into the levelled sensor frame: origin at the sensor, axes of the ego frame (x
/// forward, z up). The translation of `ego_from_sensor` is not applied. The beam pattern follows a
/// turn about z; with roll or pitch its columns no longer are bearings, and it is dropped.
[[nodiscard]] Scan level(Scan scan, const Pose3& ego_from_sensor);

}  // namespace scanfuse::preprocess
