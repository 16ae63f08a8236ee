#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace scanfuse::io::mcap {

/// Takes little-endian numbers and counted strings off a buffer. Running past the end makes it
/// fail for good: every later value is zero or empty and `ok()` is false.
class ByteCursor {
 public:
  explicit ByteCursor(std::span<const std::byte> bytes) : rest_(bytes) {}

  [[nodiscard]] bool ok() const { return ok_; }
  [[nodiscard]] bool at_end() const { return rest_.empty(); }
  [[nodiscard]] std::span<const std::byte> rest() const { return rest_; }

  template <class Unsigned>
  [[nodiscard]] Unsigned number() {
    static_assert(std::is_unsigned_v<Unsigned>);
    Unsigned value = 0;
    const auto bytes = take(sizeof(Unsigned));
    for (std::size_t i = 0; i < bytes.size(); ++i) {
      value = static_cast<Unsigned>(value | (std::to_integer<Unsigned>(bytes[i]) << (8 * i)));
    }
    return value;
  }
  [[nodiscard]] std::span<const std::byte> take(std::uint64_t count) {
    if (!ok_ || count > rest_.size()) {
      ok_ = false;
      rest_ = {};
      return {};
    }
    const auto taken = rest_.first(static_cast<std::size_t>(count));
    rest_ = rest_.subspan(taken.size());
    return taken;
  }
  /// Bytes counted by a uint32.
  [[nodiscard]] std::span<const std::byte> counted() { return take(number<std::uint32_t>()); }
  [[nodiscard]] std::string text() {
    const auto bytes = counted();
    return std::string(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  }

 private:
  std::span<const std::byte> rest_;
  bool ok_ = true;
};

/// Appends little-endian numbers and counted strings to a buffer.
class ByteWriter {
 public:
  explicit ByteWriter(std::vector<std::byte>& bytes) : bytes_(bytes) {}

  template <class Unsigned>
  void number(Unsigned value) {
    static_assert(std::is_unsigned_v<Unsigned>);
    std::byte little[sizeof(Unsigned)];
    for (std::size_t i = 0; i < sizeof(Unsigned); ++i) {
      little[i] = static_cast<std::byte>(value >> (8 * i));
    }
    bytes_.insert(bytes_.end(), little, little + sizeof(Unsigned));
  }
  void raw(std::span<const std::byte> data) {
    bytes_.insert(bytes_.end(), data.begin(), data.end());
  }
  void text(std::string_view value) {
    number(static_cast<std::uint32_t>(value.size()));
    raw(std::as_bytes(std::span(value.data(), value.size())));
  }
  [[nodiscard]] std::size_t size() const { return bytes_.size(); }
  /// Writes `value` over the 4 or 8 bytes at `place`, for lengths known only afterwards.
  template <class Unsigned>
  void patch(std::size_t place, Unsigned value) {
    for (std::size_t i = 0; i < sizeof(Unsigned); ++i) {
      bytes_[place + i] = static_cast<std::byte>(value >> (8 * i));
    }
  }

 private:
  std::vector<std::byte>& bytes_;
};

}  // namespace scanfuse::io::mcap
