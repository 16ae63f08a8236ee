#include <utility>

#include "scanfuse/io/atomic_file.hpp"
#include "scanfuse/io/mcap/writer.hpp"

namespace scanfuse::io::mcap {
namespace {

class FileSink final : public ByteSink {
 public:
  explicit FileSink(AtomicFile file) : file_(std::move(file)) {}
  [[nodiscard]] Result<void> write(std::span<const std::byte> bytes) override {
    return file_.write(bytes);
  }
  [[nodiscard]] Result<void> flush() override { return file_.flush(); }
  [[nodiscard]] Result<void> commit() override { return file_.commit(); }

 private:
  AtomicFile file_;
};

class MemorySink final : public ByteSink {
 public:
  explicit MemorySink(std::vector<std::byte>& bytes) : bytes_(bytes) {}
  [[nodiscard]] Result<void> write(std::span<const std::byte> bytes) override {
    bytes_.insert(bytes_.end(), bytes.begin(), bytes.end());
    return {};
  }
  [[nodiscard]] Result<void> commit() override { return {}; }

 private:
  std::vector<std::byte>& bytes_;
};

}  // namespace

Result<std::unique_ptr<ByteSink>> sink_to_file(const std::filesystem::path& path) {
  auto file = AtomicFile::create(path);
  if (!file) return tl::unexpected(file.error());
  return std::make_unique<FileSink>(std::move(*file));
}

std::unique_ptr<ByteSink> sink_to_memory(std::vector<std::byte>& bytes) {
  return std::make_unique<MemorySink>(bytes);
}

}  // namespace scanfuse::io::mcap
