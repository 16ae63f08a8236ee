#pragma once

#include <cmath>

#include "scanfuse/io/text/numbers.hpp"
#include "scanfuse/types/cloud.hpp"

namespace scanfuse::io {

/// One point as its file gives it; what the file leaves out keeps its default.
struct RawCloudPoint {
  double x = 0;
  double y = 0;
  double z = 0;
  double intensity = std::numeric_limits<double>::quiet_NaN();
  double profile = -1;
  double beam = -1;
};

/// Adds a point whose coordinates can be places; false for others.
[[nodiscard]] inline bool take_cloud_point(const RawCloudPoint& raw, Cloud& cloud) {
  const Eigen::Vector3d place(raw.x, raw.y, raw.z);
  if (!(place.cwiseAbs().maxCoeff() <= kFarthestCoordinate_m) || !place.allFinite()) return false;
  const auto index = [](double value) {
    return value >= 0 && value < 1e9 ? static_cast<int>(value) : -1;
  };
  cloud.points.push_back({place, raw.intensity, index(raw.profile), index(raw.beam)});
  return true;
}

}  // namespace scanfuse::io
