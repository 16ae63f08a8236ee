#include "scanfuse/triangulate/line_of_sight.hpp"

#include <algorithm>
#include <cmath>

namespace scanfuse::triangulate {
namespace {

constexpr double kNearest_m = 1e-6;

}  // namespace

double LineOfSight::log_spread() const {
  const double azimuth = std::log(2 * kPi) / 2 + std::log(sigma_left_rad);
  return tells_elevation() ? azimuth + std::log(2 * kPi) / 2 + std::log(sigma_up_rad) : azimuth;
}

LineOfSight line_of_sight(const PassiveSensor& sensor, const Bearing& bearing) {
  const bool tells_elevation = sensor.tells_elevation();
  const double elevation = tells_elevation ? bearing.elevation_rad : 0;
  const double ca = std::cos(bearing.azimuth_rad), sa = std::sin(bearing.azimuth_rad);
  const double ce = std::cos(elevation), se = std::sin(elevation);
  const auto& turn = sensor.world_from_sensor.rotation;
  LineOfSight line;
  line.origin_m = sensor.world_from_sensor.translation_m;
  line.direction = turn * Eigen::Vector3d(ca * ce, sa * ce, se);
  line.left = turn * Eigen::Vector3d(-sa, ca, 0);
  line.up = turn * Eigen::Vector3d(-ca * se, -sa * se, ce);
  line.sensor = bearing.sensor;
  line.elevation_rad = elevation;
  line.sigma_azimuth_rad = bearing.sigma_azimuth_rad.value_or(sensor.sigma_azimuth_rad);
  line.sigma_left_rad = line.sigma_azimuth_rad;
  if (tells_elevation) {
    line.sigma_up_rad = bearing.sigma_elevation_rad.value_or(*sensor.sigma_elevation_rad);
    // At the zenith the true elevation is off by its own sigma: azimuth moves the direction so far.
    line.sigma_left_rad *= std::max(std::abs(ce), std::min(line.sigma_up_rad, 1.0));
  }
  return line;
}

std::optional<Sight> sight(const LineOfSight& line, const Eigen::Vector3d& point_m) {
  const Eigen::Vector3d d = point_m - line.origin_m;
  const double left = line.left.dot(d), ahead = line.direction.dot(d);
  Sight seen;
  if (!line.tells_elevation()) {
    const double squared = left * left + ahead * ahead;
    if (!(squared > kNearest_m * kNearest_m) || ahead <= 0) return std::nullopt;
    seen.offset_rad.x() = std::atan2(left, ahead);
    seen.jacobian_rad_per_m.row(0) =
        ((ahead * line.left - left * line.direction) / squared).transpose();
    return seen;
  }
  const double range = d.norm();
  if (!(range > kNearest_m) || ahead <= 0) return std::nullopt;
  const Eigen::Vector3d u = d / range;
  seen.offset_rad = {line.left.dot(u), line.up.dot(u)};
  seen.jacobian_rad_per_m.row(0) = ((line.left - seen.offset_rad.x() * u) / range).transpose();
  seen.jacobian_rad_per_m.row(1) = ((line.up - seen.offset_rad.y() * u) / range).transpose();
  return seen;
}

Direction direction_to(const PassiveSensor& sensor, const Eigen::Vector3d& point_m) {
  constexpr double kSteepest = 1e9;
  const Eigen::Matrix3d sensor_from_world =
      sensor.world_from_sensor.rotation.conjugate().toRotationMatrix();
  const Eigen::Vector3d p = sensor_from_world * (point_m - sensor.world_from_sensor.translation_m);
  const double flat = std::max(std::hypot(p.x(), p.y()), 1 / kSteepest);
  const double squared = std::max(p.squaredNorm(), kNearest_m * kNearest_m);
  Direction direction{std::atan2(p.y(), p.x()), std::atan2(p.z(), std::hypot(p.x(), p.y())), {}};
  Eigen::Matrix<double, 2, 3> by_point;
  by_point << -p.y() / (flat * flat), p.x() / (flat * flat), 0,  //
      -p.x() * p.z() / (flat * squared), -p.y() * p.z() / (flat * squared), flat / squared;
  direction.jacobian_rad_per_m = by_point * sensor_from_world;
  return direction;
}

bool in_field_of_view(const PassiveSensor& sensor, const Eigen::Vector3d& point_m) {
  const Eigen::Vector3d p = sensor.world_from_sensor.inverse() * point_m;
  const double flat = std::hypot(p.x(), p.y());
  if (std::abs(std::atan2(p.y(), p.x())) > sensor.field_of_view_azimuth_rad / 2) return false;
  return !sensor.tells_elevation() ||
         std::abs(std::atan2(p.z(), flat)) <= sensor.field_of_view_elevation_rad / 2;
}

}  // namespace scanfuse::triangulate
