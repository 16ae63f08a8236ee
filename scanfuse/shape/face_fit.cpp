#include "scanfuse/shape/face_fit.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace scanfuse::shape {
namespace {

constexpr std::size_t kMostFacePoints = 64;
constexpr float kCauchyScale2 = 2.385f * 2.385f;
using Column = std::array<float, kMostFacePoints>;

/// Points about their mean, and the directions of their beams.
struct FacePoints {
  Eigen::Vector2d pivot = Eigen::Vector2d::Zero();
  std::size_t count = 0;
  Column x, y, beam_x, beam_y;  ///< the first `count` are set
};

FacePoints thin(std::span<const Eigen::Vector2d> points) {
  FacePoints out;
  for (const auto& p : points) out.pivot += p;
  out.pivot /= static_cast<double>(points.size());
  const std::size_t stride = (points.size() + kMostFacePoints - 1) / kMostFacePoints;
  for (std::size_t i = 0; i < points.size(); i += stride) {
    const Eigen::Vector2d& p = points[i];
    const double inverse = 1 / std::max(p.norm(), 1e-6);
    out.x[out.count] = static_cast<float>(p.x() - out.pivot.x());
    out.y[out.count] = static_cast<float>(p.y() - out.pivot.y());
    out.beam_x[out.count] = static_cast<float>(p.x() * inverse);
    out.beam_y[out.count] = static_cast<float>(p.y() * inverse);
    ++out.count;
  }
  return out;
}

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

/// Every point against its side: squared residual in sigmas, residual, place along the side, weight
/// over variance, and 1 where the side is the first.
struct Residuals {
  Column z2, r, along, w, is_first;
};

/// What the residuals tell about the sides.
struct Tally {
  double squares = 0;
  int inliers = 0;
  std::array<int, 2> points{};
  std::array<float, 2> low{1e9f, 1e9f}, high{-1e9f, -1e9f};  ///< along each side
};

class FaceFitter {
 public:
  FaceFitter(std::span<const Eigen::Vector2d> points, double sigma_range_m,
             const FaceFitOptions& options)
      : points_(thin(points)),
        options_(options),
        variance_range_(static_cast<float>(sigma_range_m * sigma_range_m)),
        variance_surface_(
            static_cast<float>(std::max(options.surface_sigma_m * options.surface_sigma_m, 1e-8))) {
  }

  FaceFit run(double heading_rad) {
    Sides sides = start(heading_rad);
    measure(sides);
    if (drop_weak_side(sides)) measure(sides);
    for (int i = 0; i < options_.iterations; ++i) {
      step(sides);
      measure(sides);
    }
    if (drop_weak_side(sides)) {
      measure(sides);
      step(sides);
      measure(sides);
    }
    return result(sides);
  }

 private:
  Sides start(double heading_rad) const {
    Sides sides;
    sides.heading_rad = heading_rad;
    const auto axes = sides.normals();
    for (const std::size_t k : {0, 1}) {
      if (axes[k].dot(points_.pivot) > 0) sides.sign[k] = -1;
    }
    const auto n = sides.normals();
    for (const std::size_t k : {0, 1}) {
      float most = -std::numeric_limits<float>::infinity();
      const auto nx = static_cast<float>(n[k].x()), ny = static_cast<float>(n[k].y());
      for (std::size_t i = 0; i < points_.count; ++i) {
        most = std::max(most, nx * points_.x[i] + ny * points_.y[i]);
      }
      sides.offset[k] = most;
    }
    return sides;
  }

  /// A side is visible where the sensor stands before its plane. Dropped sides stay dropped.
  void see(Sides& sides, const std::array<Eigen::Vector2d, 2>& n) const {
    std::array<double, 2> before{};
    for (const std::size_t k : {0, 1}) before[k] = -n[k].dot(points_.pivot) - sides.offset[k];
    sides.seen = {before[0] > 0 && dropped_ != 0, before[1] > 0 && dropped_ != 1};
    if (sides.seen[0] || sides.seen[1]) return;
    sides.seen[dropped_ >= 0 ? 1 - static_cast<std::size_t>(dropped_)
                             : (before[0] > before[1] ? 0 : 1)] = true;
  }

  /// Fills residuals_. Without branches, so that compilers make it vector code.
  void measure(Sides& sides) {
    const auto n = sides.normals();
    see(sides, n);
    const auto n0x = static_cast<float>(n[0].x()), n0y = static_cast<float>(n[0].y());
    const auto n1x = static_cast<float>(n[1].x()), n1y = static_cast<float>(n[1].y());
    const auto o0 = static_cast<float>(sides.offset[0]), o1 = static_cast<float>(sides.offset[1]);
    const float far0 = sides.seen[0] ? 0.0f : 1e12f, far1 = sides.seen[1] ? 0.0f : 1e12f;
    const float range = variance_range_, surface = variance_surface_;
    const auto& p = points_;
    auto& out = residuals_;
    for (std::size_t i = 0; i < p.count; ++i) {
      const float r0 = n0x * p.x[i] + n0y * p.y[i] - o0, r1 = n1x * p.x[i] + n1y * p.y[i] - o1;
      const float t0 = n0x * p.y[i] - n0y * p.x[i], t1 = n1x * p.y[i] - n1y * p.x[i];
      const float s0 = n0x * p.beam_x[i] + n0y * p.beam_y[i];
      const float s1 = n1x * p.beam_x[i] + n1y * p.beam_y[i];
      const float v0 = surface + range * s0 * s0, v1 = surface + range * s1 * s1;
      const float first = (r0 * r0 + far0) * v1 <= (r1 * r1 + far1) * v0 ? 1.0f : 0.0f;
      const float second = 1.0f - first;
      const float r = first * r0 + second * r1, v = first * v0 + second * v1;
      const float z2 = r * r / v;
      out.z2[i] = z2;
      out.r[i] = r;
      out.along[i] = first * t0 + second * t1;
      out.w[i] = kCauchyScale2 / ((kCauchyScale2 + z2) * v);
      out.is_first[i] = first;
    }
  }

