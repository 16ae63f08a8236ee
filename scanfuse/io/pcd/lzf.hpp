#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace scanfuse::io {

/// Unpacks LZF, as PCD's binary_compressed uses it. A control byte c < 32 is followed by c + 1
/// bytes to copy; else it repeats (c >> 5) + 2 bytes (7: one more length byte follows and is added)
/// from
/// ((c & 31) << 8 | next byte) + 1 back. Nothing where the data is damaged or does not give exactly
/// `size` bytes.
[[nodiscard]] std::optional<std::vector<char>> unpack_lzf(std::string_view packed,
                                                          std::size_t size);

}  // namespace scanfuse::io
