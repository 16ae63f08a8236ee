#pragma once

#include <string>
#include <utility>

#include "scanfuse/io/ros/decode.hpp"
#include "scanfuse/io/ros/wire_reader.hpp"

namespace scanfuse::io::ros {

/// What every message of the ROS world starts with.
struct Header {
  Time stamp;
  std::string frame_id;
};
[[nodiscard]] Header read_header(WireReader& reader);

/// A scan or sample with the stamp and frame of the header that comes next.
template <class T>
[[nodiscard]] T read_stamped(WireReader& reader) {
  auto header = read_header(reader);
  T sample;
  sample.stamp = header.stamp;
  sample.frame_id = std::move(header.frame_id);
  return sample;
}

/// No lidar reaches this far; keeps squares of coordinates finite.
inline constexpr float kFarthestM = 1e6F;

/// One decoder for each kind of message; what they refuse stands in the reader's `finish`.
[[nodiscard]] DecodedMessage decode_laser_scan(WireReader& reader);
[[nodiscard]] DecodedMessage decode_multi_echo_laser_scan(WireReader& reader);
[[nodiscard]] DecodedMessage decode_point_cloud(WireReader& reader);
[[nodiscard]] DecodedMessage decode_odometry(WireReader& reader);
[[nodiscard]] DecodedMessage decode_pose(WireReader& reader, bool with_covariance);
[[nodiscard]] DecodedMessage decode_transform(WireReader& reader);
[[nodiscard]] DecodedMessage decode_transforms(WireReader& reader);
[[nodiscard]] DecodedMessage decode_imu(WireReader& reader);

}  // namespace scanfuse::io::ros
