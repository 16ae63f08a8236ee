#include "scanfuse/shape/face_fit.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "scanfuse/shape/four.hpp"

namespace scanfuse::shape {
namespace {

constexpr std::size_t kMostFacePoints = 64;
constexpr float kCauchyScale2 = 2.385f * 2.385f;
constexpr float kInlierZ2 = 9;

/// Points against their sides, four at a time: residual and its variance, place along the side,
/// weight over variance, 1 where the side is the first.
struct Residual {
  Four r, variance, along, w, is_first;
};

/// Points about their mean.
struct FacePoints {
  Eigen::Vector2d pivot = Eigen::Vector2d::Zero();
  std::size_t count = 0;
  std::size_t fours = 0;
  FourColumn<kMostFacePoints> x, y;  ///< the first `fours` are set
  FourColumn<kMostFacePoints> per_range2;
  FourColumn<kMostFacePoints> counts;  ///< 1; 0 for what fills up the last four
};

FacePoints thin(std::span<const Eigen::Vector2d> points) {
  FacePoints out;
  for (const auto& p : points) out.pivot += p;
  out.pivot /= static_cast<double>(points.size());
  const auto set = [&out](std::size_t i, const Eigen::Vector2d& p, float counts) {
    out.x.set(i, static_cast<float>(p.x() - out.pivot.x()));
    out.y.set(i, static_cast<float>(p.y() - out.pivot.y()));
    out.counts.set(i, counts);
  };
  const std::size_t stride = (points.size() + kMostFacePoints - 1) / kMostFacePoints;
  for (std::size_t i = 0; i < points.size(); i += stride) set(out.count++, points[i], 1);
  out.fours = (out.count + 3) / 4;
  for (std::size_t i = out.count; i < 4 * out.fours; ++i) set(i, points.front(), 0);
  for (std::size_t i = 0; i < out.fours; ++i) {
    const Four x = out.x[i] + four(out.pivot.x()), y = out.y[i] + four(out.pivot.y());
    out.per_range2[i] = four(1) / max(x * x + y * y, four(1e-12));
  }
  return out;
}

/// State of the fit: two orthogonal outward normals, offsets about the pivot.
struct Sides {
  double heading_rad = 0;  ///< of the first axis
  double cosine = 1, sine = 0;
  std::array<double, 2> sign{1, 1};
  std::array<double, 2> offset{};
  std::array<bool, 2> seen{true, true};

