#include "scanfuse/shape/face_fit.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace scanfuse::shape {
namespace {

/// State of the fit: two orthogonal outward normals, offsets about the pivot.
struct Sides {
  double heading_rad = 0;  ///< of the first axis
  std::array<double, 2> sign{1, 1};
  std::array<double, 2> offset{};
  std::array<bool, 2> seen{true, true};

  [[nodiscard]] std::array<Eigen::Vector2d, 2> normals() const {
    const double c = std::cos(heading_rad), s = std::sin(heading_rad);
    return {Eigen::Vector2d(sign[0] * c, sign[0] * s), Eigen::Vector2d(-sign[1] * s, sign[1] * c)};
  }
};

/// What one pass over the points adds up: normal equations in (offset 0, offset 1, heading).
struct NormalEquations {
  Eigen::Matrix3d a = Eigen::Matrix3d::Zero();
  Eigen::Vector3d g = Eigen::Vector3d::Zero();
  double weight = 0, chi2 = 0, squares = 0;
  int inliers = 0;
  std::array<int, 2> points{};
  std::array<double, 2> low{1e9, 1e9}, high{-1e9, -1e9};  ///< along each face
};

constexpr double kCauchyScale2 = 2.385 * 2.385;

class FaceFitter {
 public:
  FaceFitter(std::span<const Eigen::Vector2d> points, double sigma_range_m,
             const FaceFitOptions& options)
      : points_(points),
        options_(options),
        variance_range_(sigma_range_m * sigma_range_m),
        variance_surface_(std::max(options.surface_sigma_m * options.surface_sigma_m, 1e-12)) {
    for (const auto& p : points) pivot_ += p;
    pivot_ /= static_cast<double>(points.size());
  }

  FaceFit run(double heading_rad) {
    Sides sides = start(heading_rad);
    for (int i = 0; i < options_.iterations; ++i) {
      see(sides);
      const NormalEquations sums = add_up(sides);
      if (i == 0 && drop_weak_side(sides, sums)) {
        continue;
      }
      step(sides, sums);
    }
    see(sides);
    NormalEquations sums = add_up(sides);
    if (drop_weak_side(sides, sums)) {
      for (int i = 0; i < 2; ++i) step(sides, add_up(sides));
      sums = add_up(sides);
    }
    return result(sides, sums);
  }

 private:
  Sides start(double heading_rad) const {
    Sides sides;
    sides.heading_rad = heading_rad;
    const auto axes = sides.normals();
    for (const std::size_t k : {0, 1}) {
      if (axes[k].dot(pivot_) > 0) sides.sign[k] = -1;
      sides.offset[k] = -std::numeric_limits<double>::infinity();
    }
    const auto n = sides.normals();
    for (const auto& p : points_) {
      for (const std::size_t k : {0, 1}) {
        sides.offset[k] = std::max(sides.offset[k], n[k].dot(p - pivot_));
      }
    }
    return sides;
  }

  /// A side is visible where the sensor stands before its plane. Dropped sides stay dropped.
  void see(Sides& sides) const {
    const auto n = sides.normals();
    std::array<double, 2> before{};
    for (const std::size_t k : {0, 1}) before[k] = -n[k].dot(pivot_) - sides.offset[k];
    if (dropped_ >= 0) {
      sides.seen[static_cast<std::size_t>(dropped_)] = false;
      return;
    }
    sides.seen = {before[0] > 0, before[1] > 0};
    if (!sides.seen[0] && !sides.seen[1]) sides.seen[before[0] > before[1] ? 0 : 1] = true;
  }

  NormalEquations add_up(const Sides& sides) const {
    const auto n = sides.normals();
    NormalEquations sums;
    for (const auto& p : points_) {
      const Eigen::Vector2d q = p - pivot_;
      std::size_t side = 0;
      double residual = 0, variance = 1, least = std::numeric_limits<double>::infinity();
      for (const std::size_t k : {0, 1}) {
        if (!sides.seen[k]) continue;
        const double r = n[k].dot(q) - sides.offset[k];
        const double slant = n[k].dot(p);
        const double v =
            variance_surface_ + variance_range_ * slant * slant / std::max(p.squaredNorm(), 1e-12);
        if (r * r / v < least) {
          least = r * r / v;
          side = k;
          residual = r;
          variance = v;
        }
      }
      add_point(sums, n, side, q, residual, variance);
    }
    return sums;
  }

