#pragma once

#include <Eigen/Core>

#include "scanfuse/types/gaussian.hpp"

/// The constant-velocity model in the plane. State x, vx, y, vy (m, m/s): the order of [Lu2018].
namespace scanfuse::estimate {

/// A of [Lu2018, eq. 12].
[[nodiscard]] inline Eigen::Matrix4d constant_velocity_transition(double dt_s) {
  Eigen::Matrix4d A = Eigen::Matrix4d::Identity();
  A(0, 1) = A(2, 3) = dt_s;
  return A;
}

/// H of [Lu2018, eq. 13]: position is seen, velocity is not.
[[nodiscard]] inline Eigen::Matrix<double, 2, 4> position_of_constant_velocity() {
  Eigen::Matrix<double, 2, 4> H = Eigen::Matrix<double, 2, 4>::Zero();
  H(0, 0) = H(1, 2) = 1;
  return H;
}

/// What white acceleration adds in dt, per axis
///
///   Q = sigma_a^2 [ dt^3/3  dt^2/2 ; dt^2/2  dt ]      [BarShalom2001, eq. 6.2.2-4]
///
/// sigma_a^2 is a power density (m^2/s^3): sigma_a is the standard deviation, in m/s, that velocity
/// gains in one second. Written so, and not with an acceleration held over each step, because two
/// half steps then give exactly the Q of one whole step, whatever the rate of the sensor.
[[nodiscard]] inline Eigen::Matrix4d constant_velocity_noise(double dt_s, double sigma_a) {
  const double q = sigma_a * sigma_a;
  Eigen::Matrix2d axis;
  axis << dt_s * dt_s * dt_s / 3, dt_s * dt_s / 2, dt_s * dt_s / 2, dt_s;
  Eigen::Matrix4d Q = Eigen::Matrix4d::Zero();
  Q.topLeftCorner<2, 2>() = Q.bottomRightCorner<2, 2>() = q * axis;
  return Q;
}

/// P of [Lu2018, eq. 14]: the covariance of position z_2 and velocity (z_2 - z_1) / dt when each
/// position has standard deviation sigma_p. The paper calls sigma_p process noise; it is the
/// measurement noise of the start. dt_s > 0.
[[nodiscard]] inline Eigen::Matrix4d two_point_covariance(double sigma_p_m, double dt_s) {
  const double variance = sigma_p_m * sigma_p_m;
  Eigen::Matrix2d axis;
  axis << 1, 1 / dt_s, 1 / dt_s, 2 / (dt_s * dt_s);
  Eigen::Matrix4d P = Eigen::Matrix4d::Zero();
  P.topLeftCorner<2, 2>() = P.bottomRightCorner<2, 2>() = variance * axis;
  return P;
}

/// Belief after two position measurements, one dt_s > 0 after the other [Lu2018, eq. 14].
[[nodiscard]] inline Gaussian<4> start_from_two_points(const Eigen::Vector2d& earlier_m,
                                                       const Eigen::Vector2d& later_m,
                                                       double sigma_p_m, double dt_s) {
  const Eigen::Vector2d velocity = (later_m - earlier_m) / dt_s;
  return {{later_m.x(), velocity.x(), later_m.y(), velocity.y()},
          two_point_covariance(sigma_p_m, dt_s)};
}

/// Belief after one position measurement, with a velocity of zero mean and deviation sigma_v. For a
/// wide sigma_v the next update gives what `start_from_two_points` gives.
[[nodiscard]] inline Gaussian<4> start_from_one_point(const Gaussian<2>& position_m,
                                                      double sigma_v_m_per_s) {
  Gaussian<4> start;
  start.mean << position_m.mean.x(), 0, position_m.mean.y(), 0;
  const double v = sigma_v_m_per_s * sigma_v_m_per_s;
  const Eigen::Matrix2d& R = position_m.covariance;
  start.covariance << R(0, 0), 0, R(0, 1), 0, 0, v, 0, 0, R(1, 0), 0, R(1, 1), 0, 0, 0, 0, v;
  return start;
}

}  // namespace scanfuse::estimate
