#pragma once

#include <Eigen/Core>
#include <optional>
#include <span>
#include <vector>

namespace scanfuse::camera {

/// A nearly straight curve in the image: across = c0 + c1 s + c2 s^2, s = (along - middle) / half.
/// Upright: along is v, across is u; else the other way round.
struct StripeCurve {
  bool upright = true;
  double middle_px = 0;
  double half_px = 1;
  double c0 = 0, c1 = 0, c2 = 0;

  [[nodiscard]] double across(double along_px) const {
    const double s = (along_px - middle_px) / half_px;
    return c0 + s * (c1 + s * c2);
  }
  /// d across / d along
  [[nodiscard]] double slope(double along_px) const {
    return (c1 + 2 * c2 * (along_px - middle_px) / half_px) / half_px;
  }
  [[nodiscard]] double along_of(const Eigen::Vector2d& p) const { return upright ? p.y() : p.x(); }
  [[nodiscard]] Eigen::Vector2d point(double along_px, double across_px) const {
    return upright ? Eigen::Vector2d(across_px, along_px) : Eigen::Vector2d(along_px, across_px);
  }
  /// Signed distance of a point, in pixels; the curve bends little.
  [[nodiscard]] double distance(const Eigen::Vector2d& p) const;
  [[nodiscard]] Eigen::Vector2d normal(double along_px) const;  ///< the way distance grows
};

struct CurveFit {
  StripeCurve curve;
  double scatter_px = 0;      ///< rms distance of the inliers
  std::vector<bool> inliers;  ///< of the points given
};

/// Least squares with Tukey's weights: points further off than 4.7 robust standard deviations (but
/// no less than `floor_px`) do not count. Nothing for fewer than 5 points or points at one place.
[[nodiscard]] std::optional<CurveFit> fit_curve(std::span<const Eigen::Vector2d> points,
                                                const StripeCurve& start, double floor_px);

}  // namespace scanfuse::camera
