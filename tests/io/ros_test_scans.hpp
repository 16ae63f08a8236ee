#pragma once

#include <cmath>

#include "scanfuse/geometry/pose.hpp"
#include "scanfuse/types/scan.hpp"

namespace scanfuse::io::ros {

/// A 181-beam scanner with every seventh beam lost, 0.1 ms between beams.
inline Scan planar_scan() {
  Scan scan;
  scan.stamp = time_from_nanos(1'700'000'000'987'654'321);
  scan.frame_id = "laser";
  scan.beams = BeamPattern{radians(-90), radians(1), 181, 1, 0.1, 30};
  for (int beam = 0; beam < 181; ++beam) {
    if (beam % 7 == 3) continue;
    const double azimuth = radians(beam - 90), range = 2 + 0.1 * beam;
    Return point;
    point.x_m = static_cast<float>(range * std::cos(azimuth));
    point.y_m = static_cast<float>(range * std::sin(azimuth));
    point.intensity = static_cast<float>(beam);
    point.time_offset_s = static_cast<float>(1e-4 * beam);
    point.beam = beam;
    scan.returns.push_back(point);
  }
  return scan;
}

/// Four layers, second echoes, nothing that a LaserScan could carry.
inline Scan layered_scan() {
  Scan scan;
  scan.stamp = time_from_nanos(1'234'000'000'001);
  scan.frame_id = "lux";
  for (int i = 0; i < 40; ++i) {
    Return point;
    point.x_m = 5 + 0.25F * static_cast<float>(i);
    point.y_m = -3 + 0.5F * static_cast<float>(i % 5);
    point.z_m = 0.125F * static_cast<float>(i % 4);
    point.intensity = 0.5F * static_cast<float>(i);
    point.time_offset_s = 1e-3F * static_cast<float>(i);
    point.beam = i / 4;
    point.layer = static_cast<std::int16_t>(i % 4);
    point.echo = static_cast<std::uint8_t>(i % 3);
    scan.returns.push_back(point);
  }
  return scan;
}

inline Pose3 test_pose() {
  const Eigen::Quaterniond turn(Eigen::AngleAxisd(0.7, Eigen::Vector3d(1, 2, 3).normalized()));
  return {turn.normalized(), {1.5, -2.25, 0.125}};
}

}  // namespace scanfuse::io::ros
