#include "scanfuse/io/mcap/byte_source.hpp"

#include <algorithm>
#include <cstring>
#include <fstream>
#include <system_error>

namespace scanfuse::io::mcap {
namespace {

/// Reads ahead, because the heads of records are only 9 bytes long.
class FileBytes final : public ByteSource {
 public:
  FileBytes(std::ifstream file, std::uint64_t size, std::string name)
      : file_(std::move(file)), size_(size), name_(std::move(name)) {}

  [[nodiscard]] std::uint64_t size() const override { return size_; }
  [[nodiscard]] const std::string& name() const override { return name_; }

  [[nodiscard]] Result<void> read(std::uint64_t offset, std::span<std::byte> into) override {
    if (into.size() >= kWindow) return read_file(offset, into);
    if (offset < window_start_ || offset + into.size() > window_start_ + window_.size()) {
      window_.resize(static_cast<std::size_t>(std::min<std::uint64_t>(kWindow, size_ - offset)));
      window_start_ = offset;
      if (auto done = read_file(offset, window_); !done) {
        window_.clear();
        return done;
      }
    }
    std::memcpy(into.data(), window_.data() + (offset - window_start_), into.size());
    return {};
  }

 private:
  static constexpr std::size_t kWindow = std::size_t{64} * 1024;

  Result<void> read_file(std::uint64_t offset, std::span<std::byte> into) {
    file_.clear();
    file_.seekg(static_cast<std::streamoff>(offset));
    file_.read(reinterpret_cast<char*>(into.data()), static_cast<std::streamsize>(into.size()));
    if (file_.gcount() == static_cast<std::streamsize>(into.size())) return {};
    return fail(Error::Code::kMalformed, "{}: cannot read {} bytes at byte {}; did it shrink?",
                name_, into.size(), offset);
  }

  std::ifstream file_;
  std::uint64_t size_;
  std::string name_;
  std::uint64_t window_start_ = 0;
  std::vector<std::byte> window_;
};

class MemoryBytes final : public ByteSource {
 public:
  MemoryBytes(std::vector<std::byte> bytes, std::string name)
      : bytes_(std::move(bytes)), name_(std::move(name)) {}

  [[nodiscard]] std::uint64_t size() const override { return bytes_.size(); }
  [[nodiscard]] const std::string& name() const override { return name_; }
  [[nodiscard]] Result<void> read(std::uint64_t offset, std::span<std::byte> into) override {
    if (!into.empty()) std::memcpy(into.data(), bytes_.data() + offset, into.size());
    return {};
  }

 private:
  std::vector<std::byte> bytes_;
  std::string name_;
};

}  // namespace

Result<std::unique_ptr<ByteSource>> open_bytes(const std::filesystem::path& path) {
  std::error_code error;
  const auto size = std::filesystem::file_size(path, error);
  std::ifstream file(path, std::ios::binary);
  if (error || !file) {
    return fail(Error::Code::kNotFound, "{}: no such file, or it cannot be read", path.string());
  }
  return std::make_unique<FileBytes>(std::move(file), size, path.string());
}

std::unique_ptr<ByteSource> bytes_in_memory(std::vector<std::byte> bytes, std::string name) {
  return std::make_unique<MemoryBytes>(std::move(bytes), std::move(name));
}

}  // namespace scanfuse::io::mcap
