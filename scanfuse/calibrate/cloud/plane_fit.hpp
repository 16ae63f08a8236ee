#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace scanfuse::calibrate {

/// A plane through points of a cloud, and how sure it is.
struct PlaneFit {
  Eigen::Vector3d centre_m =
      Eigen::Vector3d::Zero();  ///< mean of the inliers, moved onto the plane
  Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();  ///< columns u, v, normal; towards the lidar
  double rms_m = 0;  ///< of the inliers: along the rays where they are known, else across
  std::vector<std::size_t> inliers;
  /// Of the heights at the centre and the slopes along u and v: z = h + a x + b y.
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();

  [[nodiscard]] Eigen::Vector3d normal() const { return axes.col(2); }
  [[nodiscard]] double height(const Eigen::Vector3d& p) const { return normal().dot(p - centre_m); }
  [[nodiscard]] Eigen::Vector2d flat(const Eigen::Vector3d& p) const {
    return axes.leftCols<2>().transpose() * (p - centre_m);
  }
  [[nodiscard]] Eigen::Vector3d raised(const Eigen::Vector2d& q) const {
    return centre_m + axes.leftCols<2>() * q;
  }
};

/// The plane that most points lie near (random triples of a fixed seed, points within
/// `thickness_m`), refined by least squares over the points within 3.5 robust standard deviations.
/// `rays`: unit vectors from the lidar to each point, so that residuals count along the range, the
/// direction of its noise; may be empty. Nothing for fewer than 4 points, or points in a line.
[[nodiscard]] std::optional<PlaneFit> fit_plane(std::span<const Eigen::Vector3d> points,
                                                std::span<const Eigen::Vector3d> rays,
                                                double thickness_m = 0.005);

/// The same without the search for the most: from a plane that is nearly right.
[[nodiscard]] std::optional<PlaneFit> refine_plane(std::span<const Eigen::Vector3d> points,
                                                   std::span<const Eigen::Vector3d> rays,
                                                   PlaneFit start);

}  // namespace scanfuse::calibrate
