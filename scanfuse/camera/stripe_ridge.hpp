#pragma once

#include <span>
#include <vector>

#include "scanfuse/camera/stripe_curve.hpp"
#include "scanfuse/camera/stripe_signal.hpp"

namespace scanfuse::camera {

/// Where the surroundings are seen, in widths (sigma) of the smoothed stripe from its middle.
inline constexpr double kFlank_widths = 3.2;

/// The mean cross-section of a stripe about a curve.
struct StripeProfile {
  double height = 0;    ///< above its surroundings, counts; 0 where there is none
  double sigma_px = 0;  ///< of a Gaussian as wide at half of its height
};

/// Cross-section averaged along the curve between two places, out to `reach_px` on either side.
[[nodiscard]] StripeProfile profile_of(const Signal& signal, const StripeCurve& curve,
                                       double from_px, double to_px, double reach_px);

struct RidgeSample {
  Eigen::Vector2d position_px;
  double contrast = 0;  ///< counts
  double ambient = 0;   ///< beside the stripe, counts
  bool clipped = false;
};

/// The ridge of the signal near a curve, one point for each sample along it: where the slope across
/// the stripe of the signal, smoothed by a Gaussian of `smoothing_px`, crosses zero [Steger1998].
/// With as much smoothing as the stripe is wide this is the most likely centre under white noise.
/// `level` takes out a slope of the surroundings, as seen either side of the stripe.
[[nodiscard]] std::vector<RidgeSample> ridge_along(const Signal& signal, const StripeCurve& curve,
                                                   double from_px, double to_px,
                                                   const StripeProfile& profile,
                                                   double smoothing_px, bool level);

}  // namespace scanfuse::camera
