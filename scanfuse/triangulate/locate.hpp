#pragma once

#include <Eigen/Core>
#include <optional>
#include <span>

#include "scanfuse/triangulate/line_of_sight.hpp"
#include "scanfuse/types/gaussian.hpp"

/// A position from lines of sight: the paper's least squares and what is made of it. World frame,
/// metres.
namespace scanfuse::triangulate {

/// [Lu2015, eqs. 9-12]: the point of least sum of squared distances to the planes that each azimuth
/// and each elevation spans, all weighed alike. Where the planes leave a direction open (azimuths
/// alone say nothing of height, parallel lines nothing of range) it stays near the middle of the
/// sensors. Works for one line or more.
[[nodiscard]] Eigen::Vector3d least_squares(std::span<const LineOfSight> lines);

/// Covariance of `least_squares` as printed [Lu2015, eq. 13]: only Y(m) is taken to be noisy, so
/// that the result changes with the origin of coordinates. For comparison.
[[nodiscard]] Eigen::Matrix3d covariance_literal(std::span<const LineOfSight> lines);

/// The same with the noise of Y(m) - H(m) X, which the equation really has: to first order
/// diag(sigma_azimuth^2 r_horizontal^2, sigma_elevation^2 r^2) a sensor.
[[nodiscard]] Eigen::Matrix3d covariance_corrected(std::span<const LineOfSight> lines,
                                                   const Eigen::Vector3d& position_m);

/// Where the target most likely is.
struct Location {
  Eigen::Vector3d position_m = Eigen::Vector3d::Zero();
  Eigen::Matrix3d covariance_m2 = Eigen::Matrix3d::Identity();  ///< the Cramer-Rao bound there
  double chi2 = 0;  ///< of the lines, and of the prior where one was given
  int iterations = 0;
  bool converged = false;
};

/// Maximum likelihood by Gauss-Newton in the tangent planes of the lines, from `start_m`. The
/// covariance is (sum J' R^-1 J)^-1. A prior counts as one more measurement. Empty where no minimum
/// in front of all sensors was found, or where the lines leave a direction open.
[[nodiscard]] std::optional<Location> most_likely(std::span<const LineOfSight> lines,
                                                  const Eigen::Vector3d& start_m,
                                                  const Gaussian<3>* prior = nullptr);

/// The same from `least_squares`.
[[nodiscard]] std::optional<Location> most_likely(std::span<const LineOfSight> lines,
                                                  const Gaussian<3>* prior = nullptr);

}  // namespace scanfuse::triangulate
