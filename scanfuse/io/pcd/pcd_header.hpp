#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "scanfuse/core/result.hpp"

namespace scanfuse::io {

/// One column of a PCD file: `count` values of `size` bytes; `type` is 'F', 'I' or 'U'.
struct PcdField {
  std::string name;
  std::size_t size = 4;
  char type = 'F';
  std::size_t count = 1;
  std::size_t offset = 0;  ///< in a point, bytes
  std::size_t column = 0;  ///< in a line of text
};

struct PcdHeader {
  enum class Encoding { kAscii, kBinary, kBinaryCompressed };
  std::vector<PcdField> fields;
  std::size_t points = 0;
  std::size_t point_bytes = 0;
  std::size_t point_values = 0;
  Encoding encoding = Encoding::kAscii;
  bool moved_viewpoint = false;  ///< VIEWPOINT is not the identity
  std::size_t data_offset = 0;   ///< first byte of the points
  std::int64_t data_line = 0;    ///< line of the DATA entry

  [[nodiscard]] const PcdField* find(std::string_view name) const;
};

/// Whether a file starts like a PCD.
[[nodiscard]] bool is_pcd(std::string_view first_bytes);

/// Reads the header; errors name the line: "scan.pcd:9: FIELDS names 4 columns, SIZE 3".
[[nodiscard]] Result<PcdHeader> parse_pcd_header(std::string_view file, const std::string& name);

}  // namespace scanfuse::io
