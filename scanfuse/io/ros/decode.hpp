#pragma once

#include <cstddef>
#include <span>
#include <string_view>

#include "scanfuse/core/diagnostics.hpp"
#include "scanfuse/core/result.hpp"
#include "scanfuse/io/raw_message.hpp"
#include "scanfuse/io/recording.hpp"

namespace scanfuse::io::ros {

/// The message types that scanfuse understands, by their meaning.
enum class MessageKind {
  kUnknown,
  kLaserScan,           ///< sensor_msgs/LaserScan
  kMultiEchoLaserScan,  ///< sensor_msgs/MultiEchoLaserScan
  kPointCloud2,         ///< sensor_msgs/PointCloud2
  kOdometry,            ///< nav_msgs/Odometry
  kPose,                ///< geometry_msgs/PoseStamped
  kPoseWithCovariance,  ///< geometry_msgs/PoseWithCovarianceStamped
  kTransform,           ///< geometry_msgs/TransformStamped
  kTransforms,          ///< tf2_msgs/TFMessage, tf/tfMessage
  kImu,                 ///< sensor_msgs/Imu
};

/// By type name, ROS 1 ("sensor_msgs/LaserScan") or ROS 2 ("sensor_msgs/msg/LaserScan"), and
/// encoding ("ros1" or "cdr").
[[nodiscard]] MessageKind kind_of(std::string_view type, std::string_view encoding);
[[nodiscard]] bool is_scan(MessageKind kind);

struct DecodedMessage {
  decltype(Event::payload) payload;
  Diagnostics diagnostics;  ///< odd parts of this message
};

/// Decodes one message of a known kind. Stamps are those of the message's header.
///
/// LaserScan and MultiEchoLaserScan: a range r is a return if it is finite, r > 0 and
/// range_min <= r < range_max; everything else (NaN, infinities, 0, range_max itself and codes
/// beyond it) means "no echo". Limits that make no interval (range_max <= range_min, NaN) are
/// ignored. Columns count by increasing bearing whichever way the scanner turns; beam i of the
/// message was fired i * time_increment after the stamp.
///
/// PointCloud2: any layout, datatype and byte order. `x`, `y`, `z` are required, the rest is found
/// by name: intensity | i | reflectivity; ring | layer | channel (layer; without it the row of an
/// organised cloud of at most 128 rows); beam; echo | return; t | time | timestamp | time_offset |
/// offset_time | time_stamp. Times of integer type are nanoseconds, of floating type seconds (above
/// 1e12: nanoseconds). They count from the header's stamp if the largest is within 10 s of 0, else
/// from 1970 if it is within 10 s of the stamp; else they are left out, and that is noted. Points
/// that are not finite, lie in the origin or beyond 1000 km are "no echo".
///
/// A pose with a zero quaternion is taken as unrotated, and noted. Poses that are not finite are
/// errors; within a TFMessage the one transform is skipped and counted as damage.
///
/// Errors name type, topic and byte offset.
[[nodiscard]] Result<DecodedMessage> decode_message(const RawChannel& channel,
                                                    std::span<const std::byte> bytes);

}  // namespace scanfuse::io::ros
