#pragma once

#include <cmath>

#include "scanfuse/core/random.hpp"
#include "scanfuse/estimate/ctra.hpp"

/// Truth that moves as the model of ctra.hpp says, and measurements of its position.
namespace scanfuse::estimate {

inline CtraVector draw(const Gaussian<6>& belief, RandomStream& random) {
  CtraVector unit;
  for (double& entry : unit) entry = random.normal();
  // A covariance may be singular: by its eigenvectors, not by Cholesky.
  const Eigen::SelfAdjointEigenSolver<CtraMatrix> eigen(belief.covariance);
  const CtraVector sigma = eigen.eigenvalues().cwiseMax(0).cwiseSqrt();
  return belief.mean + eigen.eigenvectors() * sigma.cwiseProduct(unit);
}

inline CtraVector moved(const CtraVector& truth, double dt_s, const CtraNoise& noise,
                        RandomStream& random) {
  return draw({ctra_transition(truth, dt_s).mean, ctra_noise(truth, dt_s, noise)}, random);
}

inline Gaussian<2> measured_position(const CtraVector& truth, double sigma_m,
                                     RandomStream& random) {
  return {{truth(0) + random.normal(0, sigma_m), truth(1) + random.normal(0, sigma_m)},
          sigma_m * sigma_m * Eigen::Matrix2d::Identity()};
}

inline Gaussian<6> start_of_ctra(double v, double a, double w) {
  Gaussian<6> start;
  start.mean << 5, -3, 0.4, v, a, w;
  const CtraVector sigma = (CtraVector() << 0.3, 0.3, 0.05, 1, 0.5, 0.05).finished();
  start.covariance = sigma.cwiseAbs2().asDiagonal();
  return start;
}

}  // namespace scanfuse::estimate
