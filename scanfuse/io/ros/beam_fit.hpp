#pragma once

#include <optional>
#include <span>

#include "scanfuse/types/scan.hpp"

namespace scanfuse::io::ros {

/// The even beam pattern that the returns stand on, from their beam numbers and bearings: the line
/// bearing = first_azimuth + beam * step. Nothing when they are too few or do not stand on one, as
/// beams of a scanner that does not turn evenly. `columns`, `layers`: how many there are, seen or
/// not. Range limits are not known and stay zero.
[[nodiscard]] std::optional<BeamPattern> fit_beams(std::span<const Return> returns, int columns,
                                                   int layers);

}  // namespace scanfuse::io::ros
