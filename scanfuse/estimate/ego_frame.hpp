#pragma once

#include <Eigen/Dense>
#include <cmath>

#include "scanfuse/estimate/ctra.hpp"
#include "scanfuse/estimate/turn_moments.hpp"

/// Tracking in the frame of a vehicle that drives: x forward, y left of it, heading against its
/// own; speeds, accelerations and turn rates stay over ground. A filter here and one in an odometry
/// frame agree to rounding when the ego motion is known; the odometry frame is the simpler home.
namespace scanfuse::estimate {

/// Ego motion over the step from k-1 to k, constant within it: the control of [Guo, eq. 3]. A
/// sample taken at k-1 or k alone does not stand for the step: interpolate the ego motion.
struct EgoControl {
  double speed_m_per_s = 0;
  double yaw_rate_rad_per_s = 0;
};

/// A step of the target over ground, told in the new ego frame.
template <int N>
struct EgoTransition {
  Transition<N> step;
  Eigen::Matrix<double, N, N> turn;  ///< d(told in the new frame)/d(told in the old one)
  Eigen::Matrix<double, N, 2> B;     ///< d x_k / d(v_e, w_e)
};

/// Takes a step in the old ego frame, held still, and tells its end in the new one:
///
///   p' = R(-dpsi_e) (p - dp_e)      psi' = psi - dpsi_e      the rest as it is
///   dpsi_e = w_e T                  dp_e = v_e T (A0, B0), moments of w_e T
///   F = turn F_ground               turn = diag(R(-dpsi_e), I)
///   dp'/dv_e = -R(-dpsi_e) T (A0, B0)
///   dp'/dw_e = T (p'_y, -p'_x) - R(-dpsi_e) v_e T^2 (-B1, A1)      dpsi'/dw_e = -T
///
/// for states that start with x, y, psi.
template <int N>
[[nodiscard]] EgoTransition<N> seen_from_ego(const Transition<N>& over_ground,
                                             const EgoControl& ego, double dt_s) {
  const double T = dt_s, dpsi = ego.yaw_rate_rad_per_s * T;
  const TurnMoments m = turn_moments(dpsi);
  const Eigen::Matrix2d R = Eigen::Rotation2Dd(-dpsi).toRotationMatrix();
  const Eigen::Vector2d way = T * Eigen::Vector2d(m.A0, m.B0);
  const Eigen::Vector2d way_by_rate = ego.speed_m_per_s * T * T * Eigen::Vector2d(-m.B1, m.A1);

  EgoTransition<N> f{over_ground, Eigen::Matrix<double, N, N>::Identity(),
                     Eigen::Matrix<double, N, 2>::Zero()};
  const Eigen::Vector2d p = R * (over_ground.mean.template head<2>() - ego.speed_m_per_s * way);
  f.turn.template topLeftCorner<2, 2>() = R;
  f.step.mean.template head<2>() = p;
  f.step.mean(2) -= dpsi;
  f.step.F = f.turn * over_ground.F;
  f.B.template topRows<2>() << -R * way, T * Eigen::Vector2d(p.y(), -p.x()) - R * way_by_rate;
  f.B(2, 1) = -T;
  return f;
}

/// x- = f(x, u), P- = F P F' + turn Q turn' + B U B'; Q of the step over ground, U the covariance
/// of the control (held over the step). Zero for U when the ego motion is known.
template <int N>
[[nodiscard]] Gaussian<N> predict(const Gaussian<N>& x, const EgoTransition<N>& f,
                                  const Eigen::Matrix<double, N, N>& Q, const Eigen::Matrix2d& U) {
  const Eigen::Matrix<double, N, N> noise =
      f.turn * Q * f.turn.transpose() + f.B * U * f.B.transpose();
  return predict<N>(x, f.step, noise, Angles::at(2));
}

/// [Guo, eq. 3] as printed: x, y, alpha, v, a in the ego frame, ego speed and yaw rate as control.
/// The text names the model after a constant turn rate, but the state has none: the target keeps
/// its direction over ground. v and a are over ground, as a linear transition needs. The paper has
/// x lateral and y forward; here x is forward and y left, as everywhere.
[[nodiscard]] EgoTransition<5> guo_transition(const Eigen::Matrix<double, 5, 1>& x,
                                              const EgoControl& ego, double dt_s);

/// Process noise over ground, to be handed to `predict`; the paper prints none. White jerk, and a
/// white turn rate in place of the missing state. `yaw_rate_rad_per_s` is left out.
[[nodiscard]] Eigen::Matrix<double, 5, 5> guo_noise(const Eigen::Matrix<double, 5, 1>& x,
                                                    double dt_s, CtraNoise noise);

}  // namespace scanfuse::estimate
