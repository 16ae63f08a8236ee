#include "scanfuse/calibrate/lines.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/QR>
#include <algorithm>

#include "scanfuse/calibrate/middle.hpp"
#include "scanfuse/calibrate/undistort.hpp"
#include "scanfuse/core/random.hpp"

namespace scanfuse::calibrate {
namespace {

using Eigen::Matrix2d;
using Eigen::Vector2d;

struct Line {
  Vector2d centre;
  Vector2d along;
  [[nodiscard]] double distance(const Vector2d& p) const {
    return along.x() * (p.y() - centre.y()) - along.y() * (p.x() - centre.x());
  }
};

/// Of lines through two of the points each, the one with the least median distance.
Line most_agreed(const std::vector<Vector2d>& points) {
  RandomStream random(1);
  Line best{points.front(), Vector2d::UnitX()};
  double least = std::numeric_limits<double>::infinity();
  const std::size_t thin = std::max<std::size_t>(1, points.size() / 64);
  for (int trial = 0; trial < 40; ++trial) {
    const Vector2d& a = points[random.below(points.size())];
    const Vector2d& b = points[random.below(points.size())];
    if ((a - b).norm() < 1e-9) continue;
    const Line line{a, (b - a).normalized()};
    std::vector<double> distances;
    for (std::size_t i = 0; i < points.size(); i += thin) {
      distances.push_back(std::abs(line.distance(points[i])));
    }
    const double middle = middle_of(std::move(distances));
    if (middle < least) {
      least = middle;
      best = line;
    }
  }
  return best;
}

/// Least squares of weighed distances across the line.
Line total_least_squares(const std::vector<Vector2d>& points, const std::vector<double>& weights) {
  Vector2d mean = Vector2d::Zero();
  double sum = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    mean += weights[i] * points[i];
    sum += weights[i];
  }
  mean /= sum;
  Matrix2d S = Matrix2d::Zero();
  for (std::size_t i = 0; i < points.size(); ++i) {
    S += weights[i] * (points[i] - mean) * (points[i] - mean).transpose();
  }
  const Eigen::SelfAdjointEigenSolver<Matrix2d> solver(S);
  return {mean, solver.eigenvectors().col(1)};
}

/// One over the variance across the line, in undistorted pixels, of a point that has unit variance
/// across the stripe in the raw image.
double weight_at(const Camera& camera, const Vector2d& normalised, const Vector2d& normal) {
  const Matrix2d raw_from_straight = distortion_jacobian(camera, normalised) *
                                     Vector2d(1 / camera.fx_px, 1 / camera.fy_px).asDiagonal();
  return 1 / (raw_from_straight.inverse().transpose() * normal).squaredNorm();
}

}  // namespace

std::optional<StripeLine> fit_stripe(const Camera& camera, std::span<const Vector2d> points_px) {
  std::vector<Vector2d> straight, normalised;
  for (const auto& p : points_px) {
    if (!p.allFinite()) continue;
    const Vector2d at = undistort(camera, p);
    if (!at.allFinite()) continue;
    normalised.push_back(at);
    straight.emplace_back(camera.fx_px * at.x() + camera.cx_px,
                          camera.fy_px * at.y() + camera.cy_px);
  }
  if (straight.size() < 8) return std::nullopt;
  Line line = most_agreed(straight);
  StripeLine out;
  for (int round = 0; round < 4; ++round) {
    std::vector<double> distances;
    for (const auto& p : straight) distances.push_back(std::abs(line.distance(p)));
    const double limit = std::max(5 * 1.4826 * middle_of(std::move(distances)), 0.02);
    std::vector<Vector2d> kept;
    std::vector<double> weights;
    out.normalised.clear();
    for (std::size_t i = 0; i < straight.size(); ++i) {
      if (std::abs(line.distance(straight[i])) > limit) continue;
      kept.push_back(straight[i]);
      out.normalised.push_back(normalised[i]);
      weights.push_back(weight_at(camera, normalised[i], {-line.along.y(), line.along.x()}));
    }
    line = total_least_squares(kept, weights);
    if (round < 3) continue;
    for (std::size_t i = 0; i < kept.size(); ++i) {
      out.weight += weights[i];
      out.moment += weights[i] * std::pow(line.along.dot(kept[i] - line.centre), 2);
      out.scatter += weights[i] * std::pow(line.distance(kept[i]), 2);
    }
  }
  out.centre_px = line.centre;
  out.along = line.along;
  out.count = static_cast<int>(out.normalised.size());
  out.outliers = static_cast<int>(points_px.size()) - out.count;
  if (out.count < 8 || !(out.moment > 0)) return std::nullopt;
  return out;
}

