#pragma once

#include <span>
#include <vector>

#include "scanfuse/types/outline.hpp"

namespace scanfuse::shape {

/// The line of least perpendicular distance through `points` (metres), from the foot of the first
/// to the foot of the last. One point, or all points equal: a segment of length 0. `points` not
/// empty.
[[nodiscard]] LineSegment fit_segment(std::span<const Eigen::Vector2d> points);

/// Running sums of points, so that the line through any stretch of them costs the same.
class RunningSums {
 public:
  /// Starts over with these points (metres); they must outlive the calls to `fit`.
  void reset(std::span<const Eigen::Vector2d> points);
  /// As fit_segment on points[first..last], both inclusive.
  [[nodiscard]] LineSegment fit(std::size_t first, std::size_t last) const;

 private:
  struct Sums {
    double x = 0, y = 0, xx = 0, xy = 0, yy = 0;
  };
  std::span<const Eigen::Vector2d> points_;
  std::vector<Sums> sums_;  ///< of all points before; about the first point
};

/// The line through the first and the last point, as [Lu2018] takes it. `points` not empty.
[[nodiscard]] LineSegment chord(std::span<const Eigen::Vector2d> points);

}  // namespace scanfuse::shape
