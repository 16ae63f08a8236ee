#include "scanfuse/triangulate/locate.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <cmath>

namespace scanfuse::triangulate {
namespace {

constexpr int kMostIterations = 30, kMostHalvings = 8;
constexpr double kStill = 1e-6;     // a step of this many sigma changes nothing
constexpr double kOpenSide = 1e-8;  // eigenvalues of a scaled information below this: no position

/// H'H of [Lu2015, eq. 11]: a row `left` and a row `up` a sensor (the paper's, with both signs
/// turned, which cancels).
Eigen::Matrix3d normal_matrix(std::span<const LineOfSight> lines) {
  Eigen::Matrix3d n = Eigen::Matrix3d::Zero();
  for (const LineOfSight& line : lines) {
    n += line.left * line.left.transpose();
    if (line.tells_elevation()) n += line.up * line.up.transpose();
  }
  return n;
}

/// (H'H)^-1 H' D H (H'H)^-1, D the noise of each sensor's rows with the target at `offset` from
/// where the equation's left side is taken: the sensor itself as printed, sensor minus target else.
template <class Offset>
Eigen::Matrix3d covariance_of_rows(std::span<const LineOfSight> lines, Offset&& offset) {
  Eigen::Matrix3d inner = Eigen::Matrix3d::Zero();
  for (const LineOfSight& line : lines) {
    const Eigen::Vector3d from = offset(line);
    const double c = std::cos(line.elevation_rad), s = std::sin(line.elevation_rad);
    const Eigen::Vector3d flat = c * line.direction - s * line.up;
    const double by_azimuth = flat.dot(from) * line.sigma_azimuth_rad;
    if (!line.tells_elevation()) {
      inner += by_azimuth * by_azimuth * line.left * line.left.transpose();
      continue;
    }
    const double up_by_azimuth = s * line.left.dot(from) * line.sigma_azimuth_rad;
    const double up_by_elevation = line.direction.dot(from) * line.sigma_up_rad;
    const Eigen::Vector3d azimuth_moves = by_azimuth * line.left + up_by_azimuth * line.up;
    inner += azimuth_moves * azimuth_moves.transpose() +
             up_by_elevation * up_by_elevation * line.up * line.up.transpose();
  }
  const Eigen::Matrix3d inverse = normal_matrix(lines).ldlt().solve(Eigen::Matrix3d::Identity());
  return inverse * inner * inverse;
}

/// chi2 of a point, its gradient (halved) and information; false behind a sensor.
struct Fit {
  double chi2 = 0;
  Eigen::Vector3d gradient = Eigen::Vector3d::Zero();
  Eigen::Matrix3d information = Eigen::Matrix3d::Zero();
};

bool fit_at(std::span<const LineOfSight> lines, const Eigen::Vector3d& point,
            const Eigen::Matrix3d& prior_information, const Gaussian<3>* prior, Fit& fit) {
  fit = {};
  for (const LineOfSight& line : lines) {
    const auto seen = sight(line, point);
    if (!seen) return false;
    const Eigen::Vector3d left = seen->jacobian_rad_per_m.row(0).transpose() / line.sigma_left_rad;
    const double off = seen->offset_rad.x() / line.sigma_left_rad;
    fit.chi2 += off * off;
    fit.gradient += left * off;
    fit.information += left * left.transpose();
    if (!line.tells_elevation()) continue;
    const Eigen::Vector3d up = seen->jacobian_rad_per_m.row(1).transpose() / line.sigma_up_rad;
    const double over = seen->offset_rad.y() / line.sigma_up_rad;
    fit.chi2 += over * over;
    fit.gradient += up * over;
    fit.information += up * up.transpose();
  }
  if (prior != nullptr) {
    const Eigen::Vector3d d = point - prior->mean, pull = prior_information * d;
    fit.chi2 += d.dot(pull);
    fit.gradient += pull;
    fit.information += prior_information;
  }
  return true;
}

/// The inverse, or nothing where some direction is open.
std::optional<Eigen::Matrix3d> inverse_of(const Eigen::Matrix3d& information) {
  const Eigen::LLT<Eigen::Matrix3d> factor(information);
  if (factor.info() != Eigen::Success) return std::nullopt;
  const Eigen::Matrix3d inverse = factor.solve(Eigen::Matrix3d::Identity());
  // Traces bound the condition number from both sides within a factor of 3 each.
  if (!(1 / (information.trace() * inverse.trace()) > kOpenSide * kOpenSide)) return std::nullopt;
  return Eigen::Matrix3d((inverse + inverse.transpose()) / 2);
}

}  // namespace

Eigen::Vector3d least_squares(std::span<const LineOfSight> lines) {
  Eigen::Vector3d middle = Eigen::Vector3d::Zero(), right = Eigen::Vector3d::Zero();
  for (const LineOfSight& line : lines) middle += line.origin_m;
  middle /= static_cast<double>(std::max<std::size_t>(lines.size(), 1));
  for (const LineOfSight& line : lines) {
    const Eigen::Vector3d from = line.origin_m - middle;
    right += line.left * line.left.dot(from);
    if (line.tells_elevation()) right += line.up * line.up.dot(from);
  }
  // Relative to the middle of the sensors: what stays open stays there.
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(normal_matrix(lines));
  const Eigen::Vector3d along = axes.eigenvectors().transpose() * right;
  Eigen::Vector3d out = Eigen::Vector3d::Zero();
  for (int k = 0; k < 3; ++k) {
    if (axes.eigenvalues()[k] > 1e-12) {
      out += axes.eigenvectors().col(k) * (along[k] / axes.eigenvalues()[k]);
    }
  }
  return middle + out;
}

Eigen::Matrix3d covariance_literal(std::span<const LineOfSight> lines) {
  return covariance_of_rows(
      lines, [](const LineOfSight& line) -> Eigen::Vector3d { return line.origin_m; });
}

Eigen::Matrix3d covariance_corrected(std::span<const LineOfSight> lines,
                                     const Eigen::Vector3d& position_m) {
  return covariance_of_rows(lines, [&](const LineOfSight& line) -> Eigen::Vector3d {
    return line.origin_m - position_m;
  });
}

std::optional<Location> most_likely(std::span<const LineOfSight> lines,
                                    const Eigen::Vector3d& start_m, const Gaussian<3>* prior) {
  Eigen::Matrix3d prior_information = Eigen::Matrix3d::Zero();
  if (prior != nullptr) {
    prior_information = prior->covariance.ldlt().solve(Eigen::Matrix3d::Identity());
  }
  Location at;
  at.position_m = start_m;
  Fit fit, next;
  if (!fit_at(lines, start_m, prior_information, prior, fit)) return std::nullopt;
  while (at.iterations < kMostIterations && !at.converged) {
    const Eigen::LDLT<Eigen::Matrix3d> factor(fit.information);
    Eigen::Vector3d step = -factor.solve(fit.gradient);
    if (!step.allFinite()) return std::nullopt;
    ++at.iterations;
    at.converged = -step.dot(fit.gradient) < kStill * kStill;
    bool better = false;
    for (int halving = 0; halving < kMostHalvings && !better; ++halving, step /= 2) {
      better = fit_at(lines, at.position_m + step, prior_information, prior, next) &&
               next.chi2 <= fit.chi2 + 1e-12 * (1 + fit.chi2);
      if (better) at.position_m += step;
    }
    if (!better) break;
    fit = next;
  }
  const auto covariance = inverse_of(fit.information);
  if (!covariance) return std::nullopt;
  at.covariance_m2 = *covariance;
  at.chi2 = fit.chi2;
  return at;
}

std::optional<Location> most_likely(std::span<const LineOfSight> lines, const Gaussian<3>* prior) {
  if (auto found = most_likely(lines, least_squares(lines), prior)) return found;
  if (prior == nullptr) return std::nullopt;
  return most_likely(lines, prior->mean, prior);
}

}  // namespace scanfuse::triangulate
