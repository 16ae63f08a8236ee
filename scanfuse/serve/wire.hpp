#pragma once

#include <bit>
#include <cstdint>
#include <cstring>
#include <string>
#include <type_traits>

namespace scanfuse::serve {

static_assert(std::endian::native == std::endian::little, "messages are copied as they stand");

/// Appends numbers, little endian.
class WireWriter {
 public:
  explicit WireWriter(std::size_t expected = 0) { bytes_.reserve(expected); }

  template <class T>
    requires std::is_arithmetic_v<T>
  WireWriter& put(T value) {
    char raw[sizeof(T)];
    std::memcpy(raw, &value, sizeof(T));
    bytes_.append(raw, sizeof(T));
    return *this;
  }
  WireWriter& u32(std::uint64_t value) { return put(static_cast<std::uint32_t>(value)); }
  WireWriter& f32(double value) { return put(static_cast<float>(value)); }
  WireWriter& f64(double value) { return put(value); }

  /// Zeros up to a multiple of `size`.
  WireWriter& align(std::size_t size) {
    while (bytes_.size() % size != 0) bytes_.push_back('\0');
    return *this;
  }
  /// Writes over a number that already stands there.
  void patch(std::size_t offset, std::uint32_t value) {
    std::memcpy(bytes_.data() + offset, &value, sizeof(value));
  }
  [[nodiscard]] std::size_t size() const { return bytes_.size(); }
  [[nodiscard]] std::string take() { return std::move(bytes_); }

 private:
  std::string bytes_;
};

/// Reads them back. Past the end it gives zeros and is no longer ok.
class WireReader {
 public:
  explicit WireReader(std::string_view bytes) : bytes_(bytes) {}

  template <class T>
    requires std::is_arithmetic_v<T>
  T get() {
    T value{};
    if (bytes_.size() - offset_ < sizeof(T)) {
      ok_ = false;
      return value;
    }
    std::memcpy(&value, bytes_.data() + offset_, sizeof(T));
    offset_ += sizeof(T);
    return value;
  }
  std::string_view take(std::size_t count) {
    if (bytes_.size() - offset_ < count) {
      ok_ = false;
      return {};
    }
    offset_ += count;
    return bytes_.substr(offset_ - count, count);
  }
  [[nodiscard]] bool ok() const { return ok_; }

 private:
  std::string_view bytes_;
  std::size_t offset_ = 0;
  bool ok_ = true;
};

}  // namespace scanfuse::serve
