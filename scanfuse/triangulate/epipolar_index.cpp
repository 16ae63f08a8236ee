#include "scanfuse/triangulate/epipolar_index.hpp"

#include <Eigen/Geometry>
#include <algorithm>

namespace scanfuse::triangulate {
namespace {

constexpr double kOnePlace_m = 1e-3;

}  // namespace

EpipolarIndex::EpipolarIndex(const Eigen::Vector3d& other_origin_m,
                             std::span<const LineOfSight> lines) {
  if (lines.empty()) return;
  const Eigen::Vector3d baseline = lines.front().origin_m - other_origin_m;
  if (baseline.norm() > kOnePlace_m) {
    along_ = baseline.normalized();
    across_ = along_.unitOrthogonal();
    up_ = along_.cross(across_);
  }
  for (std::size_t i = 0; i < lines.size(); ++i) {
    Plane plane = plane_of(lines[i]);
    plane.line = static_cast<std::int32_t>(i);
    if (plane.sigma_rad > kWide) {
      everywhere_.push_back(plane.line);
    } else {
      sorted_.push_back(plane);
      widest_rad_ = std::max(widest_rad_, plane.sigma_rad);
    }
  }
  std::sort(sorted_.begin(), sorted_.end(), [](const Plane& a, const Plane& b) {
    return std::pair(a.angle_rad, a.line) < std::pair(b.angle_rad, b.line);
  });
}

EpipolarIndex::Plane EpipolarIndex::plane_of(const LineOfSight& line) const {
  Plane plane;
  plane.sigma_rad = 10;  // none
  const double a = across_.dot(line.direction), b = up_.dot(line.direction);
  const double away = std::hypot(a, b);
  if (along_.isZero() || !line.tells_elevation() || away < 1e-9) return plane;
  plane.angle_rad = std::atan2(b, a);
  plane.sigma_rad = std::max(line.sigma_left_rad, line.sigma_up_rad) / away;
  return plane;
}

std::size_t EpipolarIndex::first_at(double angle_rad) const {
  const auto first =
      std::lower_bound(sorted_.begin(), sorted_.end(), angle_rad,
                       [](const Plane& plane, double angle) { return plane.angle_rad < angle; });
  return static_cast<std::size_t>(first - sorted_.begin());
}

AzimuthIndex::AzimuthIndex(const PassiveSensor& sensor, std::span<const LineOfSight> lines)
    : sensor_from_world_(sensor.world_from_sensor.inverse()) {
  sorted_.reserve(lines.size());
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const Eigen::Vector3d d = sensor_from_world_.rotation * lines[i].direction;
    sorted_.emplace_back(std::atan2(d.y(), d.x()), static_cast<std::int32_t>(i));
  }
  std::sort(sorted_.begin(), sorted_.end());
}

std::size_t AzimuthIndex::first_at(double azimuth_rad) const {
  const auto first =
      std::lower_bound(sorted_.begin(), sorted_.end(), azimuth_rad,
                       [](const auto& entry, double azimuth) { return entry.first < azimuth; });
  return static_cast<std::size_t>(first - sorted_.begin());
}

}  // namespace scanfuse::triangulate
