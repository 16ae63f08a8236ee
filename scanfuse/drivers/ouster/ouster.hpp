#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "scanfuse/core/result.hpp"
#include "scanfuse/drivers/driver.hpp"

namespace scanfuse::drivers::ouster {

/// What the sensor tells of its beams, in its metadata [Ouster2022].
struct OusterBeams {
  std::vector<double> altitudes_deg;  ///< of each channel, the highest first
  std::vector<double> azimuths_deg;   ///< of each channel, clockwise from the encoder's
  int columns_per_turn = 1024;
  double origin_mm = 15.806;  ///< from the lidar's origin to where beams start
  /// Row by row: the frame of the lidar in that of the sensor, millimetres.
  std::array<double, 16> sensor_from_lidar{-1, 0, 0, 0, 0, -1, 0, 0, 0, 0, 1, 36.18, 0, 0, 0, 1};
};

/// Of metadata in JSON, old or new; errors say what is missing.
[[nodiscard]] Result<OusterBeams> parse_beams(std::string_view json);
/// Metadata as a sensor would tell them.
[[nodiscard]] std::string metadata_of(const OusterBeams& beams);
/// Channels spread evenly over 33.2 degrees, as the OS1's are.
[[nodiscard]] OusterBeams usual_beams(int channels);

struct OusterPixel {
  std::uint32_t range_mm = 0;  ///< 20 bits; 0: no echo
  std::uint16_t reflectivity = 0;
  std::uint16_t signal = 0, ambient = 0;
};

struct OusterColumn {
  std::uint64_t time_ns = 0;
  std::uint16_t number = 0;  ///< within the turn
  std::uint16_t frame = 0;   ///< counts turns
  std::uint32_t encoder = 0;
  bool valid = true;
  std::vector<OusterPixel> pixels;
};

inline constexpr int kColumnsPerPacket = 16;

/// A lidar packet of the profile LEGACY: 16 columns; its size tells how many channels there are.
[[nodiscard]] Result<std::vector<OusterColumn>> parse_packet(ByteView datagram);
[[nodiscard]] Bytes encode_packet(const std::vector<OusterColumn>& columns);

/// Ouster OS0, OS1, OS2 over UDP, port 7502, profile LEGACY. Without metadata the usual beams are
/// assumed, and that is noted. A scan is a turn, in the sensor's frame.
[[nodiscard]] std::unique_ptr<Driver> make_ouster_driver(const DriverOptions& options);
/// 16 channels 2 degrees apart, 1024 columns.
[[nodiscard]] std::unique_ptr<DeviceSimulator> make_ouster_simulator();
[[nodiscard]] OusterBeams simulated_beams();

}  // namespace scanfuse::drivers::ouster
