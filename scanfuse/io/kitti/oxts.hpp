#pragma once

#include <string_view>
#include <vector>

#include "scanfuse/core/diagnostics.hpp"
#include "scanfuse/core/result.hpp"
#include "scanfuse/types/ego.hpp"

namespace scanfuse::io {

/// One packet of KITTI's GPS/IMU: 30 numbers, of which these are used [Geiger2013].
struct OxtsPacket {
  double latitude_rad = 0;
  double longitude_rad = 0;
  double altitude_m = 0;
  double roll_rad = 0;
  double pitch_rad = 0;
  double yaw_rad = 0;  ///< counter-clockwise from east
  double forward_m_per_s = 0;
  double yaw_rate_rad_per_s = 0;  ///< about the upward axis
};

/// Reads one line of an oxts file (degrees of latitude and longitude there).
[[nodiscard]] Result<OxtsPacket> parse_oxts(std::string_view line);

/// Places packets in a plane: Mercator, scaled by the cosine of the first packet's latitude, so
/// that lengths near it are right. The world has its origin at the first packet; x east, y north, z
/// up.
///   x = s R lon,  y = s R ln tan(pi/4 + lat/2),  s = cos(lat_0),  R = 6378137 m
class OxtsProjection {
 public:
  [[nodiscard]] Pose3 world_from_imu(const OxtsPacket& packet);

 private:
  [[nodiscard]] Eigen::Vector3d place(const OxtsPacket& packet) const;
  bool started_ = false;
  double scale_ = 1;
  Eigen::Vector3d origin_m_ = Eigen::Vector3d::Zero();
};

}  // namespace scanfuse::io
