#pragma once

#include <array>
#include <span>
#include <string_view>

#include "scanfuse/types/detection.hpp"
#include "scanfuse/types/outline.hpp"

namespace scanfuse::classify {

/// What of an outline tells its class. Lengths as logarithms: what matters is their ratio. All are
/// bounded and finite for every outline; none speaks of where beside the road the object stands.
enum Feature : int {
  kLogPoints,       ///< ln points
  kLogRange,        ///< ln of the distance from the sensor, m
  kLogBeamGap,      ///< ln of the distance between beams at its range, m: what can be resolved
  kLogFill,         ///< ln of points against those expected at its range and size
  kLogLength,       ///< ln(length + 0.1 m) of the longer face
  kLogWidth,        ///< ln(width + 0.1 m) of the other one, as far as seen
  kHeight,          ///< between its lowest and highest return, m, at most 2: 0 for one layer
  kLogSupport,      ///< ln of the layers that agree, mean over the points
  kLogResidual,     ///< ln(rms distance from the faces + 1 cm)
  kRoundness,       ///< smaller by larger principal deviation [Arras2007: circularity]
  kLogRangeSpread,  ///< ln(standard deviation of the points' ranges + 2 cm) [Guo: variance]
  kCoverage,        ///< points per column that nothing nearer hides
  kLineCount,       ///< straight lines, at most 4
  kInlierShare,     ///< of the points, those on the faces
  kHiddenEnds,      ///< 0, 1, 2: ends that something nearer hides, or the edge of the view
  kFreeEnds,        ///< 1: both ends were seen of each of two faces
  kVehicleScore,    ///< of the rules in vehicle_rules.hpp
  kLogAlone,  ///< ln(distance to the next outline, at most 4 m, + 0.1 m): foliage comes in pieces
  kLayeredShare,   ///< of the points, those that several layers see; 0: the next two tell nothing
  kLogLayerDepth,  ///< ln(how far apart layers see the same bearing + 1 cm); unknown: of 5 cm
  kFeatures
};

using Features = std::array<double, kFeatures>;

/// Names for files, in the order of Feature.
[[nodiscard]] const std::array<std::string_view, kFeatures>& feature_names();

/// How far from the middle of outline `of` the box of the next one is, at most `limit_m`. Of many
/// outlines only the 64 before and behind it, in order, are looked at.
[[nodiscard]] double alone_m(std::span<const Outline> outlines, std::size_t of, double limit_m);

/// Features of outline `of`; `vehicle_score` is that of `classify::vehicle_score`, `scale` the size
/// of the scene against a real road.
[[nodiscard]] Features features_of(std::span<const Outline> outlines, std::size_t of,
                                   double vehicle_score, double scale = 1);

/// What a track averages of an outline.
[[nodiscard]] ShapeCues cues_of(const Outline& outline, double scale = 1);

}  // namespace scanfuse::classify
