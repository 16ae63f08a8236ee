#pragma once

#include <memory>
#include <span>
#include <string_view>

#include "scanfuse/core/result.hpp"
#include "scanfuse/drivers/driver.hpp"

namespace scanfuse::drivers {

enum class Link { kTcp, kUdp, kSerial };

/// A kind of device that scanfuse speaks to.
struct Device {
  std::string_view scheme;  ///< of its URL: "sick"
  std::string_view doc;
  Link link = Link::kTcp;
  int port = 0;  ///< its usual one; 0 for serial devices
  std::unique_ptr<Driver> (*make_driver)(const DriverOptions& options) = nullptr;
  std::unique_ptr<DeviceSimulator> (*make_simulator)() = nullptr;
};

[[nodiscard]] std::span<const Device> devices();
/// By scheme; an unknown one is an error that lists the known ones.
[[nodiscard]] Result<const Device*> find_device(std::string_view scheme);

}  // namespace scanfuse::drivers
