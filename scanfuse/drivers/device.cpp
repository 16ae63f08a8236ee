#include "scanfuse/drivers/device.hpp"

#include <array>
#include <string>

#include "scanfuse/drivers/sick/lmd_driver.hpp"

namespace scanfuse::drivers {
namespace {

constexpr auto kDevices = std::to_array<Device>({
    {"sick", "SICK LMS1xx, LMS5xx, TiM5xx, TiM7xx, MRS1000: scan telegrams over TCP", Link::kTcp,
     2112, &sick::make_lmd_driver, &sick::make_lmd_simulator},
});

}  // namespace

std::span<const Device> devices() { return kDevices; }

Result<const Device*> find_device(std::string_view scheme) {
  std::string known;
  for (const Device& device : kDevices) {
    if (device.scheme == scheme) return &device;
    known += (known.empty() ? "" : ", ") + std::string(device.scheme);
  }
  return fail(Error::Code::kNotFound, "no device '{}'; known are {}", scheme, known);
}

}  // namespace scanfuse::drivers
