#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <string_view>

#include "scanfuse/core/result.hpp"

namespace scanfuse::io {

/// Bytes read front to back, already unpacked.
class ByteSource {
 public:
  virtual ~ByteSource() = default;
  /// Fills the front of `into`, returns how much; 0 at the end. An error is final; what was
  /// returned before it stands.
  [[nodiscard]] virtual Result<std::size_t> read(std::span<char> into) = 0;
  /// How it was packed: "gzip", "xz" or "none".
  [[nodiscard]] virtual std::string_view packing() const { return "none"; }
};

/// Opens a file; gzip and xz are recognised by their first bytes and unpacked while reading.
[[nodiscard]] Result<std::unique_ptr<ByteSource>> open_bytes(const std::filesystem::path& path);

/// The same over bytes in memory. `name` stands in error messages.
[[nodiscard]] std::unique_ptr<ByteSource> open_memory(std::string name, const std::string& bytes);

/// How the file is packed: "gzip", "xz" or "none".
[[nodiscard]] std::string packing_of(std::string_view first_bytes);

/// The whole unpacked content, at most `limit` bytes of it.
[[nodiscard]] Result<std::string> read_start(ByteSource& source, std::size_t limit);

}  // namespace scanfuse::io
