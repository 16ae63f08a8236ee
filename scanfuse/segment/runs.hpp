#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "scanfuse/core/disjoint_sets.hpp"
#include "scanfuse/geometry/angles.hpp"
#include "scanfuse/types/virtual_scan.hpp"

// What the ways of segmentation share that follow a scan from bearing to bearing.
namespace scanfuse::segment {

/// Columns hold a few points at most; this keeps scans without column numbers linear.
inline constexpr std::size_t kLookBack = 16;

[[nodiscard]] inline double squared_distance(const PlanarPoint& a, const PlanarPoint& b) {
  const double dx = static_cast<double>(a.x_m) - b.x_m, dy = static_cast<double>(a.y_m) - b.y_m;
  return dx * dx + dy * dy;
}

/// One past the last point of the same bearing column as point `i`.
[[nodiscard]] inline std::size_t column_end(const std::vector<PlanarPoint>& points, std::size_t i) {
  std::size_t end = i + 1;
  while (end < points.size() && points[end].column == points[i].column) ++end;
  return end;
}

/// Joins what `linked(earlier, later, gap_rad)` holds together among the points of each bearing
/// column and the occupied column before it; on a full circle the last column comes before the
/// first.
template <class Linked>
void join_runs(const VirtualScan& scan, DisjointSets& sets, Linked linked) {
  const auto& points = scan.points;
  sets.reset(points.size());
  std::size_t previous = 0, begin = 0;
  while (begin < points.size()) {
    const std::size_t end = column_end(points, begin);
    for (std::size_t i = begin; i < end; ++i) {
      for (std::size_t j = std::max(previous, i - std::min(i, kLookBack)); j < i; ++j) {
        const double gap = static_cast<double>(points[i].bearing_rad) - points[j].bearing_rad;
        if (linked(points[j], points[i], gap)) {
          sets.join(static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(j));
        }
      }
    }
    previous = begin;
    begin = end;
  }
  if (!scan.full_circle || previous == 0) return;
  for (std::size_t i = 0; i < column_end(points, 0); ++i) {
    for (std::size_t j = std::max(previous, points.size() - std::min(points.size(), kLookBack));
         j < points.size(); ++j) {
      const double gap = 2 * kPi + points[i].bearing_rad - points[j].bearing_rad;
      if (linked(points[j], points[i], gap)) {
        sets.join(static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(j));
      }
    }
  }
}

/// The root of every point's set.
inline void label_roots(DisjointSets& sets, std::vector<std::uint32_t>& labels, std::size_t count) {
  labels.resize(count);
  for (std::uint32_t i = 0; i < count; ++i) labels[i] = sets.find(i);
}

}  // namespace scanfuse::segment
