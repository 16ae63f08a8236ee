#pragma once

#include <Eigen/Core>
#include <optional>

#include "scanfuse/triangulate/line_of_sight.hpp"

namespace scanfuse::triangulate {

/// Where two lines of sight come nearest to each other. A line without elevation stands for the
/// upright plane that its azimuth spans: it meets a line exactly, and another plane at the height
/// of the sensors' middle.
struct ClosestPoints {
  Eigen::Vector3d middle_m = Eigen::Vector3d::Zero();
  double sigmas_apart = 0;  ///< how far the lines miss each other against what both sigmas explain
};

/// Empty for lines that are parallel (to 1e-4 rad), or meet behind a sensor or at it.
[[nodiscard]] std::optional<ClosestPoints> closest_points(const LineOfSight& a,
                                                          const LineOfSight& b);

}  // namespace scanfuse::triangulate
