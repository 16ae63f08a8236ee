#include "scanfuse/drivers/rplidar/rplidar.hpp"

#include <algorithm>

namespace scanfuse::drivers::rplidar {
namespace {

constexpr std::byte kSync{0xA5}, kSync2{0x5A};
constexpr int kStandardType = 0x81, kExpressType = 0x82;
constexpr int kNodesInARow = 8;

int u8(ByteView bytes, std::size_t at) { return std::to_integer<int>(bytes[at]); }
std::byte low(int value) { return static_cast<std::byte>(value & 0xFF); }

std::uint16_t u16(ByteView bytes, std::size_t at) {
  return static_cast<std::uint16_t>(u8(bytes, at) | u8(bytes, at + 1) << 8);
}

int checksum_of(ByteView capsule) {
  int sum = 0;
  for (const std::byte b : capsule.subspan(2)) sum ^= std::to_integer<int>(b);
  return sum;
}

/// Six bits with a sign.
std::int8_t signed6(int bits) { return static_cast<std::int8_t>(bits >= 32 ? bits - 64 : bits); }

}  // namespace

std::optional<Node> parse_node(ByteView bytes) {
  if (bytes.size() < kNodeBytes) return std::nullopt;
  const int first = u8(bytes, 0);
  const bool start = (first & 1) != 0, not_start = (first & 2) != 0;
  if (start == not_start || (u8(bytes, 1) & 1) == 0) return std::nullopt;
  return Node{start, static_cast<std::uint8_t>(first >> 2),
              static_cast<std::uint16_t>(u16(bytes, 1) >> 1), u16(bytes, 3)};
}

Bytes encode_node(const Node& node) {
  const int angle = node.angle_q6 << 1 | 1;
  return {low(node.quality << 2 | (node.starts_turn ? 1 : 2)), low(angle), low(angle >> 8),
          low(node.range_q2), low(node.range_q2 >> 8)};
}

Result<Capsule> parse_capsule(ByteView bytes) {
  if (bytes.size() < kCapsuleBytes || u8(bytes, 0) >> 4 != 0xA || u8(bytes, 1) >> 4 != 0x5) {
    return fail(Error::Code::kMalformed, "a capsule without its marks");
  }
  bytes = bytes.first(kCapsuleBytes);
  if (checksum_of(bytes) != ((u8(bytes, 0) & 15) | (u8(bytes, 1) & 15) << 4)) {
    return fail(Error::Code::kMalformed, "a capsule with a wrong checksum");
  }
  Capsule capsule;
  capsule.restarted = (u16(bytes, 2) & 0x8000) != 0;
  capsule.start_q6 = u16(bytes, 2) & 0x7FFF;
  for (std::size_t cabin = 0; cabin < 16; ++cabin) {
    const std::size_t at = 4 + 5 * cabin;
    const int corrections = u8(bytes, at + 4);
    for (std::size_t half = 0; half < 2; ++half) {
      const std::uint16_t word = u16(bytes, at + 2 * half);
      const int low_bits = half == 0 ? corrections & 15 : corrections >> 4;
      capsule.ranges_mm[2 * cabin + half] = word >> 2;
      capsule.corrections_q3[2 * cabin + half] = signed6((word & 3) << 4 | low_bits);
    }
  }
  return capsule;
}

Bytes encode_capsule(const Capsule& capsule) {
  Bytes bytes(4);
  const int start = capsule.start_q6 | (capsule.restarted ? 0x8000 : 0);
  bytes[2] = low(start);
  bytes[3] = low(start >> 8);
  for (std::size_t cabin = 0; cabin < 16; ++cabin) {
    int corrections = 0;
    for (std::size_t half = 0; half < 2; ++half) {
      const int correction = capsule.corrections_q3[2 * cabin + half] & 0x3F;
      const int word = capsule.ranges_mm[2 * cabin + half] << 2 | correction >> 4;
      bytes.push_back(low(word));
      bytes.push_back(low(word >> 8));
      corrections |= (correction & 15) << (4 * half);
    }
    bytes.push_back(low(corrections));
  }
  const int sum = checksum_of(bytes);
  bytes[0] = low(0xA0 | (sum & 15));
  bytes[1] = low(0x50 | sum >> 4);
  return bytes;
}

bool is_descriptor(ByteView bytes) {
  return bytes.size() >= kDescriptorBytes && bytes[0] == kSync && bytes[1] == kSync2;
}

Mode mode_of_descriptor(ByteView bytes) {
  const int size = u16(bytes, 2);
  if (u8(bytes, 6) == kStandardType && size == kNodeBytes) return Mode::kStandard;
  if (u8(bytes, 6) == kExpressType && size == kCapsuleBytes) return Mode::kExpress;
  return Mode::kNone;
}

Bytes descriptor(Mode mode) {
  const bool express = mode == Mode::kExpress;
  const auto size = static_cast<int>(express ? kCapsuleBytes : kNodeBytes);
  // The high bit of the length's last byte: many answers to one request.
  return {kSync,
          kSync2,
          low(size),
          low(0),
          low(0),
          low(0x40),
          low(express ? kExpressType : kStandardType)};
}

Cut RplidarCutter::operator()(ByteView bytes) {
  if (bytes[0] == kSync && (bytes.size() == 1 || bytes[1] == kSync2)) {
    in_step_ = true;
    return bytes.size() < kDescriptorBytes ? Cut{} : Cut{0, kDescriptorBytes};
  }
  if (mode_ == Mode::kNone) {
    const std::size_t garbage = until(bytes, kSync);
    return garbage > 0 ? Cut{garbage, 0} : Cut{1, 0};
  }
  if (mode_ == Mode::kStandard) return cut_nodes(bytes);
  if (u8(bytes, 0) >> 4 != 0xA || (bytes.size() > 1 && u8(bytes, 1) >> 4 != 0x5)) return {1, 0};
  if (bytes.size() < kCapsuleBytes) return {};
  return parse_capsule(bytes) ? Cut{0, kCapsuleBytes} : Cut{1, 0};
}

Cut RplidarCutter::cut_nodes(ByteView bytes) {
  const int wanted = in_step_ ? 1 : kNodesInARow;
  for (int i = 0; i < wanted; ++i) {
    const std::size_t at = static_cast<std::size_t>(i) * kNodeBytes;
    if (bytes.size() < at + kNodeBytes) return {};
    if (!parse_node(bytes.subspan(at))) {
      in_step_ = false;
      return {1, 0};
    }
  }
  in_step_ = true;
  return {0, kNodeBytes};
}

}  // namespace scanfuse::drivers::rplidar
