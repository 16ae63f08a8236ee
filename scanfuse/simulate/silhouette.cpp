#include "scanfuse/simulate/silhouette.hpp"

#include <algorithm>
#include <cmath>

namespace scanfuse::simulate {

Silhouette silhouette(const Polygon& footprint, const Pose2& world_from_actor,
                      const Pose2& world_from_sensor) {
  const Pose2 sensor_from_actor = world_from_sensor.inverse() * world_from_actor;
  Silhouette seen{kPi, -kPi};
  for (const auto& corner : footprint) {
    const Eigen::Vector2d p = sensor_from_actor * corner;
    const double bearing = std::atan2(p.y(), p.x());
    seen.right_rad = std::min(seen.right_rad, bearing);
    seen.left_rad = std::max(seen.left_rad, bearing);
  }
  return seen;
}

bool overlap(const Box2& a, const Box2& b) {
  const auto apart_along = [&](double heading_rad) {
    const Eigen::Vector2d axis(std::cos(heading_rad), std::sin(heading_rad));
    const auto half_extent = [&](const Box2& box) {
      const double turned = box.heading_rad - heading_rad;
      return (std::abs(std::cos(turned)) * box.length_m +
              std::abs(std::sin(turned)) * box.width_m) /
             2;
    };
    return std::abs(axis.dot(a.centre_m - b.centre_m)) > half_extent(a) + half_extent(b);
  };
  return !apart_along(a.heading_rad) && !apart_along(a.heading_rad + kPi / 2) &&
         !apart_along(b.heading_rad) && !apart_along(b.heading_rad + kPi / 2);
}

double find_zero(const std::function<double(double)>& f, double low, double high) {
  const bool rising = f(high) > 0;
  for (int i = 0; i < 50; ++i) {
    const double middle = (low + high) / 2;
    ((f(middle) > 0) == rising ? high : low) = middle;
  }
  return (low + high) / 2;
}

}  // namespace scanfuse::simulate
