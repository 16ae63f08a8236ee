#include "scanfuse/triangulate/pseudo_measurement.hpp"

namespace scanfuse::triangulate {

PseudoMeasurements pseudo_measurements(std::span<const PassiveSensor> sensors,
                                       const Eigen::Vector3d& position_m,
                                       const Eigen::Matrix3d& covariance_m2) {
  const auto rows = static_cast<Eigen::Index>(2 * sensors.size());
  PseudoMeasurements pseudo{Eigen::VectorXd(rows), {}};
  Eigen::MatrixX3d g(rows, 3);
  for (Eigen::Index s = 0; s < rows / 2; ++s) {
    const Direction seen = direction_to(sensors[static_cast<std::size_t>(s)], position_m);
    pseudo.mean_rad.segment<2>(2 * s) = Eigen::Vector2d(seen.azimuth_rad, seen.elevation_rad);
    g.middleRows<2>(2 * s) = seen.jacobian_rad_per_m;
  }
  pseudo.covariance_rad2 = g * covariance_m2 * g.transpose();
  return pseudo;
}

}  // namespace scanfuse::triangulate
