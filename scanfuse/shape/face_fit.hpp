#pragma once

#include <Eigen/Core>
#include <span>
#include <tuple>

#include "scanfuse/core/options.hpp"

namespace scanfuse::shape {

struct FaceFitOptions {
  double surface_sigma_m = 0.015;
  int iterations = 4;
  int min_face_points = 2;
  double min_face_m = 0.3;

  static constexpr auto fields() {
    using O = FaceFitOptions;
    return std::tuple{
        Field{"surface_sigma_m", &O::surface_sigma_m, 0.0, 1.0,
              "how far real surfaces stray from a plane"},
        Field{"iterations", &O::iterations, 1, 50, "of the least squares"},
        Field{"min_face_points", &O::min_face_points, 1, 100, "fewer make no second face"},
        Field{"min_face_m", &O::min_face_m, 0.0, 10.0, "a shorter one is a rounded corner"},
    };
  }
};

/// One side of a rectangle turned to the sensor: normal . p = offset, with the normal outwards.
struct Face {
  Eigen::Vector2d normal = Eigen::Vector2d::Zero();
  double offset_m = 0;
  int points = 0;  ///< 0: not seen

  [[nodiscard]] Eigen::Vector2d tangent() const { return {-normal.y(), normal.x()}; }
};

/// The near sides of a rectangle, fitted to points. Sensor at the origin.
struct FaceFit {
  Face a;  ///< the one with more points
  Face b;  ///< at right angles to it; points = 0 where unseen
  Eigen::Vector2d pivot_m = Eigen::Vector2d::Zero();  ///< mean of the points
  /// Of (offset a, offset b, heading), offsets taken about the pivot; row of b unused without b.
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Identity();
  double rms_m = 0;         ///< of all points from the nearer face
  double inlier_share = 1;  ///< points within 3 sigma of a face

  [[nodiscard]] bool two() const { return b.points > 0; }
};

/// Fits the one or two visible sides to the points (metres, sensor at the origin) by iterated
/// least squares, starting from a heading known to some degrees:
///
///   minimise sum rho( (n_i . p_i - d_i) / s_i ),  s_i^2 = (n_i . u_i)^2 sigma_range^2 + surface^2
///
/// n_i is the side nearest to p_i among those that can be seen from the origin, u_i its beam, rho
/// Cauchy's: edge returns between object and background and rounded corners weigh little. The
/// covariance is that of the normal equations times the mean squared residual, held up by a prior.
/// Points may be few, collinear or equal: what they do not tell gets a large variance. More than 64
/// points are thinned evenly. Keeps no state between calls.
[[nodiscard]] FaceFit fit_faces(std::span<const Eigen::Vector2d> points, double heading_rad,
                                double sigma_range_m, const FaceFitOptions& options);

}  // namespace scanfuse::shape
