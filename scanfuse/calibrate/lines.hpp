#pragma once

#include <Eigen/Core>
#include <optional>
#include <span>
#include <vector>

#include "scanfuse/types/turntable.hpp"

/// Stripe points and returns of one board, each reduced to its line: all that a least-squares fit
/// of any model needs to know of them, to first order around the line. 35 000 returns and 50 000
/// stripe points become 2000 numbers, and the fit takes milliseconds.
namespace scanfuse::calibrate {

/// The straight line through the points of a stripe, in undistorted pixels (K applied). A line that
/// passes `offset` away from the centre (along the normal) and rises by `slope` adds
/// weight offset^2 + moment slope^2 to `scatter`.
struct StripeLine {
  Eigen::Vector2d centre_px = Eigen::Vector2d::Zero();
  Eigen::Vector2d along = Eigen::Vector2d::UnitX();  ///< unit; the normal is (-y, x)
  double weight = 0;   ///< sum of 1 / (px of the raw image)^2 of unit variance
  double moment = 0;   ///< the same times position along the line squared
  double scatter = 0;  ///< squared distances in raw pixels
  int count = 0;
  int outliers = 0;
  std::vector<Eigen::Vector2d> normalised;  ///< the inliers as (x/z, y/z)

  [[nodiscard]] Eigen::Vector2d normal() const { return {-along.y(), along.x()}; }
};

/// Points far from the line that most agree on are left out. Empty below 8 usable points.
[[nodiscard]] std::optional<StripeLine> fit_stripe(const Camera& camera,
                                                   std::span<const Eigen::Vector2d> points_px);

/// The straight line through returns, in the lidar's frame: normal . p = distance_m. In units of
/// the noise of one range, a model whose line passes e0 away from the centre (along the normal)
/// with the slope e1, whose ranges are too long by `bias` and by `square` times the mark of each
/// return's square, leaves the residuals z - R (e0, e1, bias, square); `scatter` stays in any case.
struct LidarLine {
  Eigen::Vector2d normal = Eigen::Vector2d::UnitX();
  double distance_m = 0;
  Eigen::Vector2d centre_m = Eigen::Vector2d::Zero();
  Eigen::Matrix4d R = Eigen::Matrix4d::Zero();  ///< upper triangular, R(0, 1) = 0
  Eigen::Vector4d z = Eigen::Vector4d::Zero();
  double scatter_m2 = 0;
  int count = 0;
  int rank = 0;

  [[nodiscard]] Eigen::Vector2d along() const { return {-normal.y(), normal.x()}; }
};

/// `squares`: of each return +1/2 on squares like the first, -1/2 on the others, 0 elsewhere;
/// empty: all 0. The fit is of least squares along the rays. Empty below 4 returns, or along a ray.
[[nodiscard]] std::optional<LidarLine> fit_returns(std::span<const BeamReturn> returns,
                                                   std::span<const double> squares = {});

}  // namespace scanfuse::calibrate
