#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

namespace scanfuse::drivers {

using Bytes = std::vector<std::byte>;
using ByteView = std::span<const std::byte>;

template <class T>
concept Number = std::integral<T> || std::floating_point<T>;

[[nodiscard]] inline ByteView view_of(std::string_view text) {
  return std::as_bytes(std::span(text.data(), text.size()));
}
[[nodiscard]] inline std::string_view text_of(ByteView bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}
inline void append(Bytes& to, ByteView more) { to.insert(to.end(), more.begin(), more.end()); }

/// Reads the fields of a telegram in order. A read past the end marks the reader as failed and
/// gives zeros from then on, so that a decoder asks once, at the end, with `ok`.
template <std::endian kOrder>
class FieldReader {
 public:
  explicit FieldReader(ByteView bytes) : bytes_(bytes) {}

  template <Number T>
  T read() {
    std::array<std::byte, sizeof(T)> raw{};
    const ByteView from = take(sizeof(T));
    if (from.empty()) return T{};
    std::ranges::copy(from, raw.begin());
    if constexpr (kOrder != std::endian::native) std::ranges::reverse(raw);
    return std::bit_cast<T>(raw);
  }
  /// The next `count` bytes; empty, and failed, when there are fewer.
  ByteView take(std::size_t count) {
    if (count > bytes_.size() - place_) {
      place_ = bytes_.size();
      ok_ = false;
      return {};
    }
    place_ += count;
    return bytes_.subspan(place_ - count, count);
  }
  void skip(std::size_t count) { (void)take(count); }
  [[nodiscard]] bool ok() const { return ok_; }
  [[nodiscard]] std::size_t place() const { return place_; }
  [[nodiscard]] std::size_t left() const { return bytes_.size() - place_; }

 private:
  ByteView bytes_;
  std::size_t place_ = 0;
  bool ok_ = true;
};

/// Writes the fields of a telegram in order.
template <std::endian kOrder>
class FieldWriter {
 public:
  explicit FieldWriter(Bytes& to) : to_(&to) {}

  template <Number T>
  FieldWriter& write(T value) {
    auto raw = std::bit_cast<std::array<std::byte, sizeof(T)>>(value);
    if constexpr (kOrder != std::endian::native) std::ranges::reverse(raw);
    to_->insert(to_->end(), raw.begin(), raw.end());
    return *this;
  }
  FieldWriter& text(std::string_view text) {
    append(*to_, view_of(text));
    return *this;
  }

 private:
  Bytes* to_;
};

using BigReader = FieldReader<std::endian::big>;
using LittleReader = FieldReader<std::endian::little>;
using BigWriter = FieldWriter<std::endian::big>;
using LittleWriter = FieldWriter<std::endian::little>;

}  // namespace scanfuse::drivers
