#pragma once

#include <span>
#include <vector>

#include "scanfuse/core/random.hpp"
#include "scanfuse/triangulate/line_of_sight.hpp"

namespace scanfuse::triangulate::testing {

inline PassiveSensor sensor_at(const Eigen::Vector3d& place_m, double sigma_rad = 0.005) {
  PassiveSensor sensor;
  sensor.name = "s";
  sensor.world_from_sensor.translation_m = place_m;
  sensor.sigma_azimuth_rad = sigma_rad;
  sensor.sigma_elevation_rad = sigma_rad;
  return sensor;
}

/// The sensors of [Lu2015, table 1], moved by `origin_m`.
inline PassiveScene scene_of_three(const Eigen::Vector3d& origin_m = Eigen::Vector3d::Zero(),
                                   double sigma_rad = 0.005) {
  PassiveScene scene;
  for (const Eigen::Vector3d& p :
       {Eigen::Vector3d(30e3, 0, 100), Eigen::Vector3d(0, 30e3, 100), Eigen::Vector3d(0, 0, 0)}) {
    scene.sensors.push_back(sensor_at(origin_m + p, sigma_rad));
    scene.sensors.back().name += std::to_string(scene.sensors.size());
  }
  return scene;
}

/// What the sensors tell of one point, with noise in units of each sensor's sigma.
inline std::vector<Bearing> bearings_to(const PassiveScene& scene, const Eigen::Vector3d& point_m,
                                        double noise = 0, std::uint64_t seed = 1) {
  RandomStream random(seed);
  std::vector<Bearing> bearings;
  for (std::size_t s = 0; s < scene.sensors.size(); ++s) {
    const PassiveSensor& sensor = scene.sensors[s];
    const Direction d = direction_to(sensor, point_m);
    Bearing b;
    b.sensor = static_cast<std::int32_t>(s);
    b.azimuth_rad = wrap_pi(d.azimuth_rad + noise * sensor.sigma_azimuth_rad * random.normal());
    b.elevation_rad =
        d.elevation_rad + noise * sensor.sigma_elevation_rad.value_or(0) * random.normal();
    bearings.push_back(b);
  }
  return bearings;
}

inline std::vector<LineOfSight> lines_of(const PassiveScene& scene,
                                         std::span<const Bearing> bearings) {
  std::vector<LineOfSight> lines;
  lines.reserve(bearings.size());
  for (const Bearing& b : bearings) {
    lines.push_back(line_of_sight(scene.sensors[static_cast<std::size_t>(b.sensor)], b));
  }
  return lines;
}

}  // namespace scanfuse::triangulate::testing
