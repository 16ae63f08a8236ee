#pragma once

#include <filesystem>
#include <vector>

#include "scanfuse/core/diagnostics.hpp"
#include "scanfuse/core/result.hpp"
#include "scanfuse/geometry/pose.hpp"
#include "scanfuse/io/text/line_reader.hpp"
#include "scanfuse/types/truth.hpp"

namespace scanfuse::io {

/// KITTI's tracking labels (box_line.hpp) as truth in the "ego" frame, which is the laser's; frames
/// are 0.1 s apart, DontCare is passed over. Car, Van and Truck are vehicles, sitting persons
/// pedestrians, trams and the rest other. Broken lines are skipped and counted as damage.
[[nodiscard]] Result<std::vector<TruthFrame>> read_kitti_labels(LineReader lines,
                                                                const Pose3& laser_from_camera,
                                                                Diagnostics& diagnostics);

/// The same from a file, with the calibration that lies beside it (camera.hpp).
[[nodiscard]] Result<std::vector<TruthFrame>> read_kitti_labels(const std::filesystem::path& path,
                                                                Diagnostics& diagnostics);

}  // namespace scanfuse::io
