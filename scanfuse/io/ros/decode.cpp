#include "scanfuse/io/ros/decode.hpp"

#include <map>

#include "scanfuse/io/ros/message_decoders.hpp"

namespace scanfuse::io::ros {

namespace {

/// "sensor_msgs/msg/LaserScan" -> "sensor_msgs/LaserScan".
std::string short_type(std::string_view type) {
  std::string name(type);
  const auto middle = name.find("/msg/");
  if (middle != std::string::npos) name.erase(middle, 4);
  return name;
}

DecodedMessage decode_as(MessageKind kind, WireReader& reader) {
  switch (kind) {
    case MessageKind::kLaserScan:
      return decode_laser_scan(reader);
    case MessageKind::kMultiEchoLaserScan:
      return decode_multi_echo_laser_scan(reader);
    case MessageKind::kPointCloud2:
      return decode_point_cloud(reader);
    case MessageKind::kOdometry:
      return decode_odometry(reader);
    case MessageKind::kPose:
      return decode_pose(reader, false);
    case MessageKind::kPoseWithCovariance:
      return decode_pose(reader, true);
    case MessageKind::kTransform:
      return decode_transform(reader);
    case MessageKind::kTransforms:
      return decode_transforms(reader);
    case MessageKind::kImu:
      return decode_imu(reader);
    case MessageKind::kUnknown:
      break;
  }
  reader.refuse("unknown message type");
  return {};
}

/// What the bytes cannot tell but the topic does.
void name_after_topic(decltype(Event::payload)& payload, const std::string& topic) {
  if (auto* scan = std::get_if<Scan>(&payload)) scan->sensor = topic;
  if (auto* edges = std::get_if<std::vector<TransformSample>>(&payload)) {
    const bool is_static = topic.ends_with("tf_static");
    for (auto& edge : *edges) edge.is_static = is_static;
  }
}

}  // namespace

MessageKind kind_of(std::string_view type, std::string_view encoding) {
  static const std::map<std::string, MessageKind> kinds{
      {"sensor_msgs/LaserScan", MessageKind::kLaserScan},
      {"sensor_msgs/MultiEchoLaserScan", MessageKind::kMultiEchoLaserScan},
      {"sensor_msgs/PointCloud2", MessageKind::kPointCloud2},
      {"nav_msgs/Odometry", MessageKind::kOdometry},
      {"geometry_msgs/PoseStamped", MessageKind::kPose},
      {"geometry_msgs/PoseWithCovarianceStamped", MessageKind::kPoseWithCovariance},
      {"geometry_msgs/TransformStamped", MessageKind::kTransform},
      {"tf2_msgs/TFMessage", MessageKind::kTransforms},
      {"tf/tfMessage", MessageKind::kTransforms},
      {"sensor_msgs/Imu", MessageKind::kImu},
  };
  if (encoding != "ros1" && encoding != "cdr") return MessageKind::kUnknown;
  const auto found = kinds.find(short_type(type));
  return found == kinds.end() ? MessageKind::kUnknown : found->second;
}

bool is_scan(MessageKind kind) {
  return kind == MessageKind::kLaserScan || kind == MessageKind::kMultiEchoLaserScan ||
         kind == MessageKind::kPointCloud2;
}

Header read_header(WireReader& reader) {
  if (reader.ros1()) (void)reader.read<std::uint32_t>();  // seq
  const Time stamp = reader.read_time();
  return {stamp, reader.read_string()};
}

Result<DecodedMessage> decode_message(const RawChannel& channel, std::span<const std::byte> bytes) {
  const auto wrong = [&](const Error& error) {
    return fail(error.code, "{} on {}: {}", channel.type, channel.topic, error.message);
  };
  auto reader = WireReader::open(channel.encoding, bytes);
  if (!reader) return wrong(reader.error());
  auto decoded = decode_as(kind_of(channel.type, channel.encoding), *reader);
  const auto finished = reader->finish();
  if (!finished) return wrong(finished.error());
  name_after_topic(decoded.payload, channel.topic);
  return decoded;
}

}  // namespace scanfuse::io::ros
