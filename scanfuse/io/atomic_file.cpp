#include "scanfuse/io/atomic_file.hpp"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <system_error>
#include <utility>

#include "scanfuse/core/assert.hpp"

namespace scanfuse::io {

struct AtomicFile::State {
  std::filesystem::path path;
  std::filesystem::path part;
  std::FILE* file = nullptr;
  std::uint64_t written = 0;

  ~State() {
    if (file == nullptr) return;
    std::fclose(file);
    std::error_code ignored;
    std::filesystem::remove(part, ignored);
  }
};

AtomicFile::AtomicFile(std::unique_ptr<State> state) : state_(std::move(state)) {}
AtomicFile::AtomicFile(AtomicFile&&) noexcept = default;
AtomicFile& AtomicFile::operator=(AtomicFile&&) noexcept = default;
AtomicFile::~AtomicFile() = default;

std::uint64_t AtomicFile::bytes_written() const { return state_->written; }
const std::filesystem::path& AtomicFile::path() const { return state_->path; }

Result<AtomicFile> AtomicFile::create(const std::filesystem::path& path) {
  auto state = std::make_unique<State>();
  state->path = path;
  state->part = path;
  state->part += ".part";
  std::error_code ignored;
  if (std::filesystem::is_directory(path, ignored)) {
    return fail(Error::Code::kNotFound, "{}: is a folder; name a file to write", path.string());
  }
  state->file = std::fopen(state->part.c_str(), "wb");
  if (state->file == nullptr) {
    return fail(Error::Code::kNotFound, "{}: cannot be written ({}); does its folder exist?",
                state->part.string(), std::strerror(errno));
  }
  return AtomicFile(std::move(state));
}

Result<void> AtomicFile::write(std::span<const std::byte> bytes) {
  SCANFUSE_ASSERT(state_->file != nullptr);
  if (std::fwrite(bytes.data(), 1, bytes.size(), state_->file) != bytes.size()) {
    return fail(Error::Code::kOutOfRange, "{}: writing failed after {} bytes ({})",
                state_->part.string(), state_->written, std::strerror(errno));
  }
  state_->written += bytes.size();
  return {};
}

Result<void> AtomicFile::write(std::string_view text) {
  return write(std::as_bytes(std::span(text.data(), text.size())));
}

Result<void> AtomicFile::flush() {
  SCANFUSE_ASSERT(state_->file != nullptr);
  if (std::fflush(state_->file) == 0) return {};
  return fail(Error::Code::kOutOfRange, "{}: writing failed ({})", state_->part.string(),
              std::strerror(errno));
}

Result<void> AtomicFile::commit() {
  SCANFUSE_ASSERT(state_->file != nullptr);
  const bool flushed = std::fflush(state_->file) == 0;
  const int reason = errno;
  const bool closed = std::fclose(std::exchange(state_->file, nullptr)) == 0;
  std::error_code error;
  if (!flushed || !closed) {
    std::filesystem::remove(state_->part, error);
    return fail(Error::Code::kOutOfRange, "{}: writing failed ({})", state_->part.string(),
                std::strerror(reason));
  }
  std::filesystem::rename(state_->part, state_->path, error);
  if (!error) return {};
  const std::string why = error.message();
  std::filesystem::remove(state_->part, error);
  return fail(Error::Code::kOutOfRange, "{}: cannot be moved into place ({})",
              state_->path.string(), why);
}

Result<void> write_whole(const std::filesystem::path& path, std::string_view text) {
  auto file = AtomicFile::create(path);
  if (!file) return tl::unexpected(file.error());
  if (auto wrote = file->write(text); !wrote) return wrote;
  return file->commit();
}

}  // namespace scanfuse::io
