#pragma once

#include <bit>
#include <cstdint>
#include <cstring>
#include <span>
#include <string>
#include <string_view>

#include "scanfuse/core/result.hpp"
#include "scanfuse/core/time.hpp"

namespace scanfuse::io::ros {

/// Reads the fields of one serialised ROS message in order. Two encodings: "ros1" (little endian,
/// nothing aligned) and "cdr" (OMG CDR with its encapsulation header: plain XCDR1 and plain XCDR2,
/// both byte orders). A read past the end marks the reader as failed and gives zeros from then on,
/// so that a decoder checks once, at the end, with `finish`.
class WireReader {
 public:
  [[nodiscard]] static Result<WireReader> open(std::string_view encoding,
                                               std::span<const std::byte> bytes);

  template <class T>
  T read() {
    align(sizeof(T));
    if (!need(sizeof(T))) return T{};
    const T value = load<T>(bytes_.data() + offset_, swap_);
    offset_ += sizeof(T);
    return value;
  }
  std::string read_string();
  Time read_time();
  /// The length of a sequence whose elements take at least `element_bytes` each; fails if the
  /// message cannot hold that many.
  std::uint32_t read_count(std::size_t element_bytes);
  /// Passes over `count` numbers of type T.
  template <class T>
  void skip(std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) (void)read<T>();
  }
  /// The next `count` bytes; empty when there are fewer.
  std::span<const std::byte> read_bytes(std::size_t count);

  [[nodiscard]] bool ros1() const { return ros1_; }
  [[nodiscard]] bool ok() const { return problem_.empty(); }
  /// Marks the message as wrong for a reason of the decoder's own; the first reason stays.
  void refuse(std::string_view why);
  /// Fails if a read failed or bytes are left over: "byte 24: ...".
  [[nodiscard]] Result<void> finish();

  /// One number at any address, in either byte order.
  template <class T>
  static T load(const std::byte* from, bool swap) {
    std::byte raw[sizeof(T)];
    for (std::size_t i = 0; i < sizeof(T); ++i) raw[swap ? sizeof(T) - 1 - i : i] = from[i];
    return std::bit_cast<T>(raw);
  }

 private:
  void align(std::size_t size);
  bool need(std::size_t count);

  std::span<const std::byte> bytes_;
  std::size_t offset_ = 0;
  std::size_t origin_ = 0;  ///< alignment counts from here
  std::size_t max_alignment_ = 8;
  bool ros1_ = true;
  bool swap_ = false;
  std::string problem_;
};

}  // namespace scanfuse::io::ros
