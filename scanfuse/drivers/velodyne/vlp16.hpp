#pragma once

#include <array>
#include <cstdint>
#include <memory>

#include "scanfuse/core/result.hpp"
#include "scanfuse/drivers/driver.hpp"

namespace scanfuse::drivers::velodyne {

inline constexpr int kChannels = 16;
inline constexpr double kFiringUs = 55.296;  ///< from one firing of all channels to the next
inline constexpr double kChannelUs = 2.304;  ///< from channel to channel

struct Vlp16Echo {
  std::uint16_t range_2mm = 0;  ///< 0: no echo
  std::uint8_t reflectivity = 0;
};

/// Two firings of all channels.
struct Vlp16Block {
  std::uint16_t azimuth = 0;  ///< of the first, hundredths of a degree, clockwise from above
  std::array<Vlp16Echo, std::size_t{2} * kChannels> echoes;
};

enum class ReturnMode : std::uint8_t { kStrongest = 0x37, kLast = 0x38, kDual = 0x39 };

/// A data packet [Velodyne2018, section 9]: 1206 bytes.
struct Vlp16Packet {
  std::array<Vlp16Block, 12> blocks;
  std::uint32_t time_us = 0;  ///< of the first firing, since the full hour
  ReturnMode mode = ReturnMode::kStrongest;
  std::uint8_t product = 0x22;
};
inline constexpr std::size_t kVlp16PacketBytes = 1206;

[[nodiscard]] Result<Vlp16Packet> parse_vlp16(ByteView datagram);
[[nodiscard]] Bytes encode_vlp16(const Vlp16Packet& packet);
/// Of a channel, in the order of firing.
[[nodiscard]] int elevation_deg(int channel);
/// 0 is the lowest.
[[nodiscard]] inline int layer_of(int channel) { return (elevation_deg(channel) + 15) / 2; }

/// Velodyne VLP-16 over UDP, port 2368. Straight ahead is azimuth 0, as most mount it; a scan is a
/// turn from behind to behind. That channels sit a few millimetres above each other is left out.
[[nodiscard]] std::unique_ptr<Driver> make_vlp16_driver(const DriverOptions& options);
[[nodiscard]] std::unique_ptr<DeviceSimulator> make_vlp16_simulator();

}  // namespace scanfuse::drivers::velodyne
