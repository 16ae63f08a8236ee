#pragma once

#include "scanfuse/classify/vehicle_options.hpp"
#include "scanfuse/types/outline.hpp"

namespace scanfuse::classify {

/// How far x is inside [low, high]: 1 inside, 0 from `slack` outside, linear between.
[[nodiscard]] double membership(double x, double low, double high, double slack);

/// How much an outline looks like a vehicle, 0..1: the product of memberships of its size (a rear
/// or front, a side, or a corner of both; ends hidden by something nearer count as unseen), of the
/// share of points on straight faces, of the share of beams that returned, and of the number of
/// points. The rules and their reasons: docs/detection.md.
[[nodiscard]] double vehicle_score(const Outline& outline, const RecognizerOptions& options);

/// [Lu2018] names line count, shape and size and leaves the rules to its reference 9, where they
/// are not printed. Ours: one line as long as a car is wide or long, or two at right angles of
/// which one is at most as long as a car is wide, the other at most as long as a car is long, and
/// one of the two is at least as long as a car is wide.
[[nodiscard]] bool is_vehicle_lu2018(const Outline& outline, const RecognizerOptions& options);

}  // namespace scanfuse::classify
