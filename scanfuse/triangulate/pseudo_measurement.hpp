#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "scanfuse/triangulate/line_of_sight.hpp"

namespace scanfuse::triangulate {

/// What each sensor would measure of a target at an uncertain position [Lu2015, eqs. 14-18]:
/// azimuth and elevation of sensor after sensor, N sensors, with the full 2N x 2N covariance
/// g P g'. The print writes it block diagonal (eq. 15), which its own eq. 18 contradicts.
struct PseudoMeasurements {
  Eigen::VectorXd mean_rad;
  Eigen::MatrixXd covariance_rad2;
};
[[nodiscard]] PseudoMeasurements pseudo_measurements(std::span<const PassiveSensor> sensors,
                                                     const Eigen::Vector3d& position_m,
                                                     const Eigen::Matrix3d& covariance_m2);

}  // namespace scanfuse::triangulate
