#pragma once

#include <compare>
#include <cstdint>
#include <deque>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "scanfuse/io/pcap/packet_reader.hpp"

namespace scanfuse::io::pcap {

struct Endpoint {
  std::string address;  ///< "192.168.0.1", or an IPv6 address in hexadecimal
  std::uint16_t port = 0;
  auto operator<=>(const Endpoint&) const = default;
};

enum class Protocol { kTcp, kUdp };

/// Who speaks to whom.
struct Flow {
  Protocol protocol = Protocol::kTcp;
  Endpoint from, to;
  auto operator<=>(const Flow&) const = default;
};

/// A datagram, or the next piece of a stream.
struct Payload {
  Time time;  ///< of its last byte's packet
  Flow flow;
  std::vector<std::byte> bytes;
  bool after_gap = false;  ///< bytes of the stream before it are missing in the capture
  bool start = false;      ///< of a connection
};

/// What was said in a capture: TCP streams in their order (repetitions left out, segments that came
/// too early put back), UDP datagrams, put together from fragments. Other protocols are passed
/// over. A gap that is not filled within 64 segments is counted, and the stream goes on behind it.
class PayloadReader {
 public:
  explicit PayloadReader(PacketReader packets) : packets_(std::move(packets)) {}

  [[nodiscard]] std::optional<Payload> next();
  [[nodiscard]] Diagnostics diagnostics() const;
  [[nodiscard]] std::string_view format() const { return packets_.format(); }

 private:
  using Bytes = std::span<const std::byte>;
  struct Stream {
    std::uint32_t next = 0;
    bool is_fresh = true;                    ///< nothing of this connection was given yet
    std::map<std::uint32_t, Payload> early;  ///< by sequence number
  };
  struct Fragments {
    std::map<std::size_t, std::vector<std::byte>> parts;  ///< by offset
    std::optional<std::size_t> size;
  };

  void take(const Packet& packet);
  void take_ipv4(Time time, Bytes bytes);
  void take_ipv6(Time time, Bytes bytes);
  void take_transport(Time time, int protocol, Flow flow, Bytes bytes);
  void take_segment(Payload payload, std::uint32_t sequence, bool start);
  void drain(Stream& stream);
  /// The datagram, once its last fragment is there.
  std::vector<std::byte> put_together(const std::string& key, std::size_t offset, bool more,
                                      Bytes bytes);

  PacketReader packets_;
  std::deque<Payload> ready_;
  std::map<Flow, Stream> streams_;
  std::map<std::string, Fragments> fragments_;
  Diagnostics diagnostics_;
};

}  // namespace scanfuse::io::pcap
