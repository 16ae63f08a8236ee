#pragma once

#include <string>

#include "scanfuse/report/turntable_report.hpp"

namespace scanfuse::report {

/// Errors of points are told for this distance from the lidar.
inline constexpr double kBandRange_m = 1.5;

/// What the view in space draws, as JSON for turntable_viewer.js: lines and points with a colour
/// variable and a label. No `<` in it.
[[nodiscard]] std::string turntable_scene_json(const TurntableReport& report);

/// The error of a point at 1.5 m over the turntable's angle on a logarithmic scale, the calibrated
/// arc shaded: an <svg>.
[[nodiscard]] std::string error_band_chart(const TurntableReport& report);

/// Pictures with what was found in them, a figure a position.
[[nodiscard]] std::string position_pictures(const TurntableReport& report);

}  // namespace scanfuse::report
