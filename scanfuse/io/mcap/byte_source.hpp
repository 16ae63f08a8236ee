#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "scanfuse/core/result.hpp"

namespace scanfuse::io::mcap {

/// Bytes that can be read at any place: a file, or a buffer in tests.
class ByteSource {
 public:
  virtual ~ByteSource() = default;
  [[nodiscard]] virtual std::uint64_t size() const = 0;
  /// Fills `into` with the bytes from `offset`; the caller stays within `size()`.
  [[nodiscard]] virtual Result<void> read(std::uint64_t offset, std::span<std::byte> into) = 0;
  /// For messages: the file's name.
  [[nodiscard]] virtual const std::string& name() const = 0;
};

[[nodiscard]] Result<std::unique_ptr<ByteSource>> open_bytes(const std::filesystem::path& path);
[[nodiscard]] std::unique_ptr<ByteSource> bytes_in_memory(std::vector<std::byte> bytes,
                                                          std::string name = "memory");

}  // namespace scanfuse::io::mcap
