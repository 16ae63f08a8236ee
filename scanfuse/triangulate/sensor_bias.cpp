#include "scanfuse/triangulate/sensor_bias.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <optional>

namespace scanfuse::triangulate {
namespace {

/// What a sensor tells of a point, in the plane that touches the sphere at the point. Not where the
/// bearing points, as `sight` has it: the weights would depend on the noise, and so lean.
struct Told {
  Eigen::Vector2d off_rad;  ///< told less true
  Eigen::Vector2d sigma_rad;
  Eigen::Vector2d by_bias;  ///< off by radian of azimuth, of elevation
  Eigen::Matrix<double, 2, 3> by_point;
};

std::optional<Told> told(const LineOfSight& line, const Eigen::Vector3d& point_m) {
  if (!sight(line, point_m)) return std::nullopt;
  const double ce = std::cos(line.elevation_rad), se = std::sin(line.elevation_rad);
  const Eigen::Vector3d zenith = ce * line.up + se * line.direction;
  const Eigen::Vector3d level = ce * line.direction - se * line.up;
  const Eigen::Vector3d d = point_m - line.origin_m;
  const double turn = std::atan2(line.left.dot(d), level.dot(d));
  const Eigen::Vector3d left = std::cos(turn) * line.left - std::sin(turn) * level;
  const Eigen::Vector3d ahead = std::cos(turn) * level + std::sin(turn) * line.left;
  const double flat = ahead.dot(d), range = d.norm();
  const double elevation = std::atan2(zenith.dot(d), flat);
  if (!line.tells_elevation()) {
    Told azimuth{{-turn, 0}, {line.sigma_azimuth_rad, 1}, {1, 0}, {}};
    azimuth.by_point << left.transpose() / flat, Eigen::RowVector3d::Zero();
    return azimuth;
  }
  const double shrink = std::max(flat / range, std::min(line.sigma_up_rad, 1.0));
  Told both{{-turn * shrink, line.elevation_rad - elevation},
            {line.sigma_azimuth_rad * shrink, line.sigma_up_rad},
            {shrink, 1},
            {}};
  both.by_point << left.transpose() / range,
      (std::cos(elevation) * zenith - std::sin(elevation) * ahead).transpose() / range;
  return both;
}

}  // namespace

BiasFilter::BiasFilter(std::span<const PassiveSensor> sensors, double sigma_rad) {
  const auto n = 2 * static_cast<Eigen::Index>(sensors.size());
  information_ = Eigen::MatrixXd::Identity(n, n) / (sigma_rad * sigma_rad);
  evidence_ = Eigen::VectorXd::Zero(n);
  for (const PassiveSensor& sensor : sensors) tells_elevation_.push_back(sensor.tells_elevation());
}

void BiasFilter::learn(std::span<const LineOfSight> lines, const Eigen::Vector3d& position_m) {
  int n = 0;
  for (const LineOfSight& line : lines) n += line.dimensions();
  if (n < 3 || lines.size() < 2) return;
  Eigen::MatrixXd J = Eigen::MatrixXd::Zero(n, 3);
  Eigen::VectorXd r = Eigen::VectorXd::Zero(n), slope = r, weight = r;
  std::vector<Eigen::Index> place(static_cast<std::size_t>(n));
  int row = 0;
  for (const LineOfSight& line : lines) {
    const auto seen = told(line, position_m);
    if (!seen) return;
    for (int k = 0; k < line.dimensions(); ++k, ++row) {
      weight(row) = 1 / (seen->sigma_rad(k) * seen->sigma_rad(k));
      J.row(row) = seen->by_point.row(k);
      r(row) = seen->off_rad(k);
      slope(row) = seen->by_bias(k);
      place[static_cast<std::size_t>(row)] = 2 * line.sensor + k;
    }
  }
  // J' R^-1 J may leave directions open (azimuths say nothing of height): its pseudo-inverse.
  const Eigen::MatrixXd WJ = weight.asDiagonal() * J;
  const Eigen::Matrix3d M = J.transpose() * WJ;
  Eigen::CompleteOrthogonalDecomposition<Eigen::Matrix3d> open(M);
  open.setThreshold(1e-9);
  if (n <= open.rank()) return;
  Eigen::MatrixXd W = -WJ * open.pseudoInverse() * WJ.transpose();
  W.diagonal() += weight;
  const Eigen::VectorXd Wr = W * r;
  for (int i = 0; i < n; ++i) {
    const Eigen::Index p = place[static_cast<std::size_t>(i)];
    evidence_(p) += slope(i) * Wr(i);
    for (int j = 0; j < n; ++j) {
      const Eigen::Index q = place[static_cast<std::size_t>(j)];
      information_(p, q) += slope(i) * W(i, j) * slope(j);
    }
  }
}

std::vector<SensorBias> BiasFilter::biases() const {
  const Eigen::MatrixXd covariance = information_.ldlt().solve(
      Eigen::MatrixXd::Identity(information_.rows(), information_.cols()));
  const Eigen::VectorXd b = covariance * evidence_;
  std::vector<SensorBias> biases(tells_elevation_.size());
  for (std::size_t s = 0; s < biases.size(); ++s) {
    const auto k = 2 * static_cast<Eigen::Index>(s);
    biases[s].azimuth_rad = b(k);
    biases[s].sigma_azimuth_rad = std::sqrt(std::max(covariance(k, k), 0.0));
    if (!tells_elevation_[s]) continue;
    biases[s].elevation_rad = b(k + 1);
    biases[s].sigma_elevation_rad = std::sqrt(std::max(covariance(k + 1, k + 1), 0.0));
  }
  return biases;
}

Bearing without_bias(Bearing bearing, const SensorBias& bias) {
  bearing.azimuth_rad = wrap_pi(bearing.azimuth_rad - bias.azimuth_rad);
  bearing.elevation_rad = std::clamp(bearing.elevation_rad - bias.elevation_rad, -kPi / 2, kPi / 2);
  return bearing;
}

}  // namespace scanfuse::triangulate
