#pragma once

#include <array>
#include <vector>

#include "scanfuse/geometry/box.hpp"

namespace scanfuse {

namespace overlap_detail {

inline double cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  return a.x() * b.y() - a.y() * b.x();
}

/// The part of a convex polygon to the left of the line from `from` to `to`.
inline std::vector<Eigen::Vector2d> clip(const std::vector<Eigen::Vector2d>& polygon,
                                         const Eigen::Vector2d& from, const Eigen::Vector2d& to) {
  std::vector<Eigen::Vector2d> kept;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Eigen::Vector2d &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
    const double side_a = cross(to - from, a - from), side_b = cross(to - from, b - from);
    if (side_a >= 0) kept.push_back(a);
    if ((side_a >= 0) != (side_b >= 0)) kept.push_back(a + side_a / (side_a - side_b) * (b - a));
  }
  return kept;
}

inline double area(const std::vector<Eigen::Vector2d>& polygon) {
  double twice = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    twice += cross(polygon[i], polygon[(i + 1) % polygon.size()]);
  }
  return 0.5 * std::abs(twice);
}

}  // namespace overlap_detail

/// Area of both over area of either, 0..1: the bird's-eye-view IoU of two boxes. The corners of one
/// are clipped by the sides of the other [Sutherland1974]. 0 where a box has no area.
[[nodiscard]] inline double intersection_over_union(const Box2& a, const Box2& b) {
  const double area_a = a.length_m * a.width_m, area_b = b.length_m * b.width_m;
  if (!(area_a > 0 && area_b > 0)) return 0;
  const auto corners = a.corners(), sides = b.corners();  // counter-clockwise
  std::vector<Eigen::Vector2d> both(corners.begin(), corners.end());
  for (std::size_t i = 0; i < sides.size() && !both.empty(); ++i) {
    both = overlap_detail::clip(both, sides[i], sides[(i + 1) % sides.size()]);
  }
  const double shared = overlap_detail::area(both);
  return shared / (area_a + area_b - shared);
}

}  // namespace scanfuse
