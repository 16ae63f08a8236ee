#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string_view>
#include <utility>
#include <vector>

#include "scanfuse/core/time.hpp"

namespace scanfuse::io::ros {

/// Writes the fields of one message as little-endian CDR (XCDR1) with its encapsulation header.
class CdrWriter {
 public:
  CdrWriter() : bytes_{std::byte{0}, std::byte{1}, std::byte{0}, std::byte{0}} {}

  template <class T>
  void write(T value) {
    while ((bytes_.size() - kOrigin) % sizeof(T) != 0) bytes_.push_back(std::byte{0});
    auto raw = std::bit_cast<std::array<std::byte, sizeof(T)>>(value);
    if constexpr (std::endian::native == std::endian::big) std::reverse(raw.begin(), raw.end());
    bytes_.insert(bytes_.end(), raw.begin(), raw.end());
  }
  void write_string(std::string_view text) {
    write(static_cast<std::uint32_t>(text.size() + 1));
    for (const char c : text) bytes_.push_back(static_cast<std::byte>(c));
    bytes_.push_back(std::byte{0});
  }
  /// Seconds before 1901 or after 2038 do not fit the message; they are cut off at its limits.
  void write_time(Time time) {
    const auto seconds = std::chrono::floor<std::chrono::seconds>(time);
    const auto count = std::clamp<std::int64_t>(seconds.time_since_epoch().count(),
                                                std::numeric_limits<std::int32_t>::min(),
                                                std::numeric_limits<std::int32_t>::max());
    write(static_cast<std::int32_t>(count));
    write(static_cast<std::uint32_t>((time - seconds).count()));
  }
  [[nodiscard]] std::vector<std::byte> take() { return std::move(bytes_); }

 private:
  static constexpr std::size_t kOrigin = 4;
  std::vector<std::byte> bytes_;
};

}  // namespace scanfuse::io::ros
