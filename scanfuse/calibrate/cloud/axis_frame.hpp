#pragma once

#include "scanfuse/types/cloud.hpp"

namespace scanfuse::calibrate {

/// The rig's own frame (CloudFrame::kAxis), seen from the camera: z along the axis, origin at the
/// foot of the lidar's centre on it, y along the lidar's z at turntable angle 0 as far as it is
/// perpendicular to the axis. Where it is parallel to the axis, y is the lidar's y instead.
[[nodiscard]] Pose3 axis_from_camera(const Rig& rig);

/// `frame` from the camera; the identity but for the axis frame.
[[nodiscard]] Pose3 frame_from_camera(const Rig& rig, CloudFrame frame);

}  // namespace scanfuse::calibrate
