#pragma once

#include <span>
#include <vector>

#include "scanfuse/triangulate/epipolar_index.hpp"

namespace scanfuse::triangulate {

/// One sensor's lines of a scan and where they stand in it.
struct LinesOfSensor {
  std::vector<LineOfSight> lines;
  std::vector<std::int32_t> places;  ///< in BearingScan::bearings
  AzimuthIndex by_azimuth;
  Eigen::Vector3d origin_m = Eigen::Vector3d::Zero();
  double widest_rad = 0;  ///< the largest sigma among them
};

/// `lines` in the order of the scan's bearings; one entry a sensor of the scene.
[[nodiscard]] std::vector<LinesOfSensor> lines_by_sensor(std::span<const LineOfSight> lines,
                                                         const PassiveScene& scene);

}  // namespace scanfuse::triangulate
