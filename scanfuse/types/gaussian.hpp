#pragma once

#include <Eigen/Core>

namespace scanfuse {

/// A belief about N numbers: mean and symmetric positive definite covariance.
template <int N>
struct Gaussian {
  Eigen::Matrix<double, N, 1> mean = Eigen::Matrix<double, N, 1>::Zero();
  Eigen::Matrix<double, N, N> covariance = Eigen::Matrix<double, N, N>::Identity();
};

}  // namespace scanfuse
