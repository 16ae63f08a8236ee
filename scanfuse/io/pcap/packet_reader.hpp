#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "scanfuse/core/diagnostics.hpp"
#include "scanfuse/core/result.hpp"
#include "scanfuse/core/time.hpp"
#include "scanfuse/io/text/byte_source.hpp"

namespace scanfuse::io::pcap {

/// One packet as it was captured.
struct Packet {
  Time time;
  std::uint32_t link_type = 1;  ///< 1: Ethernet, 113: Linux cooked, 101: raw IP, ...
  std::vector<std::byte> bytes;
};

/// Whether a file that starts so is a capture: pcap [Pcap2023] or pcapng [Pcapng2023].
[[nodiscard]] bool is_capture(std::string_view first_bytes);

/// Reads the packets of a capture front to back: pcap (both byte orders, micro- and nanoseconds)
/// and pcapng (several sections and interfaces). A capture that was cut off gives the packets
/// before; a block that contradicts itself ends it, counted as damage.
class PacketReader {
 public:
  [[nodiscard]] static Result<PacketReader> open(const std::filesystem::path& path);
  [[nodiscard]] static Result<PacketReader> open(std::string name,
                                                 std::unique_ptr<ByteSource> source);

  /// The next packet; nothing at the end.
  [[nodiscard]] std::optional<Packet> next();
  [[nodiscard]] const Diagnostics& diagnostics() const { return diagnostics_; }
  [[nodiscard]] std::string_view format() const { return ng_ ? "pcapng" : "pcap"; }

 private:
  struct Interface {
    std::uint32_t link_type = 1;
    std::uint64_t ticks_per_second = 1'000'000;
    std::int64_t offset_s = 0;
  };
  PacketReader(std::string name, std::unique_ptr<ByteSource> source)
      : name_(std::move(name)), source_(std::move(source)) {}

  [[nodiscard]] Result<void> read_head();
  std::optional<Packet> next_classic();
  /// The next block of pcapng; `found` gets its packet, if it is one. False at the end.
  bool next_block(std::optional<Packet>& found);
  bool start_section();
  void add_interface(std::span<const std::byte> body);
  std::optional<Packet> packet_of(std::uint32_t type, std::span<const std::byte> body);
  /// Exactly `count` bytes; empty at the end of the file or where it is cut off.
  std::span<const std::byte> read(std::size_t count);
  [[nodiscard]] std::uint32_t u32(std::span<const std::byte> bytes, std::size_t at) const;
  [[nodiscard]] std::uint16_t u16(std::span<const std::byte> bytes, std::size_t at) const;
  void damaged(std::string_view what);

  std::string name_;
  std::unique_ptr<ByteSource> source_;
  bool ng_ = false;
  bool swapped_ = false;
  bool ended_ = false;
  bool nanoseconds_ = false;
  std::uint64_t offset_ = 0;
  std::vector<std::byte> buffer_;
  std::vector<Interface> interfaces_;
  Diagnostics diagnostics_;
};

}  // namespace scanfuse::io::pcap
