#pragma once

#include <string>

#include "scanfuse/core/result.hpp"
#include "scanfuse/io/document/document.hpp"
#include "scanfuse/types/camera.hpp"

namespace scanfuse::io {

/// Keys of a camera's table: width_px, height_px, fx_px, fy_px, cx_px, cy_px, k1, k2, p1, p2, k3;
/// the distortion is zero where it is left out.
[[nodiscard]] const std::vector<std::string>& camera_keys();
[[nodiscard]] Result<Camera> read_camera(const DocumentTable& table);
/// "fx_px = 2757.4\n..." without the table's head.
[[nodiscard]] std::string camera_text(const Camera& camera);

}  // namespace scanfuse::io
