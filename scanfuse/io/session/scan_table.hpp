#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "scanfuse/core/diagnostics.hpp"
#include "scanfuse/core/result.hpp"
#include "scanfuse/io/session/session_file.hpp"
#include "scanfuse/types/turntable.hpp"

namespace scanfuse::io {

/// One scan: a table `angle,range[,intensity]` in the units that the conventions name. Ranges that
/// are codes, not finite or out of the lidar's reach become NaN; angles that do not ascend are
/// sorted (noted once a file, unless the whole scan merely runs the other way).
///
/// An error where no range is left, where more than half of the ranges would be in reach if the
/// declared unit were another (millimetres declared as metres), and where angles exceed a full turn
/// (degrees declared as radians): it says which unit fits.
[[nodiscard]] Result<std::vector<BeamReturn>> read_scan_table(const std::filesystem::path& path,
                                                              const LidarConventions& lidar,
                                                              Diagnostics& diagnostics);
[[nodiscard]] Result<std::vector<BeamReturn>> parse_scan_table(const std::string& text,
                                                               const std::string& name,
                                                               const LidarConventions& lidar,
                                                               Diagnostics& diagnostics);

/// All scans of one file. A table `position,angle,range[,intensity]` gives the scan of each
/// position that it names; any other recording (MCAP, bag, CARMEN, CSV points) gives its scans in
/// order, metres and radians whatever the conventions say.
[[nodiscard]] Result<std::map<int, std::vector<BeamReturn>>> read_scan_recording(
    const std::filesystem::path& path, const LidarConventions& lidar, Diagnostics& diagnostics);

/// As read_scan_table reads it; ranges that are NaN are written as the first invalid code.
[[nodiscard]] std::string scan_table_text(const std::vector<BeamReturn>& scan,
                                          const LidarConventions& lidar);

}  // namespace scanfuse::io
