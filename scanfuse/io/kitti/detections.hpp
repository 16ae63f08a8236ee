#pragma once

#include <filesystem>
#include <vector>

#include "scanfuse/io/tables.hpp"

namespace scanfuse::io {

/// Whether `path` is a file of KITTI boxes in any layout of box_line.hpp, or a folder of such files
/// in layout kObject, one a frame, named by its number (000000.txt).
[[nodiscard]] bool holds_kitti_boxes(const std::filesystem::path& path);

/// KITTI boxes as detections in the laser's frame, every frame from the first to the last one
/// named: one without a box saw nothing (gaps of over 100 frames stay gaps). Scores that leave
/// 0 .. 1 in any line are taken as log odds; a box without a score has 1. A detector tells no
/// deviations: 0.3 m in x and y, 0.2 rad, 0.5 m of length and 0.2 m of width are assumed. Broken
/// lines are skipped and counted as damage; no good line is an error that names the first bad one.
[[nodiscard]] Result<std::vector<DetectionFrame>> read_kitti_detections(
    const std::filesystem::path& path, const KittiOptions& options, Diagnostics& diagnostics);

}  // namespace scanfuse::io
