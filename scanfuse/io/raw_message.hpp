#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "scanfuse/core/time.hpp"

namespace scanfuse::io {

/// A channel of a container of serialised messages (MCAP, ROS bags).
struct RawChannel {
  std::string topic;
  std::string type;        ///< "sensor_msgs/LaserScan" or "sensor_msgs/msg/LaserScan"
  std::string encoding;    ///< of the messages: "ros1", "cdr", "json", "protobuf", ...
  std::string definition;  ///< schema text, may be empty
};

/// One serialised message as it stands in its container.
struct RawMessage {
  std::uint32_t channel = 0;  ///< index into the container's channels
  Time log_time;
  std::vector<std::byte> bytes;
};

}  // namespace scanfuse::io
