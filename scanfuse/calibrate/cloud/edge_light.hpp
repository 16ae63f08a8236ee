#pragma once

#include <span>

#include "scanfuse/calibrate/cloud/disc_likelihood.hpp"

namespace scanfuse::calibrate {

/// Share of a round, evenly lit spot of radius 1 that lies on the target, with the spot's middle
/// `u` beyond the edge (negative: on the target): (acos u - u sqrt(1 - u^2)) / pi.
[[nodiscard]] double spot_share(double u);
/// The place at which the share is `share`; within [-1, 1].
[[nodiscard]] double spot_place(double share);

/// What is known of the beam beside its returns.
struct EdgeLightOptions {
  double spacing_m = 0;    ///< distance of neighbouring beams in the plane
  double tolerance_m = 0;  ///< a return further from a surface is mixed
  double spot_m = 0;       ///< diameter of the spot on the target; 0: unknown
};

/// Where beams change from the target to what is behind it, seen from the edge itself.
///
/// A beam that an edge cuts tells the echo that is the stronger of two, or their mean by light.
/// Both change sides where target and background throw back equally much, at the share f = A2 / (A1
/// + A2) of the spot on the target with A1 and A2 their intensities: beyond the edge where the
/// target is the lighter one, so that it is seen too large. Two ways to know how far:
///
/// - Echoes apart: such a beam's intensity is A1 f(d), or A2 (1 - f(d)) of one told on the
///   background. The edge is where those cross half of what they are away from it; spot and edge
///   are fitted to both. This holds too where nothing is behind the target.
/// - Echoes in one: the band of mixed beams reaches from share f1 to f2, those at which the mean is
///   `tolerance` away from target and background. Its width gives the spot and with it the shift.
///
/// Intensities are taken to be in proportion to light. Without them, or where they do not change
/// at the edge, the shift is 0.
[[nodiscard]] EdgeShift edge_shift(std::span<const EdgeBeam> beams, const DiscEdge& edge,
                                   const EdgeLightOptions& options);

}  // namespace scanfuse::calibrate
