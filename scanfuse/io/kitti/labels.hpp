#pragma once

#include <filesystem>
#include <optional>
#include <string_view>
#include <vector>

#include "scanfuse/core/diagnostics.hpp"
#include "scanfuse/core/result.hpp"
#include "scanfuse/geometry/pose.hpp"
#include "scanfuse/io/text/line_reader.hpp"
#include "scanfuse/types/truth.hpp"

namespace scanfuse::io {

/// Whether a line is one of KITTI's tracking labels: `frame track type truncated occluded alpha
/// left top right bottom height width length x y z rotation_y [score]` [Geiger2013].
[[nodiscard]] bool is_kitti_label(std::string_view line);

/// The laser's frame from that of the rectified camera, in which labels stand: the inverse of
/// R_rect Tr_velo_cam of a calibration file. Nothing where the file lacks either.
[[nodiscard]] std::optional<Pose3> laser_from_camera(LineReader calibration,
                                                     Diagnostics& diagnostics);

/// Labels as truth in the "ego" frame, which is the laser's; frames are 0.1 s apart, DontCare is
/// passed over. Car, Van and Truck are vehicles, sitting persons pedestrians, trams and the rest
/// other. Broken lines are skipped and counted as damage.
[[nodiscard]] Result<std::vector<TruthFrame>> read_kitti_labels(LineReader lines,
                                                                const Pose3& laser_from_camera,
                                                                Diagnostics& diagnostics);

/// The same from a file. The calibration is looked for as `calib.txt` and `calib_NAME` beside it
/// and as `../calib/NAME`; without one, the camera is taken to look along the laser's x axis from
/// 0.27 m before and 0.08 m under it, as KITTI's does, and that is noted.
[[nodiscard]] Result<std::vector<TruthFrame>> read_kitti_labels(const std::filesystem::path& path,
                                                                Diagnostics& diagnostics);

}  // namespace scanfuse::io
