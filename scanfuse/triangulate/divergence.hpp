#pragma once

#include <Eigen/LU>
#include <cmath>

#include "scanfuse/types/gaussian.hpp"

/// How different two Gaussian densities are.
namespace scanfuse::triangulate {
namespace detail {

/// ln(|S| / (|P0|^(1 - alpha) |P1|^alpha)) and d' S^-1 d, S = alpha P1 + (1 - alpha) P0.
struct Mixed {
  double log_ratio = 0;
  double distance = 0;
};

template <int N>
Mixed mixed(const Gaussian<N>& p, const Gaussian<N>& q, double alpha) {
  const Eigen::Matrix<double, N, N> s = alpha * q.covariance + (1 - alpha) * p.covariance;
  const Eigen::Matrix<double, N, 1> d = p.mean - q.mean;
  return {std::log(s.determinant()) - (1 - alpha) * std::log(p.covariance.determinant()) -
              alpha * std::log(q.covariance.determinant()),
          d.dot(s.inverse() * d)};
}

}  // namespace detail

/// Kullback-Leibler divergence of p from q; 0 for equal ones.
template <int N>
[[nodiscard]] double kullback_leibler(const Gaussian<N>& p, const Gaussian<N>& q) {
  const Eigen::Matrix<double, N, N> inverse = q.covariance.inverse();
  const Eigen::Matrix<double, N, 1> d = p.mean - q.mean;
  return ((inverse * p.covariance).trace() + d.dot(inverse * d) - N +
          std::log(q.covariance.determinant() / p.covariance.determinant())) /
         2;
}

/// Renyi divergence of order alpha in (0, 1], with the ratio of determinants of [Lu2015, eq. 20]
/// turned right side up:
///   D = alpha / 2 d' S^-1 d - 1 / (2 (alpha - 1)) ln(|S| / (|P0|^(1 - alpha) |P1|^alpha)),
///   S = alpha P1 + (1 - alpha) P0, d = m0 - m1; 0 for equal ones. At 1: Kullback-Leibler.
template <int N>
[[nodiscard]] double renyi(const Gaussian<N>& p, const Gaussian<N>& q, double alpha) {
  if (alpha >= 1) return kullback_leibler(p, q);
  const auto m = detail::mixed(p, q, alpha);
  return alpha / 2 * m.distance + m.log_ratio / (2 * (1 - alpha));
}

/// As printed, 0 < alpha < 1: the ratio upside down, so that equal means with unlike covariances
/// give less than nothing.
template <int N>
[[nodiscard]] double renyi_literal(const Gaussian<N>& p, const Gaussian<N>& q, double alpha) {
  const auto m = detail::mixed(p, q, alpha);
  return alpha / 2 * m.distance - m.log_ratio / (2 * (1 - alpha));
}

/// (D(p || q) + D(q || p)) / 2 [Lu2015, eq. 21].
template <class Divergence, int N>
[[nodiscard]] double symmetric(Divergence&& divergence, const Gaussian<N>& p,
                               const Gaussian<N>& q) {
  return (divergence(p, q) + divergence(q, p)) / 2;
}

}  // namespace scanfuse::triangulate
