#include <bzlib.h>
#include <lz4frame.h>

#include <algorithm>
#include <memory>
#include <utility>

#include "scanfuse/io/rosbag/chunk.hpp"

namespace scanfuse::io::rosbag {

namespace {

constexpr std::size_t kLargestChunk = std::size_t{1} << 30;
constexpr std::size_t kGrowth = std::size_t{1} << 20;

/// Makes room for more output, in steps: the size that a damaged header claims is not to be
/// trusted. False when the chunk is full.
bool grow(std::vector<std::byte>& bytes, std::size_t filled, std::size_t limit) {
  if (filled >= limit) return false;
  bytes.resize(std::min(limit, filled + std::max(kGrowth, filled)));
  return true;
}

void settle(Unpacked& out, std::size_t filled, std::size_t size) {
  out.bytes.resize(filled);
  if (out.problem.empty() && filled != size) {
    out.problem = fmt::format("the chunk unpacks to {} bytes, not {}", filled, size);
  }
}

Unpacked unpack_bz2(std::vector<std::byte> packed, std::size_t size) {
  Unpacked out;
  bz_stream stream{};
  if (BZ2_bzDecompressInit(&stream, 0, 0) != BZ_OK) return {{}, "no memory for bz2"};
  stream.next_in = reinterpret_cast<char*>(packed.data());
  stream.avail_in = static_cast<unsigned>(packed.size());
  std::size_t filled = 0;
  int state = BZ_OK;
  while (state == BZ_OK && grow(out.bytes, filled, size)) {
    stream.next_out = reinterpret_cast<char*>(out.bytes.data() + filled);
    stream.avail_out = static_cast<unsigned>(out.bytes.size() - filled);
    const auto room = stream.avail_out;
    state = BZ2_bzDecompress(&stream);
    filled += room - stream.avail_out;
    if (stream.avail_in == 0 && stream.avail_out != 0) break;  // all of the input is used up
  }
  BZ2_bzDecompressEnd(&stream);
  if (state < 0) out.problem = fmt::format("bz2 data are damaged (code {})", state);
  settle(out, filled, size);
  return out;
}

Unpacked unpack_lz4(const std::vector<std::byte>& packed, std::size_t size) {
  LZ4F_dctx* raw_context = nullptr;
  if (LZ4F_isError(LZ4F_createDecompressionContext(&raw_context, LZ4F_VERSION)) != 0) {
    return {{}, "no memory for lz4"};
  }
  const std::unique_ptr<LZ4F_dctx, decltype(&LZ4F_freeDecompressionContext)> context(
      raw_context, &LZ4F_freeDecompressionContext);
  Unpacked out;
  std::size_t used = 0, filled = 0;
  while (used < packed.size() && grow(out.bytes, filled, size)) {
    std::size_t take = packed.size() - used, room = out.bytes.size() - filled;
    const std::size_t state = LZ4F_decompress(context.get(), out.bytes.data() + filled, &room,
                                              packed.data() + used, &take, nullptr);
    if (LZ4F_isError(state) != 0) {
      out.problem = fmt::format("lz4 data are damaged ({})", LZ4F_getErrorName(state));
      break;
    }
    used += take;
    filled += room;
    if (state == 0 || (take == 0 && room == 0)) break;
  }
  settle(out, filled, size);
  return out;
}

}  // namespace

Unpacked unpack(const std::string& compression, std::vector<std::byte> packed, std::uint32_t size) {
  if (size > kLargestChunk) return {{}, fmt::format("a chunk of {} bytes is not believed", size)};
  if (compression == "bz2") return unpack_bz2(std::move(packed), size);
  if (compression == "lz4") return unpack_lz4(packed, size);
  if (compression == "none") return {std::move(packed), {}};
  return {{}, fmt::format("unknown chunk compression '{}'", compression)};
}

}  // namespace scanfuse::io::rosbag
