#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "scanfuse/core/result.hpp"
#include "scanfuse/drivers/driver.hpp"
#include "scanfuse/drivers/stream.hpp"

namespace scanfuse::drivers::ibeo {

inline constexpr std::uint16_t kScanData = 0x2202;

/// The head of every message [IbeoLux2010]: big endian, behind the magic word AFFEC0C2.
struct LuxHead {
  std::uint32_t previous_size = 0;
  std::uint32_t size = 0;  ///< of what follows the head
  std::uint8_t device = 0;
  std::uint16_t type = 0;
  std::uint64_t ntp = 0;  ///< when it was sent, as seconds since 1900 in 2^-32
};
inline constexpr std::size_t kLuxHeadBytes = 24;

/// One echo of a scan.
struct LuxPoint {
  std::uint8_t layer = 0;  ///< 0 is the lowest
  std::uint8_t echo = 0;
  std::uint8_t flags = 0;  ///< 1: transparent, 2: clutter, 4: ground, 8: dirt
  std::int16_t angle = 0;  ///< ticks, counter-clockwise from straight ahead
  std::uint16_t range_cm = 0;
  std::uint16_t width_cm = 0;  ///< of the echo's pulse
};

/// Scan data 0x2202: little endian.
struct LuxScan {
  std::uint16_t number = 0;
  std::uint16_t status = 0;
  std::uint16_t sync_offset = 0;
  std::uint64_t start_ntp = 0, end_ntp = 0;
  std::uint16_t ticks_per_turn = 11520;
  std::int16_t start_angle = 0, end_angle = 0;  ///< ticks; the scan runs from start to end
  std::int16_t yaw = 0, pitch = 0, roll = 0;    ///< ticks, of the mounting that the device knows
  std::int16_t x_cm = 0, y_cm = 0, z_cm = 0;
  std::uint16_t flags = 0;
  std::vector<LuxPoint> points;
};

[[nodiscard]] Cut cut_lux(ByteView bytes);
[[nodiscard]] LuxHead parse_lux_head(ByteView message);
/// Of the message's body.
[[nodiscard]] Result<LuxScan> parse_lux_scan(ByteView body);
[[nodiscard]] Bytes encode_lux_scan(const LuxScan& scan, std::uint64_t sent_ntp);

/// ibeo LUX over TCP, port 12002 (also LD-MRS): four layers 0.8 degrees apart, up to three echoes.
/// Echoes that the device marks as clutter or dirt are left out. The mounting that the device may
/// have been told is not applied.
[[nodiscard]] std::unique_ptr<Driver> make_lux_driver(const DriverOptions& options);
[[nodiscard]] std::unique_ptr<DeviceSimulator> make_lux_simulator();

}  // namespace scanfuse::drivers::ibeo
