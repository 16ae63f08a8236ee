#include "scanfuse/io/spool.hpp"

#include <unistd.h>
#include <zstd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <mutex>
#include <vector>

namespace scanfuse::io {

struct Spool::State {
  int file = -1;
  std::uint64_t end = 0;
  mutable std::mutex guard;  ///< of `end`, `packer` and `packed`

  ZSTD_CCtx* packer = ZSTD_createCCtx();
  std::vector<char> packed;

  State() = default;
  State(const State&) = delete;
  State& operator=(const State&) = delete;
  ~State() {
    if (file >= 0) close(file);
    ZSTD_freeCCtx(packer);
  }
};

namespace {

/// False with errno set when not all could be written.
bool write_all(int file, const char* bytes, std::size_t size, std::uint64_t offset) {
  while (size > 0) {
    const ssize_t done = pwrite(file, bytes, size, static_cast<off_t>(offset));
    if (done < 0 && errno == EINTR) continue;
    if (done <= 0) return false;
    bytes += done;
    offset += static_cast<std::uint64_t>(done);
    size -= static_cast<std::size_t>(done);
  }
  return true;
}

bool read_all(int file, char* bytes, std::size_t size, std::uint64_t offset) {
  while (size > 0) {
    const ssize_t done = pread(file, bytes, size, static_cast<off_t>(offset));
    if (done < 0 && errno == EINTR) continue;
    if (done <= 0) return false;
    bytes += done;
    offset += static_cast<std::uint64_t>(done);
    size -= static_cast<std::size_t>(done);
  }
  return true;
}

}  // namespace

Result<Spool> Spool::create() {
  const char* folder = std::getenv("TMPDIR");
  std::string name =
      std::string(folder != nullptr && *folder != '\0' ? folder : "/var/tmp") + "/scanfuse-XXXXXX";
  auto state = std::make_unique<State>();
  state->file = mkstemp(name.data());
  if (state->file < 0) {
    return fail(Error::Code::kNotFound, "{}: {}; set TMPDIR to a folder that can be written", name,
                std::strerror(errno));
  }
  unlink(name.c_str());
  return Spool(std::move(state));
}

Spool::Spool(std::unique_ptr<State> state) : state_(std::move(state)) {}
Spool::Spool(Spool&&) noexcept = default;
Spool& Spool::operator=(Spool&&) noexcept = default;
Spool::~Spool() = default;

Result<Spool::Place> Spool::put(std::span<const std::byte> bytes) {
  if (bytes.size() > std::numeric_limits<std::uint32_t>::max() / 2) {
    return fail(Error::Code::kOutOfRange, "a frame of {} bytes is too large to put aside",
                bytes.size());
  }
  const std::lock_guard lock(state_->guard);
  auto& packed = state_->packed;
  packed.resize(ZSTD_compressBound(bytes.size()));
  const std::size_t size = ZSTD_compressCCtx(state_->packer, packed.data(), packed.size(),
                                             bytes.data(), bytes.size(), 1);
  if (ZSTD_isError(size) != 0 || !write_all(state_->file, packed.data(), size, state_->end)) {
    return fail(Error::Code::kUnsupported,
                "cannot put a frame aside: {}; set TMPDIR to a folder with more room",
                std::strerror(errno));
  }
  const Place place{state_->end, static_cast<std::uint32_t>(size),
                    static_cast<std::uint32_t>(bytes.size())};
  state_->end += size;
  return place;
}

Result<Spool::Place> Spool::put(const std::string& bytes) {
  return put(std::as_bytes(std::span(bytes)));
}

Result<std::string> Spool::get(const Place& place) const {
  std::vector<char> packed(place.stored);
  std::string bytes(place.size, '\0');
  if (!read_all(state_->file, packed.data(), packed.size(), place.offset)) {
    return fail(Error::Code::kMalformed, "cannot read back a frame that was put aside");
  }
  const std::size_t size =
      ZSTD_decompress(bytes.data(), bytes.size(), packed.data(), packed.size());
  if (size != bytes.size()) {
    return fail(Error::Code::kMalformed, "a frame that was put aside came back damaged");
  }
  return bytes;
}

std::uint64_t Spool::bytes() const {
  const std::lock_guard lock(state_->guard);
  return state_->end;
}

}  // namespace scanfuse::io
