#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "scanfuse/core/diagnostics.hpp"
#include "scanfuse/core/result.hpp"
#include "scanfuse/types/bearing.hpp"

/// Files of passive sensors. SI units and radians; positions in one frame in metres.
namespace scanfuse::io {

/// `sensors.toml`: one [[sensor]] each with `name`, `position_m = [x, y, z]` or `latitude_deg`,
/// `longitude_deg`, `height_m` (WGS 84; the frame is then east, north, up at the first sensor),
/// `orientation_rad = [yaw, pitch, roll]` against that frame (geodetic: against east, north, up at
/// the sensor itself), `sigma_azimuth_rad`, `sigma_elevation_rad` (left out: azimuth only),
/// `detection_probability`, `clutter_per_sr` (azimuth only: `clutter_per_rad`),
/// `field_of_view_azimuth_rad`, `field_of_view_elevation_rad`; and [scene] with `volume_m` and
/// `expected_targets`. Errors name line and column: unknown keys, figures out of range, a name
/// given twice, one sensor only, sensors all at one place.
[[nodiscard]] Result<PassiveScene> read_sensors(const std::filesystem::path& path);
[[nodiscard]] Result<PassiveScene> parse_sensors(std::string_view text, const std::string& name);
[[nodiscard]] Result<void> write_sensors(const std::filesystem::path& path,
                                         const PassiveScene& scene);

/// `scan,time_s,sensor,measurement,azimuth_rad,elevation_rad[,sigma_azimuth_rad,`
/// `sigma_elevation_rad,truth_target]`: `sensor` a name of the scene, elevation empty for azimuth
/// only; `truth_target` -1 for a false alarm. Scans ascend in the result. Rows that cannot be read,
/// name an unknown sensor, repeat a measurement or hold angles out of range (azimuth within a turn,
/// elevation within a quarter) are skipped and counted as damage.
[[nodiscard]] Result<std::vector<BearingScan>> read_bearings(const std::filesystem::path& path,
                                                             const PassiveScene& scene,
                                                             Diagnostics* diagnostics = nullptr);
[[nodiscard]] Result<void> write_bearings(const std::filesystem::path& path,
                                          std::span<const BearingScan> scans,
                                          const PassiveScene& scene);

/// `scan,time_s,target,x_m,y_m,z_m,cov_xx_m2,...,cov_zz_m2,existence_probability,chi2,sensors`, the
/// names of the sensors joined by '+'. Of one scan, for a writer that adds scan after scan.
[[nodiscard]] std::string fix_header();
[[nodiscard]] std::string fix_rows(const BearingScan& scan, std::span<const Fix> fixes,
                                   const PassiveScene& scene);

/// `scan,sensor,measurement,target,probability`: one row a bearing, target empty for clutter; how
/// probable that is.
[[nodiscard]] std::string assignment_header();
[[nodiscard]] std::string assignment_rows(const BearingScan& scan,
                                          std::span<const std::int64_t> target_of_bearing,
                                          std::span<const double> probability_of_bearing,
                                          const PassiveScene& scene);

}  // namespace scanfuse::io
