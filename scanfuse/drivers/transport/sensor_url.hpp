#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "scanfuse/core/result.hpp"
#include "scanfuse/drivers/device.hpp"

namespace scanfuse::drivers {

/// Where a sensor is: "sick://192.168.0.1:2112?name=front", "vlp16://:2368" (on every address of
/// this machine), "rplidar:///dev/ttyUSB0?baud=115200".
struct SensorUrl {
  const Device* device = nullptr;
  std::string host;  ///< of the sensor (TCP), or the address of ours to listen at (UDP)
  int port = 0;
  std::string path;                          ///< of a serial device
  std::map<std::string, std::string> query;  ///< name, mount, baud, metadata

  /// The `name` of the query, else the scheme.
  [[nodiscard]] std::string name() const;
};

/// Errors say what is wrong and show the form. The host may be left out where that means something:
/// 127.0.0.1 for TCP, every address for UDP.
[[nodiscard]] Result<SensorUrl> parse_sensor_url(std::string_view text);

/// What a simulated device is served at: "sick:2112", "vlp16:127.0.0.1:2368", "rplidar:/tmp/lidar".
/// The host, where left out, is 127.0.0.1; the port the usual one.
[[nodiscard]] Result<SensorUrl> parse_serve_address(std::string_view text);

}  // namespace scanfuse::drivers
