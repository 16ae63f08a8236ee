#include "scanfuse/io/text/byte_source.hpp"

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>

#include "scanfuse/io/text/unpack.hpp"

namespace scanfuse::io {
namespace {

class PlainFile final : public ByteSource {
 public:
  PlainFile(std::FILE* file, std::string name) : file_(file), name_(std::move(name)) {}
  PlainFile(const PlainFile&) = delete;
  PlainFile& operator=(const PlainFile&) = delete;
  ~PlainFile() override { std::fclose(file_); }

  Result<std::size_t> read(std::span<char> into) override {
    const std::size_t got = std::fread(into.data(), 1, into.size(), file_);
    if (got == 0 && std::ferror(file_) != 0) {
      return fail(Error::Code::kMalformed, "{}: cannot be read: {}", name_, std::strerror(errno));
    }
    return got;
  }

 private:
  std::FILE* file_;
  std::string name_;
};

class MemoryBytes final : public ByteSource {
 public:
  explicit MemoryBytes(std::string bytes) : bytes_(std::move(bytes)) {}
  Result<std::size_t> read(std::span<char> into) override {
    const std::size_t count = std::min(into.size(), bytes_.size() - place_);
    std::memcpy(into.data(), bytes_.data() + place_, count);
    place_ += count;
    return count;
  }

 private:
  std::string bytes_;
  std::size_t place_ = 0;
};

/// Gives back the bytes that were read to find out the packing.
class Prefixed final : public ByteSource {
 public:
  Prefixed(std::string prefix, std::unique_ptr<ByteSource> rest)
      : prefix_(std::move(prefix)), rest_(std::move(rest)) {}
  Result<std::size_t> read(std::span<char> into) override {
    if (place_ == prefix_.size()) return rest_->read(into);
    const std::size_t count = std::min(into.size(), prefix_.size() - place_);
    std::memcpy(into.data(), prefix_.data() + place_, count);
    place_ += count;
    return count;
  }

 private:
  std::string prefix_;
  std::unique_ptr<ByteSource> rest_;
  std::size_t place_ = 0;
};

std::unique_ptr<ByteSource> unpack(std::string name, std::string prefix,
                                   std::unique_ptr<ByteSource> rest) {
  const std::string packing = packing_of(prefix);
  auto whole = std::make_unique<Prefixed>(std::move(prefix), std::move(rest));
  if (packing == "gzip") return unpack_gzip(std::move(name), std::move(whole));
  if (packing == "xz") return unpack_xz(std::move(name), std::move(whole));
  return whole;
}

}  // namespace

std::string packing_of(std::string_view first_bytes) {
  if (first_bytes.starts_with("\x1f\x8b")) return "gzip";
  if (first_bytes.starts_with(std::string_view("\xfd"
                                               "7zXZ\0",
                                               6)))
    return "xz";
  return "none";
}

Result<std::unique_ptr<ByteSource>> open_bytes(const std::filesystem::path& path) {
  std::error_code ignored;
  if (!std::filesystem::exists(path, ignored)) {
    return fail(Error::Code::kNotFound, "{}: no such file", path.string());
  }
  if (std::filesystem::is_directory(path, ignored)) {
    return fail(Error::Code::kUnsupported, "{}: is a folder, a file is needed", path.string());
  }
  std::FILE* file = std::fopen(path.c_str(), "rb");
  if (file == nullptr) {
    return fail(Error::Code::kNotFound, "{}: cannot be opened: {}", path.string(),
                std::strerror(errno));
  }
  auto plain = std::make_unique<PlainFile>(file, path.string());
  std::string prefix(6, '\0');
  const auto got = plain->read(prefix);
  if (!got) return tl::unexpected(got.error());
  prefix.resize(*got);
  return unpack(path.string(), std::move(prefix), std::move(plain));
}

std::unique_ptr<ByteSource> open_memory(std::string name, const std::string& bytes) {
  std::string prefix = bytes.substr(0, 6);
  auto rest = std::make_unique<MemoryBytes>(bytes.substr(prefix.size()));
  return unpack(std::move(name), std::move(prefix), std::move(rest));
}

Result<std::string> read_start(ByteSource& source, std::size_t limit) {
  std::string text;
  std::string block(std::min<std::size_t>(limit, 1 << 16), '\0');
  while (text.size() < limit) {
    const std::size_t wanted = std::min(block.size(), limit - text.size());
    const auto got = source.read(std::span(block.data(), wanted));
    if (!got) return tl::unexpected(got.error());
    if (*got == 0) break;
    text.append(block, 0, *got);
  }
  return text;
}

}  // namespace scanfuse::io
