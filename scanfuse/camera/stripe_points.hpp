#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "scanfuse/camera/stripe.hpp"
#include "scanfuse/camera/stripe_curve.hpp"

namespace scanfuse::camera {

/// The squares of a board in the image: light and dark borders, near which a stripe looks shifted.
struct SquareGrid {
  Eigen::Matrix3d squares_from_px;  ///< column and row of the inner corners
  BoardSpec spec;
  double square_px = 0;

  /// Distance to the nearest border of a square, in pixels; infinite off the squares.
  [[nodiscard]] double distance_to_border(const Eigen::Vector2d& p) const;
};

/// Where a stripe is looked for.
struct StripeRegion {
  std::vector<Eigen::Vector2d> outline_px;  ///< convex
  std::optional<SquareGrid> squares;
};

/// Measures a stripe that was found roughly: which pixels show it, how wide it is, where its centre
/// runs. A stripe without points, and why, where it turns out to be none.
[[nodiscard]] Stripe measure_stripe(const Image& on, const Image* off, const StripeRegion& region,
                                    const StripeCurve& rough, int channel,
                                    const StripeOptions& options);

}  // namespace scanfuse::camera