  Tally tally() const {
    Tally t;
    for (std::size_t i = 0; i < points_.count; ++i) {
      const std::size_t side = residuals_.is_first[i] > 0 ? 0 : 1;
      t.squares += residuals_.r[i] * residuals_.r[i];
      t.points[side] += 1;
      if (residuals_.z2[i] >= 9) continue;
      ++t.inliers;
      t.low[side] = std::min(t.low[side], residuals_.along[i]);
      t.high[side] = std::max(t.high[side], residuals_.along[i]);
    }
    return t;
  }

  /// A second side of few points or little length is a rounded corner or an edge return.
  bool drop_weak_side(Sides& sides) {
    if (dropped_ >= 0 || !sides.seen[0] || !sides.seen[1]) return false;
    const Tally t = tally();
    const std::size_t weak = t.points[0] < t.points[1] ? 0 : 1;
    if (t.points[weak] >= options_.min_face_points &&
        corner_reach(sides, t, weak) >= options_.min_face_m) {
      return false;
    }
    dropped_ = static_cast<int>(weak);
    return true;
  }

  /// How far the points of one side reach away from the corner.
  static double corner_reach(const Sides& sides, const Tally& t, std::size_t side) {
    if (t.low[side] > t.high[side]) return 0;
    const auto n = sides.normals();
    const Eigen::Vector2d tangent(-n[side].y(), n[side].x());
    const double corner = tangent.dot(n[1 - side]) * sides.offset[1 - side];
    return std::max(std::abs(t.low[side] - corner), std::abs(t.high[side] - corner));
  }

  using Values = Eigen::Map<const Eigen::ArrayXf>;
  Values values(const Column& column) const {
    return {column.data(), static_cast<Eigen::Index>(points_.count)};
  }

  /// Normal equations in (offset 0, offset 1, heading), held up by weak priors. The residual
  /// n . q - d changes with heading by the place along the side, with d by -1.
  Eigen::Matrix3d information(const Sides& sides) const {
    const Values w = values(residuals_.w), first = values(residuals_.is_first);
    const Values along = values(residuals_.along);
    const double both = w.sum(), w0 = (w * first).sum();
    const double along_both = (w * along).sum(), along0 = (w * first * along).sum();
    Eigen::Matrix3d a;
    a << w0 + 1e-4, 0, -along0, 0, both - w0 + 1e-4, along0 - along_both, -along0,
        along0 - along_both, (w * along * along).sum() + 1.0;
    for (const Eigen::Index k : {0, 1}) {
      if (!sides.seen[static_cast<std::size_t>(k)]) a(k, k) += 1;
    }
    return a;
  }

  void step(Sides& sides) const {
    const Values w = values(residuals_.w), first = values(residuals_.is_first);
    const Values along = values(residuals_.along), r = values(residuals_.r);
    const double r_both = (w * r).sum(), r0 = (w * first * r).sum();
    const Eigen::Vector3d g(r0, r_both - r0, -(w * along * r).sum());
    const Eigen::Vector3d delta = information(sides).inverse() * g;
    sides.offset[0] += delta[0];
    sides.offset[1] += delta[1];
    sides.heading_rad += std::clamp(delta[2], -0.2, 0.2);
  }

  FaceFit result(const Sides& sides) const {
    constexpr double kPriorPoints = 4;
    const Tally t = tally();
    const auto n = sides.normals();
    const auto count = static_cast<double>(points_.count);
    const std::size_t first = t.points[0] >= t.points[1] ? 0 : 1, second = 1 - first;
    const auto face = [&](std::size_t k) {
      return Face{n[k], sides.offset[k] + n[k].dot(points_.pivot), sides.seen[k] ? t.points[k] : 0};
    };
    FaceFit fit{face(first),      face(second), points_.pivot, {}, std::sqrt(t.squares / count),
                t.inliers / count};
    const auto trust = kCauchyScale2 / (kCauchyScale2 + values(residuals_.z2));
    const double weight = trust.sum(), chi2 = (trust * values(residuals_.z2)).sum();
    const double parameters = fit.two() ? 3 : 2;
    const double scale =
        (chi2 + kPriorPoints) / (std::max(weight - parameters, 0.0) + kPriorPoints);
    fit.covariance = information(sides).inverse() * std::max(scale, 0.5);
    if (first == 1) {
      fit.covariance.row(0).swap(fit.covariance.row(1));
      fit.covariance.col(0).swap(fit.covariance.col(1));
    }
    return fit;
  }

  FacePoints points_;
  Residuals residuals_;
  FaceFitOptions options_;
  float variance_range_;
  float variance_surface_;
  int dropped_ = -1;
};

}  // namespace

FaceFit fit_faces(std::span<const Eigen::Vector2d> points, double heading_rad, double sigma_range_m,
                  const FaceFitOptions& options) {
  return FaceFitter(points, sigma_range_m, options).run(heading_rad);
}

}  // namespace scanfuse::shape
