#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <limits>
#include <vector>

#include "scanfuse/core/time.hpp"

namespace scanfuse {

/// One point of a virtual scan: the return that stands for its bearing.
struct PlanarPoint {
  float x_m = 0;
  float y_m = 0;
  float z_m = 0;
  float range_m = 0;      ///< in the plane
  float bearing_rad = 0;  ///< in [-pi, pi)
  float time_offset_s = 0;
  std::int32_t column = 0;   ///< bearing bin; neighbours differ by one
  std::uint32_t source = 0;  ///< index into Scan::returns
  std::uint8_t support = 1;  ///< layers that agree
  float z_low_m = 0;         ///< of their returns, the lowest and the highest
  float z_high_m = 0;
  float depth_m = 0;  ///< how far their ranges lie apart: a post stands upright, a person does not
};

/// A sweep flattened to the plane, sorted by bearing: what segmentation and shape work on.
/// Frame: the levelled sensor frame, origin at the sensor, x forward as the ego vehicle, z up.
struct VirtualScan {
  Time stamp;
  std::int64_t frame = 0;
  std::vector<PlanarPoint> points;  ///< increasing bearing_rad
  double step_rad = 0;              ///< between columns
  bool full_circle = false;         ///< the last column is a neighbour of the first
  double sigma_range_m = 0.03;      ///< range noise of the sensor
  /// Where the field of view ends, if it does: an object reaching there may go on outside.
  double view_from_rad = -std::numeric_limits<double>::infinity();
  double view_to_rad = std::numeric_limits<double>::infinity();

  [[nodiscard]] Eigen::Vector2d position(std::uint32_t index) const {
    return {points[index].x_m, points[index].y_m};
  }
};

}  // namespace scanfuse
