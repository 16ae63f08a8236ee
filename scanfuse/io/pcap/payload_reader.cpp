#include "scanfuse/io/pcap/payload_reader.hpp"

#include <algorithm>
#include <bit>
#include <utility>

#include "scanfuse/io/ros/wire_reader.hpp"

namespace scanfuse::io::pcap {
namespace {

constexpr int kTcp = 6;
constexpr int kUdp = 17;
constexpr int kIpv6Fragment = 44;
constexpr std::size_t kMostEarly = 64;
constexpr std::size_t kMostFragmented = 64;
constexpr std::size_t kMostStreams = 4096;

template <class T>
T big(std::span<const std::byte> bytes, std::size_t at) {
  return ros::WireReader::load<T>(bytes.data() + at, std::endian::native == std::endian::little);
}

int u8(std::span<const std::byte> bytes, std::size_t at) { return std::to_integer<int>(bytes[at]); }

std::string ipv4_text(std::span<const std::byte> bytes, std::size_t at) {
  return fmt::format("{}.{}.{}.{}", u8(bytes, at), u8(bytes, at + 1), u8(bytes, at + 2),
                     u8(bytes, at + 3));
}

std::string ipv6_text(std::span<const std::byte> bytes, std::size_t at) {
  std::string text;
  for (std::size_t i = 0; i < 16; i += 2) {
    text += fmt::format("{}{:x}", i == 0 ? "" : ":", big<std::uint16_t>(bytes, at + i));
  }
  return text;
}

/// How many bytes the link's own head takes; nothing for links that are not known.
std::optional<std::size_t> link_head(const Packet& packet) {
  const std::span<const std::byte> bytes(packet.bytes);
  switch (packet.link_type) {
    case 1: {
      std::size_t head = 14;
      while (bytes.size() >= head + 4 && big<std::uint16_t>(bytes, head - 2) == 0x8100) head += 4;
      return head;
    }
    case 0:
    case 108:
      return 4;
    case 12:
    case 101:
      return 0;
    case 113:
      return 16;
    case 276:
      return 20;
    default:
      return std::nullopt;
  }
}

}  // namespace

Diagnostics PayloadReader::diagnostics() const {
  Diagnostics all = packets_.diagnostics();
  all.merge(diagnostics_);
  return all;
}

std::optional<Payload> PayloadReader::next() {
  while (ready_.empty()) {
    const auto packet = packets_.next();
    if (!packet) break;
    take(*packet);
  }
  if (ready_.empty()) return std::nullopt;
  Payload payload = std::move(ready_.front());
  ready_.pop_front();
  return payload;
}

void PayloadReader::take(const Packet& packet) {
  const auto head = link_head(packet);
  if (!head) {
    diagnostics_.note("packet of a link that is not known",
                      fmt::format("link type {}", packet.link_type));
    return;
  }
  if (packet.bytes.size() < *head + 20) return;
  const auto ip = std::span(packet.bytes).subspan(*head);
  const int version = u8(ip, 0) >> 4;
  if (version == 4) take_ipv4(packet.time, ip);
  if (version == 6) take_ipv6(packet.time, ip);
}

void PayloadReader::take_ipv4(Time time, Bytes bytes) {
  const auto head = static_cast<std::size_t>(u8(bytes, 0) & 15) * 4;
  // Ethernet fills up short packets: the length is the packet's own word. 0: left to the hardware.
  const std::size_t told = big<std::uint16_t>(bytes, 2);
  const std::size_t size = told == 0 ? bytes.size() : std::min(told, bytes.size());
  if (head < 20 || size < head) return;
  const auto fragment = big<std::uint16_t>(bytes, 6);
  const bool more = (fragment & 0x2000) != 0;
  const auto offset = static_cast<std::size_t>(fragment & 0x1FFF) * 8;
  const int protocol = u8(bytes, 9);
  const Flow flow{Protocol::kTcp, {ipv4_text(bytes, 12)}, {ipv4_text(bytes, 16)}};
  const auto body = bytes.subspan(head, size - head);
  if (!more && offset == 0) return take_transport(time, protocol, flow, body);
  const std::string key = flow.from.address + ">" + flow.to.address + "#" +
                          std::to_string(big<std::uint16_t>(bytes, 4)) + "/" +
                          std::to_string(protocol);
  const auto whole = put_together(key, offset, more, body);
  if (!whole.empty()) take_transport(time, protocol, flow, whole);
}

void PayloadReader::take_ipv6(Time time, Bytes bytes) {
  if (bytes.size() < 40) return;
  int protocol = u8(bytes, 6);
  const std::size_t size = std::min<std::size_t>(big<std::uint16_t>(bytes, 4), bytes.size() - 40);
  const Flow flow{Protocol::kTcp, {ipv6_text(bytes, 8)}, {ipv6_text(bytes, 24)}};
  const auto body = bytes.subspan(40, size);
  if (protocol != kIpv6Fragment) return take_transport(time, protocol, flow, body);
  if (body.size() < 8) return;
  protocol = u8(body, 0);
  const auto fragment = big<std::uint16_t>(body, 2);
  const std::string key =
      flow.from.address + ">" + flow.to.address + "#" + std::to_string(big<std::uint32_t>(body, 4));
  const auto whole = put_together(key, fragment & 0xFFF8U, (fragment & 1) != 0, body.subspan(8));
  if (!whole.empty()) take_transport(time, protocol, flow, whole);
}

std::vector<std::byte> PayloadReader::put_together(const std::string& key, std::size_t offset,
                                                   bool more, Bytes bytes) {
  if (fragments_.size() >= kMostFragmented && !fragments_.contains(key)) {
    diagnostics_.note("datagram of which fragments are missing", {},
                      static_cast<int>(fragments_.size()));
    fragments_.clear();
  }
  Fragments& all = fragments_[key];
  all.parts[offset].assign(bytes.begin(), bytes.end());
  if (!more) all.size = offset + bytes.size();
  std::vector<std::byte> whole;
  for (const auto& [at, part] : all.parts) {
    if (at != whole.size()) return {};
    whole.insert(whole.end(), part.begin(), part.end());
  }
  if (!all.size || whole.size() != *all.size) return {};
  fragments_.erase(key);
  return whole;
}

void PayloadReader::take_transport(Time time, int protocol, Flow flow, Bytes bytes) {
  const std::size_t head = protocol == kTcp ? 20 : 8;
  if ((protocol != kTcp && protocol != kUdp) || bytes.size() < head) return;
  flow.protocol = protocol == kTcp ? Protocol::kTcp : Protocol::kUdp;
  flow.from.port = big<std::uint16_t>(bytes, 0);
  flow.to.port = big<std::uint16_t>(bytes, 2);
  Payload payload{time, std::move(flow), {}, false, false};
  if (protocol == kUdp) {
    const auto body = bytes.subspan(8);
    payload.bytes.assign(body.begin(), body.end());
    ready_.push_back(std::move(payload));
    return;
  }
  const auto options = static_cast<std::size_t>(u8(bytes, 12) >> 4) * 4;
  if (options < head || options > bytes.size()) return;
  const auto body = bytes.subspan(options);
  payload.bytes.assign(body.begin(), body.end());
  const bool syn = (u8(bytes, 13) & 2) != 0;
  take_segment(std::move(payload), big<std::uint32_t>(bytes, 4) + (syn ? 1U : 0U), syn);
}

void PayloadReader::take_segment(Payload payload, std::uint32_t sequence, bool start) {
  if (streams_.size() >= kMostStreams) streams_.clear();
  const auto [found, is_new] = streams_.try_emplace(payload.flow);
  Stream& stream = found->second;
  if (is_new || start) {
    stream.next = sequence;
    stream.early.clear();
    stream.is_fresh = true;
  }
  if (payload.bytes.empty()) return;
  const auto ahead = static_cast<std::int32_t>(sequence - stream.next);
  if (ahead < 0) {
    const auto known = static_cast<std::size_t>(-static_cast<std::int64_t>(ahead));
    if (known >= payload.bytes.size()) return;  // a repetition
    payload.bytes.erase(payload.bytes.begin(),
                        payload.bytes.begin() + static_cast<std::ptrdiff_t>(known));
    sequence = stream.next;
  }
  stream.early.insert_or_assign(sequence, std::move(payload));
  drain(stream);
}

void PayloadReader::drain(Stream& stream) {
  const auto ahead = [&](const auto& entry) {
    return static_cast<std::int32_t>(entry.first - stream.next);
  };
  while (!stream.early.empty()) {
    const auto first = std::ranges::min_element(
        stream.early, [&](const auto& a, const auto& b) { return ahead(a) < ahead(b); });
    if (ahead(*first) > 0) {
      if (stream.early.size() < kMostEarly) return;
      diagnostics_.note("gap in a captured stream", first->second.flow.from.address);
      first->second.after_gap = true;
      stream.next = first->first;
    }
    auto node = stream.early.extract(first);
    const auto known = static_cast<std::size_t>(stream.next - node.key());
    auto& payload = node.mapped();
    if (known >= payload.bytes.size()) continue;
    payload.bytes.erase(payload.bytes.begin(),
                        payload.bytes.begin() + static_cast<std::ptrdiff_t>(known));
    stream.next += static_cast<std::uint32_t>(payload.bytes.size());
    payload.start = std::exchange(stream.is_fresh, false);
    ready_.push_back(std::move(payload));
  }
}

}  // namespace scanfuse::io::pcap
