#include "scanfuse/triangulate/point_filter.hpp"

#include <Eigen/Dense>
#include <cmath>

namespace scanfuse::triangulate {
namespace {

using Vector6 = Eigen::Matrix<double, 6, 1>;
using Matrix6 = Eigen::Matrix<double, 6, 6>;

Matrix6 symmetric(const Matrix6& P) { return 0.5 * (P + P.transpose()); }

int dimensions(std::span<const LineOfSight> lines) {
  int sum = 0;
  for (const LineOfSight& line : lines) sum += line.dimensions();
  return sum;
}

/// Where a state is against all lines, and the slope; `complete` without a line behind its sensor.
struct Stack {
  Eigen::VectorXd offset;
  Eigen::Matrix<double, Eigen::Dynamic, 3> slope;
  Eigen::VectorXd noise;  ///< variances
  bool complete = true;
};

Stack stack(std::span<const LineOfSight> lines, const Eigen::Vector3d& position_m) {
  const int n = dimensions(lines);
  Stack all{Eigen::VectorXd::Zero(n), Eigen::Matrix<double, Eigen::Dynamic, 3>::Zero(n, 3),
            Eigen::VectorXd::Ones(n)};
  int row = 0;
  for (const LineOfSight& line : lines) {
    const auto seen = sight(line, position_m);
    all.complete = all.complete && seen.has_value();
    const std::array sigmas{line.sigma_left_rad, line.sigma_up_rad};
    for (int k = 0; k < line.dimensions(); ++k, ++row) {
      const double sigma = sigmas[static_cast<std::size_t>(k)];
      all.noise(row) = sigma * sigma;
      if (!seen) continue;  // offset and slope 0: says nothing
      all.offset(row) = seen->offset_rad(k);
      all.slope.row(row) = seen->jacobian_rad_per_m.row(k);
    }
  }
  return all;
}

}  // namespace

Gaussian<6> predict_point(const Gaussian<6>& point, double dt_s, double sigma_accel,
                          double sigma_accel_z) {
  Matrix6 F = Matrix6::Identity();
  F.topRightCorner<3, 3>() = dt_s * Eigen::Matrix3d::Identity();
  const Eigen::Vector3d q(sigma_accel * sigma_accel, sigma_accel * sigma_accel,
                          sigma_accel_z * sigma_accel_z);
  const Eigen::Matrix3d density = q.asDiagonal();
  Matrix6 Q;
  Q << density * (dt_s * dt_s * dt_s / 3), density * (dt_s * dt_s / 2), density * (dt_s * dt_s / 2),
      density * dt_s;
  return {F * point.mean, symmetric(F * point.covariance * F.transpose() + Q)};
}

Gaussian<3> place_of(const Gaussian<6>& point) {
  return {point.mean.head<3>(), point.covariance.topLeftCorner<3, 3>()};
}

/// x+ = x + K (-h(x_i) - H (x - x_i)), K = P H' (H P H' + R)^-1, Joseph form
/// [BarShalom2001, section 10.5]; a measurement is 0 in its own tangent plane.
Gaussian<6> EkfUpdate::operator()(const Gaussian<6>& point,
                                  std::span<const LineOfSight> lines) const {
  constexpr int kPasses = 5;
  constexpr double kEnough_sigmas = 1e-3;
  if (lines.empty()) return point;
  const Matrix6& P = point.covariance;
  Gaussian<6> result = point;
  for (int pass = 0; pass < kPasses; ++pass) {
    const Stack seen = stack(lines, result.mean.head<3>());
    const Eigen::MatrixXd PH = P.leftCols<3>() * seen.slope.transpose();
    Eigen::MatrixXd S = seen.slope * PH.topRows<3>();
    S.diagonal() += seen.noise;
    const Eigen::MatrixXd K = S.llt().solve(PH.transpose()).transpose();
    const Vector6 mean =
        point.mean - K * (seen.offset + seen.slope * (point.mean - result.mean).head<3>());
    Matrix6 A = Matrix6::Identity();
    A.leftCols<3>() -= K * seen.slope;
    result.covariance =
        symmetric(A * P * A.transpose() + K * seen.noise.asDiagonal() * K.transpose());
    const Eigen::Vector3d step = (mean - result.mean).head<3>();
    result.mean = mean;
    const Eigen::Matrix3d spread = result.covariance.topLeftCorner<3, 3>();
    if (step.dot(spread.ldlt().solve(step)) < kEnough_sigmas * kEnough_sigmas) break;
  }
  return result;
}

Gaussian<6> CubatureUpdate::operator()(const Gaussian<6>& point,
                                       std::span<const LineOfSight> lines) const {
  constexpr int kPoints = 12;
  if (lines.empty()) return point;
  const Matrix6 root = Matrix6(point.covariance.llt().matrixL()) * std::sqrt(6.0);
  const int n = dimensions(lines);
  Eigen::MatrixXd seen(n, kPoints);
  Eigen::Matrix<double, 6, kPoints> moved;
  moved << root, -root;
  Eigen::VectorXd noise;
  for (int k = 0; k < kPoints; ++k) {
    const Stack at = stack(lines, (point.mean + moved.col(k)).head<3>());
    if (!at.complete) return EkfUpdate{}(point, lines);
    seen.col(k) = at.offset;
    noise = at.noise;
  }
  const Eigen::VectorXd expected = seen.rowwise().mean();
  seen.colwise() -= expected;
  Eigen::MatrixXd S = seen * seen.transpose() / kPoints;
  S.diagonal() += noise;
  const Eigen::MatrixXd C = moved * seen.transpose() / kPoints;
  const Eigen::MatrixXd K = S.llt().solve(C.transpose()).transpose();
  return {point.mean - K * expected, symmetric(point.covariance - K * S * K.transpose())};
}

PointUpdate make_point_update(PointUpdateMethod method) {
  if (method == PointUpdateMethod::kCubature) return CubatureUpdate{};
  return EkfUpdate{};
}

}  // namespace scanfuse::triangulate
