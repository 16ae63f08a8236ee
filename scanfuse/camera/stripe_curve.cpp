#include "scanfuse/camera/stripe_curve.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

namespace scanfuse::camera {
namespace {

constexpr int kRounds = 12;
constexpr double kTukey = 4.685;  ///< 95 % efficient where errors are normal
constexpr double kSigmaOverMad = 1.4826;

double robust_sigma(std::vector<double> distances) {
  for (double& d : distances) d = std::abs(d);
  const auto middle = distances.begin() + static_cast<std::ptrdiff_t>(distances.size() / 2);
  std::nth_element(distances.begin(), middle, distances.end());
  return kSigmaOverMad * *middle;
}

std::vector<double> distances_from(const StripeCurve& curve,
                                   std::span<const Eigen::Vector2d> points) {
  std::vector<double> out;
  out.reserve(points.size());
  for (const auto& p : points) out.push_back(curve.distance(p));
  return out;
}

/// One weighted least squares step; false where the points do not span a parabola.
bool solve(std::span<const Eigen::Vector2d> points, std::span<const double> weights,
           StripeCurve& curve) {
  Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
  Eigen::Vector3d right = Eigen::Vector3d::Zero();
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double along = curve.along_of(points[i]);
    const double across = curve.upright ? points[i].x() : points[i].y();
    const double s = (along - curve.middle_px) / curve.half_px;
    const Eigen::Vector3d row(1, s, s * s);
    normal += weights[i] * row * row.transpose();
    right += weights[i] * across * row;
  }
  const Eigen::LDLT<Eigen::Matrix3d> ldlt(normal);
  const Eigen::Vector3d d = ldlt.vectorD();
  if (!(d.minCoeff() > 1e-9 * d.maxCoeff())) return false;
  const Eigen::Vector3d c = ldlt.solve(right);
  if (!c.allFinite()) return false;
  curve.c0 = c[0];
  curve.c1 = c[1];
  curve.c2 = c[2];
  return true;
}

/// Puts the middle and half length of the curve where the points are.
void centre(std::span<const Eigen::Vector2d> points, StripeCurve& curve) {
  double low = curve.along_of(points[0]), high = low;
  for (const auto& p : points) {
    low = std::min(low, curve.along_of(p));
    high = std::max(high, curve.along_of(p));
  }
  const double middle = (low + high) / 2, half = std::max((high - low) / 2, 1e-3);
  // The same parabola about the new middle.
  const double shift = (middle - curve.middle_px) / curve.half_px, scale = half / curve.half_px;
  curve = {curve.upright,
           middle,
           half,
           curve.c0 + shift * (curve.c1 + shift * curve.c2),
           scale * (curve.c1 + 2 * curve.c2 * shift),
           curve.c2 * scale * scale};
}

}  // namespace

double StripeCurve::distance(const Eigen::Vector2d& p) const {
  const double along = along_of(p), off = (upright ? p.x() : p.y()) - across(along);
  return off / std::hypot(1.0, slope(along));
}

Eigen::Vector2d StripeCurve::normal(double along_px) const {
  const double m = slope(along_px);
  return point(-m, 1.0) / std::hypot(1.0, m);
}

std::optional<CurveFit> fit_curve(std::span<const Eigen::Vector2d> points, const StripeCurve& start,
                                  double floor_px) {
  if (points.size() < 5) return {};
  CurveFit fit{start, 0, std::vector<bool>(points.size())};
  centre(points, fit.curve);
  std::vector<double> weights(points.size());
  double limit = 0;
  for (int round = 0; round < kRounds; ++round) {
    const auto distances = distances_from(fit.curve, points);
    limit = std::max(kTukey * robust_sigma(distances), floor_px);
    for (std::size_t i = 0; i < points.size(); ++i) {
      const double share = distances[i] / limit;
      weights[i] = std::abs(share) < 1 ? std::pow(1 - share * share, 2) : 0;
    }
    if (!solve(points, weights, fit.curve)) return {};
  }
  const auto distances = distances_from(fit.curve, points);
  double sum = 0;
  int count = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    fit.inliers[i] = std::abs(distances[i]) < limit;
    if (!fit.inliers[i]) continue;
    sum += distances[i] * distances[i];
    ++count;
  }
  if (count < 5) return {};
  fit.scatter_px = std::sqrt(sum / (count - 3));
  return fit;
}

}  // namespace scanfuse::camera
