#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "scanfuse/triangulate/line_of_sight.hpp"

namespace scanfuse::triangulate {

/// A sensor's constant offset: what it tells less what is true, in its own frame.
struct SensorBias {
  double azimuth_rad = 0;
  double elevation_rad = 0;
  double sigma_azimuth_rad = 0;    ///< as wide as before the first bearing: not observable
  double sigma_elevation_rad = 0;  ///< 0 where the sensor tells azimuth only
};

/// The offsets of all sensors at once, from bearings joined to one target each.
///
/// The lines of one target, seen from any point x near it, are off by
///
///   r = A b + v - J dx        b: offsets, v ~ N(0, R), dx: where the target really is
///
/// W = R^-1 - R^-1 J (J' R^-1 J)^-1 J' R^-1 has W J = 0, so that W r = W (A b + v) whatever dx:
/// nothing is assumed of the target, what it teaches is independent from scan to scan, and the
/// estimate is a recursive least squares  L += A' W A,  e += A' W r,  b = L^-1 e  that starts
/// with N(0, sigma^2). Two sensors leave one equation a target, three leave three (azimuth only:
/// none and one). Not observable: what moves no line off another, such as a turn about the baseline
/// of two sensors; its sigma stays as at the start.
class BiasFilter {
 public:
  BiasFilter(std::span<const PassiveSensor> sensors, double sigma_rad);

  /// Lines as measured, no offset taken off. Lines that leave `position_m` behind or the target's
  /// place open teach nothing.
  void learn(std::span<const LineOfSight> lines, const Eigen::Vector3d& position_m);
  [[nodiscard]] std::vector<SensorBias> biases() const;

 private:
  Eigen::MatrixXd information_;
  Eigen::VectorXd evidence_;
  std::vector<bool> tells_elevation_;
};

/// A bearing without its sensor's offset.
[[nodiscard]] Bearing without_bias(Bearing bearing, const SensorBias& bias);

}  // namespace scanfuse::triangulate
