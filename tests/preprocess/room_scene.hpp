#pragma once

#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "scanfuse/core/random.hpp"
#include "scanfuse/core/time.hpp"
#include "scanfuse/geometry/pose.hpp"
#include "scanfuse/types/virtual_scan.hpp"

namespace scanfuse::preprocess {

struct Wall {
  Eigen::Vector2d from_m, to_m;
};

inline std::vector<Wall> box_walls(Eigen::Vector2d low, Eigen::Vector2d high) {
  const Eigen::Vector2d a(low.x(), high.y()), b(high.x(), low.y());
  return {{low, b}, {b, high}, {high, a}, {a, low}};
}

/// A room of 10 x 7 m with two cupboards.
inline std::vector<Wall> room() {
  auto walls = box_walls({-4, -3}, {6, 4});
  for (const auto& more : {box_walls({2, 2}, {3.2, 2.8}), box_walls({-3, -2.5}, {-2.2, -1})}) {
    walls.insert(walls.end(), more.begin(), more.end());
  }
  return walls;
}

/// What a scanner of 360 beams sees from `world_from_sensor`, to 12 m, with 1 cm of noise.
inline VirtualScan look(const std::vector<Wall>& walls, const Pose2& world_from_sensor,
                        double stamp_s, RandomStream& random) {
  VirtualScan scan;
  scan.stamp = time_from_seconds(stamp_s);
  scan.sigma_range_m = 0.01;
  scan.full_circle = true;
  scan.step_rad = 2 * std::numbers::pi / 360;
  const Eigen::Vector2d from(world_from_sensor.x_m, world_from_sensor.y_m);
  for (int k = 0; k < 360; ++k) {
    const double bearing = -std::numbers::pi + k * scan.step_rad;
    const double course = bearing + world_from_sensor.heading_rad;
    const Eigen::Vector2d ray(std::cos(course), std::sin(course));
    double range = std::numeric_limits<double>::infinity();
    for (const Wall& wall : walls) {
      const Eigen::Vector2d along = wall.to_m - wall.from_m, to = wall.from_m - from;
      const double cross = ray.x() * along.y() - ray.y() * along.x();
      if (std::abs(cross) < 1e-12) continue;
      const double r = (to.x() * along.y() - to.y() * along.x()) / cross;
      const double share = (to.x() * ray.y() - to.y() * ray.x()) / cross;
      if (r > 0.05 && share >= 0 && share <= 1) range = std::min(range, r);
    }
    if (!(range < 12)) continue;
    range += random.normal(0, 0.01);
    PlanarPoint point;
    point.x_m = static_cast<float>(range * std::cos(bearing));
    point.y_m = static_cast<float>(range * std::sin(bearing));
    point.range_m = static_cast<float>(range);
    point.bearing_rad = static_cast<float>(bearing);
    point.column = k;
    scan.points.push_back(point);
  }
  return scan;
}

}  // namespace scanfuse::preprocess
