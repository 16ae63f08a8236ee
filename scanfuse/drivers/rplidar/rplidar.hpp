#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>

#include "scanfuse/core/result.hpp"
#include "scanfuse/drivers/driver.hpp"
#include "scanfuse/drivers/stream.hpp"

namespace scanfuse::drivers::rplidar {

/// How data come after a request [Rplidar2016]: none, one node of 5 bytes a sample, or capsules of
/// 32 samples in 84 bytes.
enum class Mode { kNone, kStandard, kExpress };

/// One sample of the standard scan.
struct Node {
  bool starts_turn = false;
  std::uint8_t quality = 0;
  std::uint16_t angle_q6 = 0;  ///< clockwise, 1/64 degree
  std::uint16_t range_q2 = 0;  ///< 1/4 mm; 0: no echo
};
inline constexpr std::size_t kNodeBytes = 5;
[[nodiscard]] std::optional<Node> parse_node(ByteView bytes);
[[nodiscard]] Bytes encode_node(const Node& node);

/// 32 samples of the express scan. Sample k (from 0) is at start + (k + 1) / 32 of the way to the
/// next capsule's start, less its own correction.
struct Capsule {
  bool restarted = false;      ///< the first after the scan began anew
  std::uint16_t start_q6 = 0;  ///< clockwise, 1/64 degree
  std::array<std::uint16_t, 32> ranges_mm{};
  std::array<std::int8_t, 32> corrections_q3{};  ///< 1/8 degree
};
inline constexpr std::size_t kCapsuleBytes = 84;
/// An error for a wrong checksum or missing marks.
[[nodiscard]] Result<Capsule> parse_capsule(ByteView bytes);
[[nodiscard]] Bytes encode_capsule(const Capsule& capsule);

/// The seven bytes that announce data: of which kind and how long they are.
inline constexpr std::size_t kDescriptorBytes = 7;
[[nodiscard]] bool is_descriptor(ByteView bytes);
[[nodiscard]] Mode mode_of_descriptor(ByteView bytes);
[[nodiscard]] Bytes descriptor(Mode mode);

/// Cuts what comes after a scan request. Nodes have no checksum: after garbage only eight in a row
/// that look like nodes are believed.
class RplidarCutter {
 public:
  [[nodiscard]] Cut operator()(ByteView bytes);
  void set(Mode mode) { mode_ = mode; }
  [[nodiscard]] Mode mode() const { return mode_; }

 private:
  [[nodiscard]] Cut cut_nodes(ByteView bytes);
  Mode mode_ = Mode::kNone;
  bool in_step_ = false;
};

/// RPLidar A1, A2, A3 over a serial line. The device has no clock: stamps are told by receptions.
/// A scan is a turn. `make_express_driver` asks for the express scan.
[[nodiscard]] std::unique_ptr<Driver> make_rplidar_driver(const DriverOptions& options);
[[nodiscard]] std::unique_ptr<Driver> make_express_driver(const DriverOptions& options);
[[nodiscard]] std::unique_ptr<DeviceSimulator> make_rplidar_simulator();

}  // namespace scanfuse::drivers::rplidar
