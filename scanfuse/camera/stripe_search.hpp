#pragma once

#include <optional>
#include <span>

#include "scanfuse/camera/stripe_curve.hpp"
#include "scanfuse/camera/stripe_signal.hpp"

namespace scanfuse::camera {

/// A stripe as seen from afar.
struct RoughStripe {
  StripeCurve curve;
  double score = 0;  ///< grows with its length and contrast
  double length_px = 0;
};

/// The longest and strongest ridge of a coarse plane inside a polygon: ridge points of the Hessian
/// [Steger1998], the line through two of them that most others support, a parabola through those.
/// The same plane gives the same stripe. Nothing where no ridge is longer than a few cells.
[[nodiscard]] std::optional<RoughStripe> search_stripe(const CoarsePlane& plane,
                                                       std::span<const Eigen::Vector2d> polygon_px);

}  // namespace scanfuse::camera
