#pragma once

#include <string>

namespace scanfuse::io::ros {

/// The "ros2msg" schema of a message type this library writes: its definition, then those it
/// builds on, set apart by lines of `=` and `MSG: package/Type`. `type` as in
/// "sensor_msgs/msg/LaserScan"; empty for types it does not know.
[[nodiscard]] std::string definition_of(const std::string& type);

}  // namespace scanfuse::io::ros
