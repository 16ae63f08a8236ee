#pragma once

#include <string>
#include <string_view>

#include "scanfuse/core/result.hpp"
#include "scanfuse/types/turntable.hpp"

namespace scanfuse::io {

/// Reads `features.json`, what a detector found in a session's images, into `features`: corners
/// (their number must be that of features.boards), stripe points and, where they are there, scans
/// of each position. features.positions must hold the session's positions; none of them may be
/// missing in the file. Errors name the file and the place in it ("positions[4]").
[[nodiscard]] Result<void> parse_features(std::string_view text, const std::string& name,
                                          TurntableFeatures& features);

/// Corners, stripe points and scans as text that reads back as the same.
[[nodiscard]] std::string features_text(const TurntableFeatures& features);

}  // namespace scanfuse::io
