#pragma once

#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "scanfuse/core/random.hpp"
#include "scanfuse/geometry/box.hpp"
#include "scanfuse/types/virtual_scan.hpp"

namespace scanfuse::segment::testing {

/// A virtual scan of boxes, and the box that each point lies on.
struct RayScene {
  VirtualScan scan;
  std::vector<std::int32_t> objects;
};

/// Distance along a ray from the origin to the box, infinity when it misses.
inline double cast_ray(const Box2& box, double bearing) {
  double nearest = std::numeric_limits<double>::infinity();
  const auto corners = box.corners();
  const Eigen::Vector2d ray(std::cos(bearing), std::sin(bearing));
  for (std::size_t k = 0; k < 4; ++k) {
    const Eigen::Vector2d a = corners[k], edge = corners[(k + 1) % 4] - a;
    const double cross = ray.x() * edge.y() - ray.y() * edge.x();
    if (std::abs(cross) < 1e-12) continue;
    const double along = (a.x() * edge.y() - a.y() * edge.x()) / cross;
    const double share = (a.x() * ray.y() - a.y() * ray.x()) / cross;
    if (along > 0 && share >= 0 && share <= 1 && along < nearest) nearest = along;
  }
  return nearest;
}

inline PlanarPoint planar_point(double range, double bearing) {
  PlanarPoint p;
  p.range_m = static_cast<float>(range);
  p.bearing_rad = static_cast<float>(bearing);
  p.x_m = static_cast<float>(range * std::cos(bearing));
  p.y_m = static_cast<float>(range * std::sin(bearing));
  return p;
}

inline RayScene cast_scene(const std::vector<Box2>& boxes, std::uint64_t seed, int beams = 440,
                           double step = radians(0.25), double first = radians(-55)) {
  RayScene scene;
  RandomStream noise(seed);
  scene.scan.step_rad = step;
  scene.scan.full_circle = beams * step > 2 * kPi - step;
  for (int i = 0; i < beams; ++i) {
    const double bearing = first + i * step;
    double nearest = 80;
    int object = -1;
    for (std::size_t b = 0; b < boxes.size(); ++b) {
      const double range = cast_ray(boxes[b], bearing);
      if (range < nearest) nearest = range, object = static_cast<int>(b);
    }
    if (object < 0) continue;
    PlanarPoint p = planar_point(nearest + noise.normal(0, 0.03), bearing);
    p.column = i;
    p.source = static_cast<std::uint32_t>(scene.scan.points.size());
    scene.scan.points.push_back(p);
    scene.objects.push_back(object);
  }
  return scene;
}

/// Two barriers and three cars, one in each lane.
inline RayScene three_cars(std::uint64_t seed) {
  return cast_scene({{{40, 8.1}, 0, 90, 0.2},
                     {{40, -8.1}, 0, 90, 0.2},
                     {{17, 0.3}, 0.03, 4.5, 1.8},
                     {{28, 4.2}, -0.04, 4.2, 1.8},
                     {{36, -3.4}, 0, 4.6, 1.9}},
                    seed);
}

}  // namespace scanfuse::segment::testing
