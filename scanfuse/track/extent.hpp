#pragma once

#include "scanfuse/track/measure.hpp"

namespace scanfuse::track {

/// Length and width before anything was seen, by class (m).
[[nodiscard]] Gaussian<2> extent_prior(ObjectClass object_class);

/// Folds what a detection says of the extent into the state. A side of which both ends were seen is
/// a measurement. Of any other side only this is known: it is not shorter than what was seen, which
/// cuts the belief's lower tail off (moments of the truncated normal).
void update_extent(Gaussian<kStates>& state, const Measurement& measurement);

/// A target that turns out to be of another class: a side that no such thing has, and of which the
/// class before told more than scans did, is that of the new class. Ends that were seen stay where
/// they are.
void resize_to_class(Gaussian<kStates>& state, ObjectClass before, ObjectClass now);

}  // namespace scanfuse::track
