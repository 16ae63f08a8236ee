#pragma once

#include <filesystem>
#include <optional>

#include "scanfuse/core/diagnostics.hpp"
#include "scanfuse/core/result.hpp"
#include "scanfuse/geometry/pose.hpp"
#include "scanfuse/io/text/line_reader.hpp"

/// Where KITTI's camera sits, in whose frame (x right, y down, z forward) its boxes stand.
namespace scanfuse::io {

/// The laser's frame from that of the rectified camera: the inverse of R_rect Tr_velo_cam (or
/// R0_rect Tr_velo_to_cam) of a calibration file. Nothing where the file lacks either.
[[nodiscard]] std::optional<Pose3> laser_from_camera(LineReader calibration,
                                                     Diagnostics& diagnostics);

/// The same from the file `calibration`, or an error; where that is empty, from `calib.txt` or
/// `calib_NAME` beside the file `boxes` or `../calib/NAME`. Without one, the camera is taken to
/// look along the laser's x axis (x = z_cam + 0.27 m, y = -x_cam, z = -y_cam - 0.08 m), as KITTI's
/// does, and that is noted.
[[nodiscard]] Result<Pose3> laser_from_camera_for(const std::filesystem::path& boxes,
                                                  const std::filesystem::path& calibration,
                                                  Diagnostics& diagnostics);

}  // namespace scanfuse::io
