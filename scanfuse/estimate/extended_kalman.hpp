#pragma once

#include <Eigen/Dense>
#include <cstdint>

#include "scanfuse/estimate/kalman.hpp"

/// The extended Kalman filter: what kalman.hpp does, for motions and measurements that bend, and
/// for vectors some of whose components are angles. [BarShalom2001, section 10.3]
namespace scanfuse::estimate {

/// Which components of a vector are angles in rad, known up to whole turns. `Angles::at(2, 4)`.
struct Angles {
  std::uint32_t bits = 0;

  template <class... Index>
  [[nodiscard]] static constexpr Angles at(Index... index) {
    return {((std::uint32_t{1} << static_cast<unsigned>(index)) | ... | 0U)};
  }
  [[nodiscard]] constexpr bool contains(int index) const { return (bits >> index & 1U) != 0; }
};

/// The same vector with its angles in [-pi, pi).
template <int N>
[[nodiscard]] Eigen::Matrix<double, N, 1> wrapped(Eigen::Matrix<double, N, 1> x, Angles angles) {
  for (int i = 0; i < N; ++i) {
    if (angles.contains(i)) x(i) = wrap_pi(x(i));
  }
  return x;
}

/// Where a motion takes the mean, and its slope there: f(x) and F = df/dx.
template <int N>
struct Transition {
  Eigen::Matrix<double, N, 1> mean;
  Eigen::Matrix<double, N, N> F;
};

/// What a measurement should be, and its slope: h(x) and H = dh/dx, at the mean of the belief.
template <int N, int M>
struct Expectation {
  Eigen::Matrix<double, M, 1> mean;
  Eigen::Matrix<double, M, N> H;
};

/// The expectation of a linear measurement.
template <int N, int M>
[[nodiscard]] Expectation<N, M> expect(const Gaussian<N>& x, const Eigen::Matrix<double, M, N>& H) {
  return {H * x.mean, H};
}

/// x- = f(x), P- = F P F' + Q, symmetric to the last bit; angles come back wrapped.
template <int N>
[[nodiscard]] Gaussian<N> predict(const Gaussian<N>& x, const Transition<N>& f,
                                  const Eigen::Matrix<double, N, N>& Q, Angles angles = {}) {
  const Eigen::Matrix<double, N, N> P = f.F * x.covariance * f.F.transpose() + Q;
  return {wrapped<N>(f.mean, angles), 0.5 * (P + P.transpose())};
}

/// z - h(x), angles wrapped, and S = H P H' + R.
template <int N, int M>
[[nodiscard]] Innovation<M> innovation(const Gaussian<N>& x, const Gaussian<M>& z,
                                       const Expectation<N, M>& h, Angles angles_of_z = {}) {
  const Eigen::Matrix<double, M, 1> residual = z.mean - h.mean;
  return {wrapped<M>(residual, angles_of_z), h.H * x.covariance * h.H.transpose() + z.covariance};
}

/// Folds in z = h(x) + v, v ~ N(0, z.covariance): the update of kalman.hpp with the residual
/// z - h(x), Joseph form. z.covariance must be positive definite.
template <int N, int M>
[[nodiscard]] Gaussian<N> update(const Gaussian<N>& x, const Gaussian<M>& z,
                                 const Expectation<N, M>& h, Angles angles_of_x = {},
                                 Angles angles_of_z = {}) {
  Gaussian<N> after = correct(x, innovation(x, z, h, angles_of_z), z.covariance, h.H);
  after.mean = wrapped<N>(after.mean, angles_of_x);
  return after;
}

}  // namespace scanfuse::estimate
