#pragma once

#include <cstdlib>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "scanfuse/core/time.hpp"
#include "scanfuse/drivers/bytes.hpp"
#include "scanfuse/io/text/byte_source.hpp"

namespace scanfuse::drivers_testing {

/// A packet of a capture that was turned into JSON.
struct Captured {
  Time time;
  drivers::Bytes bytes;
};

inline std::filesystem::path shared_sensors() {
  return std::filesystem::path(SCANFUSE_SHARED_DATA) / "sensors";
}

inline drivers::Bytes bytes_of_hex(const std::string& text) {
  drivers::Bytes bytes;
  std::string digits;
  for (const char c : text) {
    if (c == ':') continue;
    digits += c;
    if (digits.size() < 2) continue;
    bytes.push_back(static_cast<std::byte>(std::strtoul(digits.c_str(), nullptr, 16)));
    digits.clear();
  }
  return bytes;
}

inline nlohmann::json read_json(const std::filesystem::path& path) {
  auto source = io::open_bytes(path);
  if (!source) return {};
  const auto text = io::read_start(**source, std::size_t{1} << 30);
  return text ? nlohmann::json::parse(*text, nullptr, false) : nlohmann::json{};
}

/// Of a TCP stream: payloads with the seconds since the first packet.
inline std::vector<Captured> read_tcp_capture(const std::filesystem::path& path) {
  std::vector<Captured> packets;
  for (const auto& packet : read_json(path)) {
    const auto& tcp = packet["_source"]["layers"]["tcp"];
    if (!tcp.contains("tcp.payload")) continue;
    const double at_s =
        std::atof(tcp["Timestamps"]["tcp.time_relative"].get<std::string>().c_str());
    packets.push_back(
        {time_from_seconds(1.6e9 + at_s), bytes_of_hex(tcp["tcp.payload"].get<std::string>())});
  }
  return packets;
}

/// Of UDP: [seconds, hexadecimal digits].
inline std::vector<Captured> read_udp_capture(const std::filesystem::path& path) {
  std::vector<Captured> packets;
  for (const auto& packet : read_json(path)) {
    packets.push_back(
        {time_from_seconds(packet[0].get<double>()), bytes_of_hex(packet[1].get<std::string>())});
  }
  return packets;
}

}  // namespace scanfuse::drivers_testing