std::optional<LidarLine> fit_returns(std::span<const BeamReturn> returns,
                                     std::span<const double> squares) {
  const auto n = static_cast<Eigen::Index>(returns.size());
  if (n < 4) return std::nullopt;
  std::vector<Vector2d> rays, points;
  for (const auto& r : returns) {
    rays.emplace_back(std::cos(r.angle_rad), std::sin(r.angle_rad));
    points.push_back(r.range_m * rays.back());
  }
  const Line start = total_least_squares(points, std::vector<double>(points.size(), 1));
  LidarLine out;
  out.normal = {-start.along.y(), start.along.x()};
  out.distance_m = out.normal.dot(start.centre);
  Eigen::MatrixXd A(n, 4);
  Eigen::VectorXd y(n);
  for (int round = 0;; ++round) {
    double sum = 0, moment = 0;
    for (Eigen::Index i = 0; i < n; ++i) {
      const auto k = static_cast<std::size_t>(i);
      const double cosine = out.normal.dot(rays[k]);
      if (!(std::abs(cosine) > 0.02)) return std::nullopt;
      y[i] = returns[k].range_m - out.distance_m / cosine;
      A.row(i) << 1 / cosine, out.distance_m / cosine * out.along().dot(rays[k]) / cosine, 1,
          squares.empty() ? 0 : squares[k];
      sum += A(i, 0) * A(i, 0);
      moment += A(i, 0) * A(i, 1);
    }
    const double middle = moment / sum;
    A.col(1) -= middle * A.col(0);
    out.centre_m = out.distance_m * out.normal + middle * out.along();
    if (round == 4) break;
    const double offset = A.col(0).dot(y) / sum;
    const double slope = A.col(1).dot(y) / A.col(1).squaredNorm();
    const Vector2d through = out.centre_m + offset * out.normal;
    out.normal = (out.normal - slope * out.along()).normalized();
    out.distance_m = out.normal.dot(through);
    if (out.distance_m < 0) {
      out.distance_m *= -1;
      out.normal *= -1;
    }
  }
  // Gram-Schmidt in the order of the columns; a column that adds nothing leaves a row of zeros.
  Eigen::MatrixXd Q = A;
  for (int k = 0; k < 4; ++k) {
    const double length = A.col(k).norm();
    for (int pass = 0; pass < 2; ++pass) {
      for (int j = 0; j < k; ++j) {
        const double part = Q.col(j).dot(Q.col(k));
        out.R(j, k) += part;
        Q.col(k) -= part * Q.col(j);
      }
    }
    const double left = Q.col(k).norm();
    if (!(left > 1e-6 * length)) {
      Q.col(k).setZero();
      continue;
    }
    out.R(k, k) = left;
    Q.col(k) /= left;
    ++out.rank;
  }
  out.z = Q.transpose() * y;
  out.scatter_m2 = std::max(0.0, y.squaredNorm() - out.z.squaredNorm());
  out.count = static_cast<int>(n);
  if (!out.z.allFinite() || out.rank < 2) return std::nullopt;
  return out;
}

}  // namespace scanfuse::calibrate
