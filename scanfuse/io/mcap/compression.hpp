#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "scanfuse/core/result.hpp"

namespace scanfuse::io::mcap {

enum class Compression { kNone, kLz4, kZstd };

constexpr auto choices(Compression) {
  using enum Compression;
  return std::array{std::pair{"none", kNone}, std::pair{"lz4", kLz4}, std::pair{"zstd", kZstd}};
}

/// Compresses the records of a chunk. The same bytes give the same bytes.
class Compressor {
 public:
  explicit Compressor(Compression kind, int level = 3);
  Compressor(Compressor&&) noexcept;
  Compressor& operator=(Compressor&&) noexcept;
  ~Compressor();
  [[nodiscard]] Result<std::vector<std::byte>> compress(std::span<const std::byte> bytes);
  /// As a chunk names it: "", "lz4" or "zstd".
  [[nodiscard]] std::string_view name() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// What could be recovered of compressed bytes.
struct Decompressed {
  std::vector<std::byte> bytes;
  bool complete = false;  ///< the stream ended well and gave exactly the announced size
};

/// Decompresses as far as the bytes are sound. Gives never more than `announced_size` bytes and
/// reserves no more than a bounded multiple of what is really there.
class Decompressor {
 public:
  Decompressor();
  Decompressor(Decompressor&&) noexcept;
  Decompressor& operator=(Decompressor&&) noexcept;
  ~Decompressor();
  /// `name` is "", "none", "lz4" (frame format) or "zstd"; others are an error (kUnsupported).
  [[nodiscard]] Result<Decompressed> decompress(std::string_view name,
                                                std::span<const std::byte> bytes,
                                                std::uint64_t announced_size);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace scanfuse::io::mcap