  void turn_to(double heading) {
    heading_rad = heading;
    cosine = std::cos(heading);
    sine = std::sin(heading);
  }
  [[nodiscard]] std::array<Eigen::Vector2d, 2> normals() const {
    return {Eigen::Vector2d(sign[0] * cosine, sign[0] * sine),
            Eigen::Vector2d(-sign[1] * sine, sign[1] * cosine)};
  }
};

/// Sums of the normal equations; those with 0 over the points of the first side.
struct Sums {
  double w = 0, w0 = 0, along = 0, along0 = 0, along2 = 0;
  double r = 0, r0 = 0, along_r = 0;
};

/// What the residuals tell about the sides.
struct Tally {
  double squares = 0;
  double inliers = 0;
  double trust = 0, chi2 = 0;  ///< Cauchy's weights, and squared residuals with them
  std::array<int, 2> points{};
  std::array<float, 2> low{}, high{};  ///< along each side
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
      const bool settled = step(sides);
      measure(sides);
      if (settled) break;
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
    sides.turn_to(heading_rad);
    const auto axes = sides.normals();
    for (const std::size_t k : {0, 1}) {
      if (axes[k].dot(points_.pivot) > 0) sides.sign[k] = -1;
    }
    const auto n = sides.normals();
    for (const std::size_t k : {0, 1}) {
      const Four nx = four(n[k].x()), ny = four(n[k].y());
      Four most = four(-std::numeric_limits<float>::infinity());
      for (std::size_t i = 0; i < points_.fours; ++i) {
        most = max(most, nx * points_.x[i] + ny * points_.y[i]);
      }
      sides.offset[k] = highest(most);
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

  /// Fills residuals_ and sums_.
  void measure(Sides& sides) {
    const auto n = sides.normals();
    see(sides, n);
    const Four n0x = four(n[0].x()), n0y = four(n[0].y());
    const Four n1x = four(n[1].x()), n1y = four(n[1].y());
    const Four pivot0 = four(n[0].dot(points_.pivot)), pivot1 = four(n[1].dot(points_.pivot));
    const Four o0 = four(sides.offset[0]), o1 = four(sides.offset[1]);
    const Four far0 = four(sides.seen[0] ? 0 : 1e12), far1 = four(sides.seen[1] ? 0 : 1e12);
    const Four range = four(variance_range_), surface = four(variance_surface_);
    Four w_sum{}, w0_sum{}, along_sum{}, along0_sum{}, along2_sum{}, r_sum{}, r0_sum{}, ar_sum{};
    for (std::size_t i = 0; i < points_.fours; ++i) {
      const Four x = points_.x[i], y = points_.y[i], per_range2 = points_.per_range2[i];
      const Four q0 = n0x * x + n0y * y, q1 = n1x * x + n1y * y;
      const Four r0 = q0 - o0, r1 = q1 - o1;
      const Four slant0 = q0 + pivot0, slant1 = q1 + pivot1;  // n . u times the range
      const Four v0 = surface + range * slant0 * slant0 * per_range2;
      const Four v1 = surface + range * slant1 * slant1 * per_range2;
      const auto first = (r0 * r0 + far0) * v1 <= (r1 * r1 + far1) * v0;
      const Four r = first ? r0 : r1, v = first ? v0 : v1;
      const Four along = first ? n0x * y - n0y * x : n1x * y - n1y * x;
      const Four w = points_.counts[i] * kCauchyScale2 / (kCauchyScale2 * v + r * r);
      const Four w0 = first ? w : Four{}, wa = w * along, wr = w * r;
      residuals_[i] = {r, v, along, w, first ? four(1) : Four{}};
      w_sum += w, w0_sum += w0;
      along_sum += wa, along0_sum += w0 * along, along2_sum += wa * along;
      r_sum += wr, r0_sum += w0 * r, ar_sum += wa * r;
    }
    sums_ = {sum(w_sum),      sum(w0_sum), sum(along_sum), sum(along0_sum),
             sum(along2_sum), sum(r_sum),  sum(r0_sum),    sum(ar_sum)};
  }

  Tally tally() const {
    const Four none = four(1e9);
    std::array<Four, 2> low{none, none}, high{-none, -none};
    Four squares{}, inliers{}, first_points{}, trust{}, chi2{};
    for (std::size_t i = 0; i < points_.fours; ++i) {
      const Residual& p = residuals_[i];
      const Four counts = points_.counts[i];
      const Four inlier = p.r * p.r < kInlierZ2 * p.variance ? counts : Four{};
      const Four first = inlier * p.is_first, second = inlier - first;
      squares += counts * p.r * p.r;
      inliers += inlier;
      first_points += counts * p.is_first;
      trust += p.w * p.variance;
      chi2 += p.w * p.r * p.r;
      low[0] = min(low[0], first > 0 ? p.along : none);
      low[1] = min(low[1], second > 0 ? p.along : none);
      high[0] = max(high[0], first > 0 ? p.along : -none);
      high[1] = max(high[1], second > 0 ? p.along : -none);
    }
    const int of_first = static_cast<int>(sum(first_points));
    return {sum(squares),
            sum(inliers),
            sum(trust),
            sum(chi2),
            {of_first, static_cast<int>(points_.count) - of_first},
            {lowest(low[0]), lowest(low[1])},
            {highest(high[0]), highest(high[1])}};
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

  /// Normal equations in (offset 0, offset 1, heading), held up by weak priors. The residual
  /// n . q - d changes with heading by the place along the side, with d by -1.
  Eigen::Matrix3d information(const Sides& sides) const {
    const Sums& s = sums_;
    Eigen::Matrix3d a;
    a << s.w0 + 1e-4, 0, -s.along0, 0, s.w - s.w0 + 1e-4, s.along0 - s.along, -s.along0,
        s.along0 - s.along, s.along2 + 1.0;
    for (const Eigen::Index k : {0, 1}) {
      if (!sides.seen[static_cast<std::size_t>(k)]) a(k, k) += 1;
    }
    return a;
  }

  /// One Gauss-Newton step; whether it moved next to nothing.
  bool step(Sides& sides) const {
    const Eigen::Vector3d g(sums_.r0, sums_.r - sums_.r0, -sums_.along_r);
    const Eigen::Vector3d delta = information(sides).inverse() * g;
    sides.offset[0] += delta[0];
    sides.offset[1] += delta[1];
    sides.turn_to(sides.heading_rad + std::clamp(delta[2], -0.2, 0.2));
    const double small = 0.05 * std::sqrt(static_cast<double>(variance_range_ + variance_surface_));
    return std::abs(delta[2]) < 1e-3 && delta.head<2>().cwiseAbs().maxCoeff() < small;
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
    const double parameters = fit.two() ? 3 : 2;
    const double scale =
        (t.chi2 + kPriorPoints) / (std::max(t.trust - parameters, 0.0) + kPriorPoints);
    fit.covariance = information(sides).inverse() * std::max(scale, 0.5);
    if (first == 1) {
      fit.covariance.row(0).swap(fit.covariance.row(1));
      fit.covariance.col(0).swap(fit.covariance.col(1));
    }
    return fit;
  }

  FacePoints points_;
  std::array<Residual, kMostFacePoints / 4> residuals_;
  Sums sums_;
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
