#pragma once

#include "scanfuse/track/options.hpp"
#include "scanfuse/track/target.hpp"
#include "scanfuse/types/detection.hpp"

namespace scanfuse::track {

/// One side of a box as a detection tells it.
struct MeasuredSide {
  double size_m = 0;
  double variance_m2 = 1;
  bool seen = false;    ///< both ends; else `size_m` is a prior or a lower bound
  bool bounded = true;  ///< `size_m` speaks of this side: not when believed of the other one
};

/// A detection as a linear measurement of a target:
///
///   z = p_a + v,   p_a = c + t velocity + R(heading) [s_l length / 2, s_w width / 2]' = H x
///
/// c is the centre at the scan's stamp, t the time from there until the object's beams were fired,
/// p_a the point that was really placed: the corner turned to the sensor when two faces were seen
/// (s = +-1), the middle of a single whole face (s = 0 along it), or its free end when the other
/// one was hidden. How far the centre lies from there is the target's belief of its own extent, not
/// the detection's.
struct Measurement {
  Gaussian<2> position;
  Eigen::Matrix<double, 2, kStates> H;
  double heading_rad = 0;  ///< of the two or four that the box allows, the nearest to the target's
  double var_heading_rad2 = 1;
  MeasuredSide length;
  MeasuredSide width;
};

/// Whether all numbers of a detection that the tracker reads are finite and of a size that
/// arithmetic survives.
[[nodiscard]] bool is_usable(const Detection& detection);

/// `heading_rad` is what is believed before the detection; the box is turned to the nearest.
[[nodiscard]] Measurement measure(const Detection& detection, double heading_rad,
                                  const TrackerOptions& options);

/// Adds the sideways error that an uncertain heading makes when the believed extent reaches
/// farther from the seen end than the detected one did.
[[nodiscard]] Measurement measure(const Detection& detection, const Target& target,
                                  const TrackerOptions& options);

}  // namespace scanfuse::track
