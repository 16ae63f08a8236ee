#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "scanfuse/core/result.hpp"
#include "scanfuse/types/image.hpp"

namespace scanfuse::io {

/// Larger images are refused.
inline constexpr std::uint64_t kMostPixels = std::uint64_t{1} << 28;

/// Bytes that start as a PNG or JPEG file does. `name` stands in error messages.
[[nodiscard]] Result<Image> parse_png(std::string_view bytes, const std::string& name);
[[nodiscard]] Result<Image> parse_jpeg(std::string_view bytes, const std::string& name);

}  // namespace scanfuse::io
