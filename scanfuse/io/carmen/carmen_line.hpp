#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "scanfuse/core/result.hpp"
#include "scanfuse/core/time.hpp"
#include "scanfuse/geometry/pose.hpp"

namespace scanfuse::io {

/// One scan line of a CARMEN log as it stands, angles in radians.
struct CarmenScan {
  std::string keyword;
  double first_azimuth_rad = 0;
  double step_rad = 0;
  double max_range_m = 0;  ///< readings from here on mean "no return"
  std::vector<float> ranges_m;
  std::vector<float> remissions;  ///< as many as ranges, or none
  std::optional<Pose2> world_from_laser;
  std::optional<Pose2> world_from_robot;
  Time stamp;
};

struct CarmenOdometry {
  Pose2 world_from_robot;
  double speed_m_per_s = 0;
  double yaw_rate_rad_per_s = 0;
  Time stamp;
};

[[nodiscard]] bool is_carmen_scan(std::string_view keyword);

/// Take a line apart; the error says which field is at fault, without the place.
[[nodiscard]] Result<CarmenScan> parse_carmen_scan(std::string_view line);
[[nodiscard]] Result<CarmenOdometry> parse_carmen_odometry(std::string_view line);

}  // namespace scanfuse::io
