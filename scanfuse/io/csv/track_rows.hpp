#pragma once

#include <array>
#include <string>
#include <string_view>

#include "scanfuse/types/track.hpp"

namespace scanfuse::io {

/// The columns of a track row, in the order in which they are written.
inline constexpr std::array<std::string_view, 24> kTrackColumns = {"time_s",
                                                                   "frame",
                                                                   "track_id",
                                                                   "class",
                                                                   "class_probability",
                                                                   "status",
                                                                   "x_m",
                                                                   "y_m",
                                                                   "z_m",
                                                                   "heading_rad",
                                                                   "vx_m_per_s",
                                                                   "vy_m_per_s",
                                                                   "speed_m_per_s",
                                                                   "accel_m_per_s2",
                                                                   "yaw_rate_rad_per_s",
                                                                   "length_m",
                                                                   "width_m",
                                                                   "height_m",
                                                                   "var_x_m2",
                                                                   "cov_xy_m2",
                                                                   "var_y_m2",
                                                                   "age_frames",
                                                                   "missed_frames",
                                                                   "moving_probability"};

[[nodiscard]] std::string track_header();
/// A row per track of the step, each with its line end.
[[nodiscard]] std::string track_csv_rows(const StepResult& step);
/// The same rows as JSON objects, one a line. Numbers that are not finite become null.
[[nodiscard]] std::string track_json_rows(const StepResult& step);

}  // namespace scanfuse::io
