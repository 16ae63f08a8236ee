#include "scanfuse/io/pcd/lzf.hpp"

#include <cstdint>

namespace scanfuse::io {

std::optional<std::vector<char>> unpack_lzf(std::string_view packed, std::size_t size) {
  // Three bytes give at most 264: a larger size cannot be right, and is not to be allocated.
  if (size / 88 > packed.size() + 1) return std::nullopt;
  std::vector<char> out;
  out.reserve(size);
  std::size_t i = 0;
  const auto byte = [&](std::size_t place) { return static_cast<std::uint8_t>(packed[place]); };
  while (i < packed.size()) {
    const std::size_t control = byte(i++);
    if (control < 32) {
      const std::size_t count = control + 1;
      if (packed.size() - i < count || size - out.size() < count) return std::nullopt;
      out.insert(out.end(), packed.begin() + static_cast<std::ptrdiff_t>(i),
                 packed.begin() + static_cast<std::ptrdiff_t>(i + count));
      i += count;
      continue;
    }
    std::size_t count = (control >> 5) + 2;
    if (packed.size() - i < (count == 9 ? 2U : 1U)) return std::nullopt;
    if (count == 9) count += byte(i++);
    const std::size_t back = ((control & 31) << 8 | byte(i++)) + 1;
    if (back > out.size() || size - out.size() < count) return std::nullopt;
    for (std::size_t k = 0; k < count; ++k) out.push_back(out[out.size() - back]);
  }
  if (out.size() != size) return std::nullopt;
  return out;
}

}  // namespace scanfuse::io
