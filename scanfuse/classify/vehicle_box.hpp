#pragma once

#include "scanfuse/classify/vehicle_options.hpp"
#include "scanfuse/types/detection.hpp"
#include "scanfuse/types/outline.hpp"

namespace scanfuse::classify {

/// The whole vehicle behind what was seen of it. A face no wider than a vehicle is its rear or
/// front, a longer one its side; extents are the seen ones where both ends are free, else those of
/// the prior, at least what was seen, and the two are weighed by their variances. The box grows
/// away from what was seen: behind the near faces, and behind an end that something nearer hides.
/// Fills every field of the detection but class and score.
[[nodiscard]] Detection complete_vehicle(const Outline& outline, const RecognizerOptions& options);

/// An object of unknown kind: the box as seen, at least as wide as a few centimetres.
[[nodiscard]] Detection as_seen(const Outline& outline);

}  // namespace scanfuse::classify
