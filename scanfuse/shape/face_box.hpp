#pragma once

#include <span>

#include "scanfuse/shape/face_fit.hpp"
#include "scanfuse/shape/occlusion.hpp"
#include "scanfuse/types/outline.hpp"

namespace scanfuse::shape {

/// Where beams fall around the ends of a face.
struct BeamSpacing {
  double step_rad = 0;  ///< between columns
  double max_gap_m = 1;
  double slack_m = 0.1;  ///< points further from a face do not belong to it
};

/// Turns fitted faces into the box of an outline, tight around the points but for half a beam at
/// free ends: the true end lies anywhere between the last beam that hit and the first that missed,
/// so its variance is gap^2 / 12. Sets box, covariance (of the corner, or of the middle of a single
/// face), faces_seen, residual_m, inlier_share and the variances of the extent.
void set_box(const FaceFit& fit, std::span<const Eigen::Vector2d> points, const CutEnds& cut,
             const BeamSpacing& beams, Outline& outline);

}  // namespace scanfuse::shape
