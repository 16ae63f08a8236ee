#include "scanfuse/io/text/unpack.hpp"

#include <lzma.h>
#include <zlib.h>

#include <array>
#include <cstdint>

namespace scanfuse::io {
namespace {

constexpr std::size_t kPackedBlock = 1 << 16;
constexpr std::uint64_t kXzMemory = 256ULL << 20;

/// Reads packed blocks and counts them, for both formats.
struct PackedInput {
  std::string name;
  std::unique_ptr<ByteSource> source;
  std::array<char, kPackedBlock> block{};
  std::uint64_t offset = 0;
  bool ended = false;

  Result<std::size_t> refill() {
    auto got = source->read(block);
    if (got) {
      offset += *got;
      ended = *got == 0;
    }
    return got;
  }
  [[nodiscard]] tl::unexpected<Error> broken(std::string_view kind, std::string_view what) const {
    return fail(Error::Code::kMalformed, "{}: {} data {} before byte {}", name, kind, what, offset);
  }
};

class GzipBytes final : public ByteSource {
 public:
  GzipBytes(std::string name, std::unique_ptr<ByteSource> packed) {
    input_.name = std::move(name);
    input_.source = std::move(packed);
    ready_ = inflateInit2(&stream_, 15 + 16) == Z_OK;
  }
  GzipBytes(const GzipBytes&) = delete;
  GzipBytes& operator=(const GzipBytes&) = delete;
  std::string_view packing() const override { return "gzip"; }
  ~GzipBytes() override {
    if (ready_) inflateEnd(&stream_);
  }

  Result<std::size_t> read(std::span<char> into) override {
    if (!ready_) return input_.broken("gzip", "cannot be unpacked");
    stream_.next_out = reinterpret_cast<Bytef*>(into.data());
    stream_.avail_out = static_cast<uInt>(into.size());
    while (stream_.avail_out == into.size()) {
      if (stream_.avail_in == 0 && !input_.ended) {
        const auto got = input_.refill();
        if (!got) return got;
        stream_.next_in = reinterpret_cast<Bytef*>(input_.block.data());
        stream_.avail_in = static_cast<uInt>(*got);
      }
      if (stream_.avail_in == 0 && input_.ended) {
        if (between_members_) return 0;
        return input_.broken("gzip", "cut off");
      }
      if (const auto outcome = step(); !outcome) return tl::unexpected(outcome.error());
    }
    return into.size() - stream_.avail_out;
  }

 private:
  Result<void> step() {
    if (between_members_) {
      inflateReset(&stream_);
      between_members_ = false;
    }
    const int outcome = inflate(&stream_, Z_NO_FLUSH);
    if (outcome == Z_STREAM_END) {
      between_members_ = true;
      ++members_;
      return {};
    }
    if (outcome == Z_OK || outcome == Z_BUF_ERROR) return {};
    return input_.broken("gzip", "damaged");
  }

  PackedInput input_;
  z_stream stream_{};
  bool ready_ = false;
  bool between_members_ = false;
  int members_ = 0;
};

class XzBytes final : public ByteSource {
 public:
  XzBytes(std::string name, std::unique_ptr<ByteSource> packed) {
    input_.name = std::move(name);
    input_.source = std::move(packed);
    ready_ = lzma_stream_decoder(&stream_, kXzMemory, LZMA_CONCATENATED) == LZMA_OK;
  }
  XzBytes(const XzBytes&) = delete;
  XzBytes& operator=(const XzBytes&) = delete;
  std::string_view packing() const override { return "xz"; }
  ~XzBytes() override { lzma_end(&stream_); }

  Result<std::size_t> read(std::span<char> into) override {
    if (!ready_) return input_.broken("xz", "cannot be unpacked");
    stream_.next_out = reinterpret_cast<std::uint8_t*>(into.data());
    stream_.avail_out = into.size();
    while (stream_.avail_out == into.size() && !finished_) {
      if (stream_.avail_in == 0 && !input_.ended) {
        const auto got = input_.refill();
        if (!got) return got;
        stream_.next_in = reinterpret_cast<const std::uint8_t*>(input_.block.data());
        stream_.avail_in = *got;
      }
      switch (lzma_code(&stream_, input_.ended ? LZMA_FINISH : LZMA_RUN)) {
        case LZMA_OK:
          break;
        case LZMA_STREAM_END:
          finished_ = true;
          break;
        case LZMA_BUF_ERROR:
          return input_.broken("xz", "cut off");
        case LZMA_MEMLIMIT_ERROR:
          return input_.broken("xz", "needs more than 256 MiB to unpack");
        default:
          return input_.broken("xz", "damaged");
      }
    }
    return into.size() - stream_.avail_out;
  }

 private:
  PackedInput input_;
  lzma_stream stream_ = LZMA_STREAM_INIT;
  bool ready_ = false;
  bool finished_ = false;
};

}  // namespace

std::unique_ptr<ByteSource> unpack_gzip(std::string name, std::unique_ptr<ByteSource> packed) {
  return std::make_unique<GzipBytes>(std::move(name), std::move(packed));
}

std::unique_ptr<ByteSource> unpack_xz(std::string name, std::unique_ptr<ByteSource> packed) {
  return std::make_unique<XzBytes>(std::move(name), std::move(packed));
}

}  // namespace scanfuse::io
