#pragma once

#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include "scanfuse/core/random.hpp"
#include "scanfuse/geometry/box.hpp"
#include "scanfuse/types/clusters.hpp"
#include "scanfuse/types/virtual_scan.hpp"

namespace scanfuse::flat_world {

/// A planar scanner among rectangles, seen from the origin: the smallest world shapes can be tested
/// in.
struct Scanner {
  double step_rad = radians(0.25);
  double sigma_range_m = 0.03;
  double half_angle_rad = radians(60);
};

/// Range along a beam to a rectangle, if it hits.
inline std::optional<double> range_to(const Box2& box, double bearing_rad) {
  const Pose2 inverse = box.pose().inverse();
  const Eigen::Vector2d from = inverse * Eigen::Vector2d::Zero();
  const Eigen::Vector2d to =
      inverse * Eigen::Vector2d(std::cos(bearing_rad), std::sin(bearing_rad));
  const Eigen::Vector2d d = to - from, half(box.length_m / 2, box.width_m / 2);
  double enter = 0, leave = std::numeric_limits<double>::infinity();
  for (const int k : {0, 1}) {
    if (std::abs(d[k]) < 1e-12) {
      if (std::abs(from[k]) > half[k]) return std::nullopt;
      continue;
    }
    const double a = (-half[k] - from[k]) / d[k], b = (half[k] - from[k]) / d[k];
    enter = std::max(enter, std::min(a, b));
    leave = std::min(leave, std::max(a, b));
  }
  if (enter >= leave || enter <= 0) return std::nullopt;
  return enter;
}

/// One scan, one cluster per box, in order of the boxes; the nearest box hides the others.
struct Snapshot {
  VirtualScan scan;
  Clusters clusters;
};

inline Snapshot look(const std::vector<Box2>& boxes, const Scanner& scanner, RandomStream& random) {
  Snapshot shot;
  shot.scan.step_rad = scanner.step_rad;
  shot.scan.sigma_range_m = scanner.sigma_range_m;
  std::vector<std::vector<std::uint32_t>> members(boxes.size());
  const int half = static_cast<int>(scanner.half_angle_rad / scanner.step_rad);
  const double phase = random.uniform(-0.5, 0.5);
  for (int column = -half; column <= half; ++column) {
    const double bearing = (column + phase) * scanner.step_rad;
    double nearest = std::numeric_limits<double>::infinity();
    std::size_t hit = boxes.size();
    for (std::size_t k = 0; k < boxes.size(); ++k) {
      const auto range = range_to(boxes[k], bearing);
      if (range && *range < nearest) nearest = *range, hit = k;
    }
    if (hit == boxes.size()) continue;
    const double range = nearest + random.normal(0, scanner.sigma_range_m);
    PlanarPoint point;
    point.x_m = static_cast<float>(range * std::cos(bearing));
    point.y_m = static_cast<float>(range * std::sin(bearing));
    point.range_m = static_cast<float>(range);
    point.bearing_rad = static_cast<float>(bearing);
    point.column = column;
    members[hit].push_back(static_cast<std::uint32_t>(shot.scan.points.size()));
    shot.scan.points.push_back(point);
  }
  for (const auto& member : members) {
    shot.clusters.indices.insert(shot.clusters.indices.end(), member.begin(), member.end());
    shot.clusters.close();
  }
  return shot;
}

}  // namespace scanfuse::flat_world
