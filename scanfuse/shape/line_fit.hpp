#pragma once

#include <span>

#include "scanfuse/types/outline.hpp"

namespace scanfuse::shape {

/// The line of least perpendicular distance through `points` (metres), from the foot of the first
/// to the foot of the last. One point, or all points equal: a segment of length 0. `points` not
/// empty.
[[nodiscard]] LineSegment fit_segment(std::span<const Eigen::Vector2d> points);

/// The line through the first and the last point, as [Lu2018] takes it. `points` not empty.
[[nodiscard]] LineSegment chord(std::span<const Eigen::Vector2d> points);

}  // namespace scanfuse::shape