  static void add_point(NormalEquations& sums, const std::array<Eigen::Vector2d, 2>& n,
                        std::size_t side, const Eigen::Vector2d& q, double residual,
                        double variance) {
    const double z2 = residual * residual / variance;
    const double weight = 1 / (1 + z2 / kCauchyScale2);
    const double along = n[side].x() * q.y() - n[side].y() * q.x();
    sums.weight += weight;
    sums.chi2 += weight * z2;
    sums.squares += residual * residual;
    sums.points[side] += 1;
    if (z2 < 9) {
      ++sums.inliers;
      sums.low[side] = std::min(sums.low[side], along);
      sums.high[side] = std::max(sums.high[side], along);
    }
    // d(n . q)/d heading = tangent . q; d/d offset = -1
    const double w = weight / variance;
    const auto k = static_cast<Eigen::Index>(side);
    sums.a(k, k) += w;
    sums.a(k, 2) -= w * along;
    sums.a(2, k) -= w * along;
    sums.a(2, 2) += w * along * along;
    sums.g(k) -= w * residual;
    sums.g(2) += w * along * residual;
  }

  /// A second side of few points or little length is a rounded corner or an edge return.
  bool drop_weak_side(Sides& sides, const NormalEquations& sums) {
    if (dropped_ >= 0 || !sides.seen[0] || !sides.seen[1]) return false;
    const std::size_t weak = sums.points[0] < sums.points[1] ? 0 : 1;
    const double length = sums.high[weak] - sums.low[weak];
    const double reach = corner_reach(sides, sums, weak);
    if (sums.points[weak] >= options_.min_face_points &&
        std::max(length, reach) >= options_.min_face_m) {
      return false;
    }
    dropped_ = static_cast<int>(weak);
    sides.seen[weak] = false;
    return true;
  }

  /// How far the points of one side reach away from the corner.
  static double corner_reach(const Sides& sides, const NormalEquations& sums, std::size_t side) {
    const auto n = sides.normals();
    const Eigen::Vector2d tangent(-n[side].y(), n[side].x());
    const double corner = tangent.dot(n[1 - side]) * sides.offset[1 - side];
    return std::max(std::abs(sums.low[side] - corner), std::abs(sums.high[side] - corner));
  }

  static Eigen::Matrix3d regularised(const Sides& sides, const NormalEquations& sums) {
    Eigen::Matrix3d a = sums.a;
    a(2, 2) += 1.0;  // a heading known to 1 rad before any point
    for (const Eigen::Index k : {0, 1}) {
      a(k, k) += 1e-4;
      if (!sides.seen[static_cast<std::size_t>(k)]) a(k, k) += 1;
    }
    return a;
  }

  static void step(Sides& sides, const NormalEquations& sums) {
    const Eigen::Vector3d delta = regularised(sides, sums).ldlt().solve(-sums.g);
    sides.offset[0] += delta[0];
    sides.offset[1] += delta[1];
    sides.heading_rad += std::clamp(delta[2], -0.2, 0.2);
  }

  FaceFit result(const Sides& sides, const NormalEquations& sums) const {
    constexpr double kPriorPoints = 4;
    const auto n = sides.normals();
    const auto count = static_cast<double>(points_.size());
    const std::size_t first = sums.points[0] >= sums.points[1] ? 0 : 1, second = 1 - first;
    const auto face = [&](std::size_t k) {
      return Face{n[k], sides.offset[k] + n[k].dot(pivot_), sides.seen[k] ? sums.points[k] : 0};
    };
    FaceFit fit{face(first),         face(second), pivot_, {}, std::sqrt(sums.squares / count),
                sums.inliers / count};
    const double parameters = fit.two() ? 3 : 2;
    const double scale =
        (sums.chi2 + kPriorPoints) / (std::max(sums.weight - parameters, 0.0) + kPriorPoints);
    Eigen::Matrix3d covariance = regularised(sides, sums).inverse() * std::max(scale, 0.5);
    if (first == 1) {
      covariance.row(0).swap(covariance.row(1));
      covariance.col(0).swap(covariance.col(1));
    }
    fit.covariance = covariance;
    return fit;
  }

  std::span<const Eigen::Vector2d> points_;
  FaceFitOptions options_;
  double variance_range_;
  double variance_surface_;
  Eigen::Vector2d pivot_ = Eigen::Vector2d::Zero();
  int dropped_ = -1;
};

}  // namespace

FaceFit fit_faces(std::span<const Eigen::Vector2d> points, double heading_rad, double sigma_range_m,
                  const FaceFitOptions& options) {
  return FaceFitter(points, sigma_range_m, options).run(heading_rad);
}

}  // namespace scanfuse::shape
