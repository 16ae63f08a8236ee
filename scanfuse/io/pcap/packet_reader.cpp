#include "scanfuse/io/pcap/packet_reader.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>

#include "scanfuse/io/ros/wire_reader.hpp"

namespace scanfuse::io::pcap {
namespace {

constexpr std::uint32_t kMicroseconds = 0xA1B2C3D4;
constexpr std::uint32_t kNanoseconds = 0xA1B23C4D;
constexpr std::uint32_t kSection = 0x0A0D0D0A;
constexpr std::uint32_t kByteOrder = 0x1A2B3C4D;
constexpr std::uint32_t kInterface = 1;
constexpr std::uint32_t kObsoletePacket = 2;
constexpr std::uint32_t kSimplePacket = 3;
constexpr std::uint32_t kEnhancedPacket = 6;
constexpr std::uint32_t kLongestBlock = 1 << 24;
constexpr std::uint64_t kSecondsLimit = 4'000'000'000;  // 2096: sums of times stay in range

std::uint32_t first_word(std::string_view bytes) {
  std::uint32_t word = 0;
  if (bytes.size() >= sizeof word) std::memcpy(&word, bytes.data(), sizeof word);
  return word;
}

std::uint32_t reversed(std::uint32_t word) {
  return word >> 24 | (word >> 8 & 0xFF00) | (word << 8 & 0xFF0000) | word << 24;
}

bool is_classic(std::uint32_t word) { return word == kMicroseconds || word == kNanoseconds; }

Time time_of(std::uint64_t ticks, std::uint64_t per_second, std::int64_t offset_s) {
  const auto seconds = static_cast<std::int64_t>(std::min(ticks / per_second, kSecondsLimit));
  const auto offset = std::clamp<std::int64_t>(offset_s, -seconds, 1'000'000'000);
  const double fraction = static_cast<double>(ticks % per_second) / static_cast<double>(per_second);
  return Time{std::chrono::seconds(std::min<std::int64_t>(seconds + offset, kSecondsLimit))} +
         Duration{std::llround(fraction * 1e9)};
}

}  // namespace

bool is_capture(std::string_view first_bytes) {
  const std::uint32_t word = first_word(first_bytes);
  return word == kSection || is_classic(word) || is_classic(reversed(word));
}

std::uint32_t PacketReader::u32(std::span<const std::byte> bytes, std::size_t at) const {
  return ros::WireReader::load<std::uint32_t>(bytes.data() + at, swapped_);
}

std::uint16_t PacketReader::u16(std::span<const std::byte> bytes, std::size_t at) const {
  return ros::WireReader::load<std::uint16_t>(bytes.data() + at, swapped_);
}

Result<PacketReader> PacketReader::open(const std::filesystem::path& path) {
  auto source = open_bytes(path);
  if (!source) return tl::unexpected(source.error());
  return open(path.string(), std::move(*source));
}

Result<PacketReader> PacketReader::open(std::string name, std::unique_ptr<ByteSource> source) {
  PacketReader reader(std::move(name), std::move(source));
  if (auto done = reader.read_head(); !done) return tl::unexpected(done.error());
  return reader;
}

Result<void> PacketReader::read_head() {
  const auto magic = read(4);
  if (magic.empty()) return fail(Error::Code::kMalformed, "{}: is empty or cut off", name_);
  const std::uint32_t word = u32(magic, 0);
  if (word == kSection) {
    ng_ = true;
    if (start_section()) return {};
    return fail(Error::Code::kMalformed, "{}: its first section makes no sense", name_);
  }
  swapped_ = !is_classic(word);
  const std::uint32_t magic_word = swapped_ ? reversed(word) : word;
  const auto head = is_classic(magic_word) ? read(20) : std::span<const std::byte>{};
  if (head.empty()) return fail(Error::Code::kMalformed, "{}: is no capture of packets", name_);
  nanoseconds_ = magic_word == kNanoseconds;
  interfaces_.push_back(
      {u32(head, 16) & 0xFFFF, nanoseconds_ ? 1'000'000'000ULL : 1'000'000ULL, 0});
  return {};
}

std::span<const std::byte> PacketReader::read(std::size_t count) {
  buffer_.resize(count);
  std::size_t got = 0;
  while (got < count) {
    const auto more = source_->read({reinterpret_cast<char*>(buffer_.data()) + got, count - got});
    if (!more) damaged(more.error().message);
    if (!more || *more == 0) break;
    got += *more;
  }
  if (got > 0 && got < count) damaged("cut off");
  offset_ += got;
  return got == count ? std::span<const std::byte>(buffer_) : std::span<const std::byte>{};
}

void PacketReader::damaged(std::string_view what) {
  if (!ended_) {
    diagnostics_.damage("capture cut off or damaged",
                        fmt::format("{}: byte {}: {}", name_, offset_, what));
  }
  ended_ = true;
}

std::optional<Packet> PacketReader::next() {
  if (!ng_) return ended_ ? std::nullopt : next_classic();
  std::optional<Packet> found;
  while (!found && !ended_ && next_block(found)) {
  }
  return found;
}

std::optional<Packet> PacketReader::next_classic() {
  const auto head = read(16);
  if (head.empty()) return std::nullopt;
  const std::uint32_t size = u32(head, 8);
  const auto per_second = interfaces_[0].ticks_per_second;
  Packet packet;
  packet.link_type = interfaces_[0].link_type;
  packet.time = time_of(u32(head, 0) * per_second + u32(head, 4), per_second, 0);
  if (size > kLongestBlock) {
    damaged(fmt::format("a packet of {} bytes", size));
    return std::nullopt;
  }
  const auto body = size > 0 ? read(size) : std::span<const std::byte>{};
  if (body.size() != size) return std::nullopt;
  packet.bytes.assign(body.begin(), body.end());
  return packet;
}

bool PacketReader::next_block(std::optional<Packet>& found) {
  const auto type_bytes = read(4);
  if (type_bytes.empty()) return false;
  const std::uint32_t type = u32(type_bytes, 0);
  if (type == kSection) return start_section();
  const auto size_bytes = read(4);
  if (size_bytes.empty()) return false;
  const std::uint32_t size = u32(size_bytes, 0);
  if (size < 12 || size > kLongestBlock || size % 4 != 0) {
    damaged(fmt::format("a block of {} bytes", size));
    return false;
  }
  const auto rest = read(size - 8);
  if (rest.empty()) return false;
  const auto body = rest.first(rest.size() - 4);
  if (type == kInterface) add_interface(body);
  found = packet_of(type, body);
  return true;
}

/// Behind the type of a section's block: its length, the byte order, and what is passed over.
bool PacketReader::start_section() {
  const auto head = read(8);
  if (head.empty()) return false;
  swapped_ = false;
  swapped_ = u32(head, 4) != kByteOrder;
  const std::uint32_t order = u32(head, 4), size = u32(head, 0);
  interfaces_.clear();
  if (order != kByteOrder || size < 28 || size > kLongestBlock || size % 4 != 0) {
    damaged("a section that makes no sense");
    return false;
  }
  return !read(size - 12).empty();
}

void PacketReader::add_interface(std::span<const std::byte> body) {
  Interface interface;
  if (body.size() >= 8) interface.link_type = u16(body, 0);
  for (std::size_t at = 8; at + 4 <= body.size();) {
    const std::uint16_t code = u16(body, at), size = u16(body, at + 2);
    if (code == 0 || at + 4 + size > body.size()) break;
    const auto value = body.subspan(at + 4, size);
    if (code == 9 && size == 1) {  // how long a tick is: a power of 10, or of 2 with the high bit
      const auto power = static_cast<unsigned>(value[0]);
      const double ticks = (power & 0x80) != 0 ? std::exp2(power & 0x7F) : std::pow(10.0, power);
      if (ticks <= 1e15) interface.ticks_per_second = static_cast<std::uint64_t>(ticks);
    } else if (code == 14 && size == 8) {
      interface.offset_s = ros::WireReader::load<std::int64_t>(value.data(), swapped_);
    }
    at += 4 + static_cast<std::size_t>((size + 3) / 4 * 4);
  }
  interfaces_.push_back(interface);
}

std::optional<Packet> PacketReader::packet_of(std::uint32_t type, std::span<const std::byte> body) {
  const bool enhanced = type == kEnhancedPacket || type == kObsoletePacket;
  const std::size_t head = enhanced ? 20 : 4;
  if ((!enhanced && type != kSimplePacket) || body.size() < head) return std::nullopt;
  const std::size_t number = type == kEnhancedPacket ? u32(body, 0) : enhanced ? u16(body, 0) : 0;
  const std::uint32_t size = u32(body, enhanced ? 12 : 0);
  if (number >= interfaces_.size() || (enhanced && size > body.size() - head)) {
    diagnostics_.damage("packet without an interface, or longer than its block",
                        fmt::format("{}: byte {}", name_, offset_));
    return std::nullopt;
  }
  const Interface& interface = interfaces_[number];
  Packet packet;
  packet.link_type = interface.link_type;
  if (enhanced) {
    const std::uint64_t ticks = std::uint64_t{u32(body, 4)} << 32 | u32(body, 8);
    packet.time = time_of(ticks, interface.ticks_per_second, interface.offset_s);
  }
  const auto bytes = body.subspan(head, std::min<std::size_t>(size, body.size() - head));
  packet.bytes.assign(bytes.begin(), bytes.end());
  return packet;
}

}  // namespace scanfuse::io::pcap
