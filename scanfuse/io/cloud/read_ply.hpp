#pragma once

#include <string>
#include <string_view>

#include "scanfuse/core/diagnostics.hpp"
#include "scanfuse/core/result.hpp"
#include "scanfuse/types/cloud.hpp"

namespace scanfuse::io {

[[nodiscard]] bool is_ply(std::string_view first_bytes);

/// The vertices of a PLY file; see cloud_file.hpp. Vertices behind an element with lists are
/// refused.
[[nodiscard]] Result<Cloud> parse_ply(std::string_view file, const std::string& name,
                                      Diagnostics& diagnostics);

}  // namespace scanfuse::io
