#pragma once

#include <Eigen/Core>

#include "scanfuse/types/virtual_scan.hpp"

namespace scanfuse::preprocess {

/// Motion of the ego vehicle in its own axes, at the ego origin; constant during a sweep.
struct EgoTwist {
  Eigen::Vector2d velocity_m_per_s = Eigen::Vector2d::Zero();
  double yaw_rate_rad_per_s = 0;

  [[nodiscard]] bool is_still() const {
    return velocity_m_per_s.isZero() && yaw_rate_rad_per_s == 0;
  }
};

/// Moves every point to where the sensor frame of the scan's stamp has it: the static world becomes
/// straight, objects keep their own motion. `sensor_m` is the sensor in the ego frame. Bearing and
/// range stay as fired, and so does the order. The turn's sine and cosine are taken to the third
/// order: 2e-5 m at 60 m for a turn of 0.05 rad during a sweep.
void deskew(VirtualScan& scan, const EgoTwist& twist, const Eigen::Vector2d& sensor_m);

}  // namespace scanfuse::preprocess
