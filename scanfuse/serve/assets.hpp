#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string_view>

namespace scanfuse::serve {

/// A file of the page, built into the library.
struct Asset {
  std::string_view content_type;
  std::span<const std::byte> gzip;  ///< its content, packed
};

/// By path ("/", "/viewer.js"); nothing for every other path. There is no folder behind it: a path
/// is looked up in a list, never opened.
[[nodiscard]] std::optional<Asset> find_asset(std::string_view path);

}  // namespace scanfuse::serve
