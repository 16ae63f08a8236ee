#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "scanfuse/core/result.hpp"
#include "scanfuse/types/image.hpp"

namespace scanfuse::io {

/// Reads a PNG or JPEG file, told apart by its first bytes. Grey stays grey; palettes and grey of
/// fewer bits are spread to eight; an alpha channel is dropped.
///
/// Refused, each with a message that names the file and the remedy: 16 bits a channel (camera
/// counts often fill only 10 or 12 of them, so no scale can be guessed), CMYK, more than 2^28
/// pixels, damaged or cut files. A JPEG that libjpeg could only patch up counts as damaged.
[[nodiscard]] Result<Image> read_image(const std::filesystem::path& path);

/// The same from bytes in memory. `name` stands in error messages.
[[nodiscard]] Result<Image> parse_image(std::string_view bytes, const std::string& name);

/// The image as the bytes of a PNG file (grey or red-green-blue).
[[nodiscard]] Result<std::string> print_png(const Image& image);

/// Writes a PNG file, which appears under its name only when it is whole.
[[nodiscard]] Result<void> write_png(const std::filesystem::path& path, const Image& image);

}  // namespace scanfuse::io
