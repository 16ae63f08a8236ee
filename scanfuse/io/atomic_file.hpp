#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string_view>

#include "scanfuse/core/result.hpp"

namespace scanfuse::io {

/// A file that appears under its name only when it is whole: written beside the target as
/// "<name>.part", moved into place by `commit`. Destroyed without `commit`, it removes the part.
/// A full disk or a missing folder is an error of the call that met it.
class AtomicFile {
 public:
  [[nodiscard]] static Result<AtomicFile> create(const std::filesystem::path& path);
  AtomicFile(AtomicFile&&) noexcept;
  AtomicFile& operator=(AtomicFile&&) noexcept;
  ~AtomicFile();

  [[nodiscard]] Result<void> write(std::span<const std::byte> bytes);
  [[nodiscard]] Result<void> write(std::string_view text);
  /// Hands what was written to the operating system: from then on it outlives this process.
  [[nodiscard]] Result<void> flush();
  /// Flushes, closes and moves into place. Nothing may be written afterwards.
  [[nodiscard]] Result<void> commit();
  [[nodiscard]] std::uint64_t bytes_written() const;
  [[nodiscard]] const std::filesystem::path& path() const;

 private:
  struct State;
  explicit AtomicFile(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

/// A file of this text, made as an AtomicFile.
[[nodiscard]] Result<void> write_whole(const std::filesystem::path& path, std::string_view text);

}  // namespace scanfuse::io
