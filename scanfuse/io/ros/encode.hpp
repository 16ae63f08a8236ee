#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "scanfuse/types/ego.hpp"
#include "scanfuse/types/scan.hpp"

namespace scanfuse::io::ros {

/// One message as ROS 2 writes it, ready for an MCAP or rosbag2 channel.
struct EncodedMessage {
  std::string type;              ///< "sensor_msgs/msg/LaserScan"
  std::string definition;        ///< schema text, encoding "ros2msg"
  std::vector<std::byte> bytes;  ///< little-endian CDR with its encapsulation header
};

/// A scan as LaserScan where nothing is lost by it (`fits_laser_scan`), else as PointCloud2 with
/// the fields x, y, z, intensity (float32, metres), t (float32, seconds after the stamp), beam
/// (int32), layer (int16), echo (uint8). A PointCloud2 cannot carry the beam pattern.
[[nodiscard]] EncodedMessage encode_cdr(const Scan& scan);

/// Whether LaserScan can carry the scan: it has a beam pattern of one layer, at most one return a
/// beam, each at its beam's bearing in the plane (to 1e-4 rad), within the pattern's range limits,
/// and times that grow evenly with the beam.
[[nodiscard]] bool fits_laser_scan(const Scan& scan);

/// nav_msgs/msg/Odometry; unknown speeds are written as NaN (0 would claim rest),
/// covariances as 0 (unknown).
[[nodiscard]] EncodedMessage encode_cdr(const PoseSample& pose);

/// tf2_msgs/msg/TFMessage. Static edges belong on the topic /tf_static.
[[nodiscard]] EncodedMessage encode_cdr(std::span<const TransformSample> transforms);

/// sensor_msgs/msg/Imu; without an orientation its covariance starts with -1, as ROS defines.
[[nodiscard]] EncodedMessage encode_cdr(const ImuSample& imu);

}  // namespace scanfuse::io::ros
