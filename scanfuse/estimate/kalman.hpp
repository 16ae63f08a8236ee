#pragma once

#include <Eigen/Dense>
#include <cmath>

#include "scanfuse/geometry/angles.hpp"
#include "scanfuse/types/gaussian.hpp"

/// The linear Kalman filter as free functions on beliefs: Gaussian in, Gaussian out.
namespace scanfuse::estimate {

/// What a measurement says against what was expected of it.
template <int M>
struct Innovation {
  Eigen::Matrix<double, M, 1> residual;    ///< z - H x
  Eigen::Matrix<double, M, M> covariance;  ///< S = H P H' + R

  /// residual' S^-1 residual, chi-square with M degrees of freedom when model and data agree.
  [[nodiscard]] double nis() const { return residual.dot(covariance.inverse() * residual); }
  [[nodiscard]] double log_det() const { return std::log(covariance.determinant()); }
  /// ln N(residual; 0, S) = -(nis + ln det S + M ln 2 pi) / 2
  [[nodiscard]] double log_likelihood() const {
    return -0.5 * (nis() + log_det() + M * std::log(2.0 * kPi));
  }
};

/// Moves a belief one step on:
///
///   x- = F x               [Lu2018, eqs 6, 16]
///   P- = F P F' + Q        [Lu2018, eq. 8] prints no Q: pass zero for the literal filter
template <int N>
[[nodiscard]] Gaussian<N> predict(const Gaussian<N>& x, const Eigen::Matrix<double, N, N>& F,
                                  const Eigen::Matrix<double, N, N>& Q) {
  return {F * x.mean, F * x.covariance * F.transpose() + Q};
}

/// Compares a measurement z = H x + v, v ~ N(0, z.covariance), with the belief x [Lu2018, eq. 7].
template <int N, int M>
[[nodiscard]] Innovation<M> innovation(const Gaussian<N>& x, const Gaussian<M>& z,
                                       const Eigen::Matrix<double, M, N>& H) {
  return {z.mean - H * x.mean, H * x.covariance * H.transpose() + z.covariance};
}

/// Moves a belief by what a measurement said; R is the measurement's covariance, positive definite.
///
///   S  = H P H' + R                        innovation covariance
///   K  = P H' S^-1                         Kalman gain [Lu2018, eq. 9]
///   x+ = x + K (z - H x)                   [Lu2018, eq. 10]
///   P+ = (I - K H) P (I - K H)' + K R K'   Joseph form, not [Lu2018, eq. 11], which loses symmetry
///                                          and definiteness by rounding; equal in exact arithmetic
template <int N, int M>
[[nodiscard]] Gaussian<N> correct(const Gaussian<N>& x, const Innovation<M>& nu,
                                  const Eigen::Matrix<double, M, M>& R,
                                  const Eigen::Matrix<double, M, N>& H) {
  using State = Eigen::Matrix<double, N, N>;
  const Eigen::Matrix<double, N, M> K =
      x.covariance * H.transpose() * nu.covariance.inverse().eval();
  const State A = State::Identity() - K * H;
  const State P = A * x.covariance * A.transpose() + K * R * K.transpose();
  return {x.mean + K * nu.residual, 0.5 * (P + P.transpose())};
}

/// Folds a measurement z = H x + v, v ~ N(0, z.covariance), into the belief x.
template <int N, int M>
[[nodiscard]] Gaussian<N> update(const Gaussian<N>& x, const Gaussian<M>& z,
                                 const Eigen::Matrix<double, M, N>& H) {
  return correct(x, innovation(x, z, H), z.covariance, H);
}

/// As `update`, but the states from `considered` on keep their mean and variance; what they share
/// with the others is kept up to date (Schmidt's consider filter: the gain rows are zero, the
/// Joseph form holds for any gain). For parameters that a measurement depends on but should not
/// teach.
template <int N, int M>
[[nodiscard]] Gaussian<N> update_considering(const Gaussian<N>& x, const Gaussian<M>& z,
                                             const Eigen::Matrix<double, M, N>& H, int considered) {
  using State = Eigen::Matrix<double, N, N>;
  const Innovation<M> nu = innovation(x, z, H);
  Eigen::Matrix<double, N, M> K = x.covariance * H.transpose() * nu.covariance.inverse().eval();
  K.bottomRows(N - considered).setZero();
  const State A = State::Identity() - K * H;
  const State P = A * x.covariance * A.transpose() + K * z.covariance * K.transpose();
  return {x.mean + K * nu.residual, 0.5 * (P + P.transpose())};
}

/// error' P^-1 error: normalised estimation error squared of a belief against the truth.
template <int N>
[[nodiscard]] double nees(const Gaussian<N>& belief, const Eigen::Matrix<double, N, 1>& truth) {
  const Eigen::Matrix<double, N, 1> error = truth - belief.mean;
  return error.dot(belief.covariance.ldlt().solve(error));
}

}  // namespace scanfuse::estimate
