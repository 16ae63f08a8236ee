#pragma once

#include <Eigen/Core>
#include <limits>

#include "scanfuse/estimate/extended_kalman.hpp"

/// Constant turn rate and acceleration in the plane [Schubert2008], [Guo, section 3]. State
///
///   x, y      m             position, in a frame that stands still
///   psi       rad           heading
///   v, a      m/s, m/s^2    speed and acceleration along the heading, over ground; v < 0:
///   backwards w         rad/s         turn rate
///
/// in this order. All dt_s >= 0.
namespace scanfuse::estimate {

namespace ctra {
enum State : int { kX, kY, kHeading, kSpeed, kAccel, kYawRate, kStates };
inline constexpr Angles kAngles = Angles::at(kHeading);
}  // namespace ctra

using CtraVector = Eigen::Matrix<double, ctra::kStates, 1>;
using CtraMatrix = Eigen::Matrix<double, ctra::kStates, ctra::kStates>;

/// How turn rate and acceleration fade while nothing is seen: w(t) = w exp(-t / tau), a likewise.
/// Infinite: they stay, frozen, as in the plain model. A second or so for the turn rate keeps a
/// target that was lost in a bend from circling on.
struct Fade {
  double yaw_rate_tau_s = std::numeric_limits<double>::infinity();
  double accel_tau_s = std::numeric_limits<double>::infinity();
};

/// What white noise adds to a component in one second (standard deviation); the square is a power
/// density. The model of constant turn rate and acceleration has white jerk (`accel`) and white yaw
/// acceleration (`yaw_rate`); the first two serve models that hold a or w at zero.
struct CtraNoise {
  double heading_rad = 0;         ///< white turn rate
  double speed_m_per_s = 0;       ///< white acceleration
  double accel_m_per_s2 = 0;      ///< white jerk
  double yaw_rate_rad_per_s = 0;  ///< white yaw acceleration
};

/// One step. With T = dt, th = w T, c = cos psi, s = sin psi and the moments of turn_moments.hpp
///
///   x' = x + v T (c A0 - s B0) + a T^2 (c A1 - s B1)
///   y' = y + v T (s A0 + c B0) + a T^2 (s A1 + c B1)
///   psi' = psi + th,  v' = v + a T,  a' = a,  w' = w
///
/// and the slope F, of which
///
///   dx'/dw = -v T^2 (s A1 + c B1) - a T^3 (s A2 + c B2)
///   dy'/dw =  v T^2 (c A1 - s B1) + a T^3 (c A2 - s B2)
///
/// The heading comes back as psi + th, not wrapped.
[[nodiscard]] Transition<6> ctra_transition(const CtraVector& x, double dt_s);

/// The same with turn rate and acceleration that fade. No closed form: Gauss-Legendre quadrature
/// along the path, exact to rounding. Equals the plain step where nothing fades.
[[nodiscard]] Transition<6> ctra_transition(const CtraVector& x, double dt_s, const Fade& fade);

/// What the noise adds in a step that starts at x, to first order about the path without noise:
///
///   Q = int_0^T Phi(T, t) G D G' Phi(T, t)' dt,   Phi(T, t) = df(x(t), T - t)/dx
///
/// by Gauss-Legendre quadrature (positive weights, so Q is positive semidefinite whatever the
/// rounding). The path and Phi compose, so two half steps leave the P of one whole step.
[[nodiscard]] CtraMatrix ctra_noise(const CtraVector& x, double dt_s, const CtraNoise& noise,
                                    const Fade& fade = {});

/// Moves a belief on; its heading comes back wrapped.
[[nodiscard]] Gaussian<6> predict_ctra(const Gaussian<6>& x, double dt_s, const CtraNoise& noise,
                                       const Fade& fade = {});

/// The same motion told with the heading reversed: psi + pi, -v, -a; P with the signs of v and a
/// turned. Twice is nothing, and it commutes with every step.
[[nodiscard]] Gaussian<6> flip_heading(const Gaussian<6>& x);

/// Flips a belief that drives backwards faster than `backward_m_per_s` >= 0. What was started with
/// the heading the wrong way round is put right, what manoeuvres in reverse is left alone.
[[nodiscard]] Gaussian<6> settle_heading(const Gaussian<6>& x, double backward_m_per_s = 0.5);

/// H of a measured position.
[[nodiscard]] Eigen::Matrix<double, 2, 6> position_of_ctra();

/// x, vx, y, vy of a state: the order of constant_velocity.hpp and of tracks.
[[nodiscard]] Eigen::Vector4d velocity_of_ctra(const CtraVector& x);

/// Mean and covariance of that over a belief. Exact for a Gaussian belief, not to first order: at
/// rest v psi says nothing of the motion across, and the first order would be sure that there is
/// none. With sigma^2, tau^2, kappa the variances of psi, v and their covariance
///
///   E[v e^(i psi)]     = (v + i kappa) e^(i psi - sigma^2/2)
///   E[v^2 e^(2 i psi)] = ((v + 2 i kappa)^2 + tau^2) e^(2 i psi - 2 sigma^2)
///   cov(x, g) = cov(x, v) E[dg/dv] + cov(x, psi) E[dg/dpsi]      for g = v e^(i psi)
[[nodiscard]] Gaussian<4> velocity_of_ctra(const Gaussian<6>& x);

/// Constant turn rate and velocity: x, y, psi, v, w, which is the model above with a = 0.
namespace ctrv {
enum State : int { kX, kY, kHeading, kSpeed, kYawRate, kStates };
inline constexpr Angles kAngles = Angles::at(kHeading);
}  // namespace ctrv

using CtrvVector = Eigen::Matrix<double, ctrv::kStates, 1>;
using CtrvMatrix = Eigen::Matrix<double, ctrv::kStates, ctrv::kStates>;

[[nodiscard]] Transition<5> ctrv_transition(const CtrvVector& x, double dt_s);

/// White acceleration and white yaw acceleration (`speed_m_per_s`, `yaw_rate_rad_per_s`); white
/// turn rate where asked for. `accel_m_per_s2` has no component to act on and is left out.
[[nodiscard]] CtrvMatrix ctrv_noise(const CtrvVector& x, double dt_s, CtraNoise noise);

}  // namespace scanfuse::estimate
