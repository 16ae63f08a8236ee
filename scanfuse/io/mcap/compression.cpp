#include "scanfuse/io/mcap/compression.hpp"

#include <lz4frame.h>
#include <zstd.h>

#include <algorithm>

namespace scanfuse::io::mcap {
namespace {

/// First guess of the output, doubled as the stream proves to hold more.
std::size_t first_output_size(std::size_t compressed, std::uint64_t announced) {
  return static_cast<std::size_t>(
      std::min<std::uint64_t>(announced, 16 * std::uint64_t{compressed} + 65536));
}

bool grow_output(std::vector<std::byte>& out, std::uint64_t announced) {
  if (out.size() >= announced) return false;
  out.resize(static_cast<std::size_t>(std::min<std::uint64_t>(announced, 2 * out.size() + 65536)));
  return true;
}

}  // namespace

struct Compressor::State {
  Compression kind;
  int level;
  ZSTD_CCtx* zstd = nullptr;
  ~State() { ZSTD_freeCCtx(zstd); }
};

Compressor::Compressor(Compression kind, int level)
    : state_(std::make_unique<State>(State{kind, level})) {
  if (kind == Compression::kZstd) state_->zstd = ZSTD_createCCtx();
}
Compressor::Compressor(Compressor&&) noexcept = default;
Compressor& Compressor::operator=(Compressor&&) noexcept = default;
Compressor::~Compressor() = default;

std::string_view Compressor::name() const {
  switch (state_->kind) {
    case Compression::kLz4:
      return "lz4";
    case Compression::kZstd:
      return "zstd";
    case Compression::kNone:
      break;
  }
  return "";
}

Result<std::vector<std::byte>> Compressor::compress(std::span<const std::byte> bytes) {
  if (state_->kind == Compression::kNone) {
    return std::vector<std::byte>(bytes.begin(), bytes.end());
  }
  std::vector<std::byte> out;
  std::size_t size = 0;
  bool failed = false;
  if (state_->kind == Compression::kZstd) {
    out.resize(ZSTD_compressBound(bytes.size()));
    size = ZSTD_compressCCtx(state_->zstd, out.data(), out.size(), bytes.data(), bytes.size(),
                             state_->level);
    failed = ZSTD_isError(size) != 0;
  } else {
    LZ4F_preferences_t preferences{};
    preferences.frameInfo.contentSize = bytes.size();
    out.resize(LZ4F_compressFrameBound(bytes.size(), &preferences));
    size = LZ4F_compressFrame(out.data(), out.size(), bytes.data(), bytes.size(), &preferences);
    failed = LZ4F_isError(size) != 0;
  }
  if (failed)
    return fail(Error::Code::kOutOfRange, "a chunk of {} bytes cannot be compressed", bytes.size());
  out.resize(size);
  return out;
}

struct Decompressor::State {
  ZSTD_DCtx* zstd = nullptr;
  LZ4F_dctx* lz4 = nullptr;
  ~State() {
    ZSTD_freeDCtx(zstd);
    LZ4F_freeDecompressionContext(lz4);
  }

  Decompressed from_zstd(std::span<const std::byte> bytes, std::uint64_t announced) {
    if (zstd == nullptr) zstd = ZSTD_createDCtx();
    ZSTD_DCtx_reset(zstd, ZSTD_reset_session_only);
    Decompressed result;
    result.bytes.resize(first_output_size(bytes.size(), announced));
    ZSTD_inBuffer in{bytes.data(), bytes.size(), 0};
    ZSTD_outBuffer out{result.bytes.data(), result.bytes.size(), 0};
    for (;;) {
      const std::size_t before_in = in.pos, before_out = out.pos;
      const std::size_t hint = ZSTD_decompressStream(zstd, &out, &in);
      if (ZSTD_isError(hint)) break;
      const bool input_done = in.pos == in.size;
      if (hint == 0 && input_done) {
        result.complete = out.pos == announced;
        break;
      }
      if (out.pos == out.size && grow_output(result.bytes, announced)) {
        out.dst = result.bytes.data();
        out.size = result.bytes.size();
      } else if (in.pos == before_in && out.pos == before_out) {
        break;  // starved of input, or more output than announced
      }
    }
    result.bytes.resize(out.pos);
    return result;
  }

  Decompressed from_lz4(std::span<const std::byte> bytes, std::uint64_t announced) {
    if (lz4 == nullptr && LZ4F_isError(LZ4F_createDecompressionContext(&lz4, LZ4F_VERSION))) {
      return {};
    }
    LZ4F_resetDecompressionContext(lz4);
    Decompressed result;
    result.bytes.resize(first_output_size(bytes.size(), announced));
    std::size_t read = 0, written = 0;
    for (;;) {
      std::size_t in_size = bytes.size() - read, out_size = result.bytes.size() - written;
      const std::size_t hint = LZ4F_decompress(lz4, result.bytes.data() + written, &out_size,
                                               bytes.data() + read, &in_size, nullptr);
      if (LZ4F_isError(hint)) break;
      read += in_size;
      written += out_size;
      if (hint == 0 && read == bytes.size()) {
        result.complete = written == announced;
        break;
      }
      const bool grown = written == result.bytes.size() && grow_output(result.bytes, announced);
      if (!grown && in_size == 0 && out_size == 0) break;
    }
    result.bytes.resize(written);
    return result;
  }
};

Decompressor::Decompressor() : state_(std::make_unique<State>()) {}
Decompressor::Decompressor(Decompressor&&) noexcept = default;
Decompressor& Decompressor::operator=(Decompressor&&) noexcept = default;
Decompressor::~Decompressor() = default;

Result<Decompressed> Decompressor::decompress(std::string_view name,
                                              std::span<const std::byte> bytes,
                                              std::uint64_t announced_size) {
  if (bytes.empty()) return Decompressed{{}, announced_size == 0};
  if (name == "zstd") return state_->from_zstd(bytes, announced_size);
  if (name == "lz4") return state_->from_lz4(bytes, announced_size);
  if (!name.empty() && name != "none") {
    return fail(Error::Code::kUnsupported, "compression '{}' is not one of none, lz4, zstd", name);
  }
  const std::size_t kept =
      static_cast<std::size_t>(std::min<std::uint64_t>(bytes.size(), announced_size));
  Decompressed result;
  result.bytes.assign(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(kept));
  result.complete = bytes.size() == announced_size;
  return result;
}

}  // namespace scanfuse::io::mcap
