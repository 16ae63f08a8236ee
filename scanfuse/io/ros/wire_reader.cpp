#include "scanfuse/io/ros/wire_reader.hpp"

#include <algorithm>

namespace scanfuse::io::ros {

namespace {

constexpr bool kHostIsLittle = std::endian::native == std::endian::little;

}  // namespace

Result<WireReader> WireReader::open(std::string_view encoding, std::span<const std::byte> bytes) {
  WireReader reader;
  reader.bytes_ = bytes;
  reader.swap_ = !kHostIsLittle;
  if (encoding == "ros1") return reader;
  if (encoding != "cdr") {
    return fail(Error::Code::kUnsupported, "message encoding '{}' is neither ros1 nor cdr",
                encoding);
  }
  if (bytes.size() < 4) {
    return fail(Error::Code::kMalformed, "byte 0: {} bytes hold no CDR encapsulation header",
                bytes.size());
  }
  // Byte 1 of the header: 0, 1 plain XCDR1; 6, 7 plain XCDR2; odd is little endian.
  const int kind = std::to_integer<int>(bytes[1]);
  if (std::to_integer<int>(bytes[0]) != 0 || !(kind <= 1 || kind == 6 || kind == 7)) {
    return fail(Error::Code::kUnsupported,
                "byte 0: CDR encapsulation {:#04x}{:02x} is not plain CDR",
                std::to_integer<int>(bytes[0]), kind);
  }
  reader.ros1_ = false;
  reader.swap_ = (kind % 2 == 1) != kHostIsLittle;
  reader.max_alignment_ = kind <= 1 ? 8 : 4;
  reader.offset_ = reader.origin_ = 4;
  return reader;
}

void WireReader::align(std::size_t size) {
  if (ros1_) return;
  const std::size_t step = std::min(size, max_alignment_);
  const std::size_t past = (offset_ - origin_) % step;
  if (past != 0 && need(step - past)) offset_ += step - past;
}

bool WireReader::need(std::size_t count) {
  if (!ok()) return false;
  if (count <= bytes_.size() - offset_) return true;
  refuse(fmt::format("{} bytes needed, {} left", count, bytes_.size() - offset_));
  return false;
}

void WireReader::refuse(std::string_view why) {
  if (ok()) problem_ = fmt::format("byte {}: {}", offset_, why);
}

std::string WireReader::read_string() {
  const auto length = read<std::uint32_t>();
  auto bytes = read_bytes(length);
  if (!ros1_ && !bytes.empty() && bytes.back() == std::byte{0}) {
    bytes = bytes.first(bytes.size() - 1);  // CDR counts the closing zero
  }
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

Time WireReader::read_time() {
  // ROS 1 has unsigned seconds, ROS 2 signed ones.
  const auto raw = read<std::uint32_t>();
  const std::int64_t seconds =
      ros1_ ? static_cast<std::int64_t>(raw) : static_cast<std::int32_t>(raw);
  const auto nanos = read<std::uint32_t>();
  return time_from_nanos(seconds * 1'000'000'000 + nanos);
}

std::uint32_t WireReader::read_count(std::size_t element_bytes) {
  const auto count = read<std::uint32_t>();
  if (!ok()) return 0;
  if (element_bytes > 0 && count > (bytes_.size() - offset_) / element_bytes) {
    refuse(fmt::format("{} elements do not fit into the {} bytes left", count,
                       bytes_.size() - offset_));
    return 0;
  }
  return count;
}

std::span<const std::byte> WireReader::read_bytes(std::size_t count) {
  if (!need(count)) return {};
  const auto piece = bytes_.subspan(offset_, count);
  offset_ += count;
  return piece;
}

Result<void> WireReader::finish() {
  // A CDR payload may be padded to a multiple of its largest alignment.
  const std::size_t spare = ros1_ ? 0 : 7;
  if (ok() && bytes_.size() - offset_ > spare) {
    refuse(fmt::format("{} bytes left over", bytes_.size() - offset_));
  }
  if (!ok()) return fail(Error::Code::kMalformed, "{}", problem_);
  return {};
}

}  // namespace scanfuse::io::ros
