#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "scanfuse/core/diagnostics.hpp"
#include "scanfuse/core/result.hpp"
#include "scanfuse/types/cloud.hpp"

/// Clouds in files, PLY or PCD. The frame and the profiles stand in comments of the header, which
/// other programs pass over:
///
///   comment scanfuse frame camera
///   comment scanfuse profile 0 TURNTABLE_RAD X_M Y_M Z_M QW QX QY QZ
///
/// ("# scanfuse ..." in PCD). Points carry x, y, z in metres (double), intensity where any point
/// has one (float; NaN: none), profile and beam where the cloud has profiles (int).
namespace scanfuse::io {

/// Reads a PLY (ascii or binary little-endian; any other properties and elements are passed over)
/// or a PCD file, told apart by its first bytes. Points that are not finite are dropped and noted;
/// a cut end is damage. Errors name the file and the line or byte.
[[nodiscard]] Result<Cloud> read_cloud(const std::filesystem::path& path, Diagnostics& diagnostics);
[[nodiscard]] Result<Cloud> parse_cloud(std::string_view file, const std::string& name,
                                        Diagnostics& diagnostics);

/// Writes a binary PLY or PCD by the path's ending; an error for any other ending.
[[nodiscard]] Result<void> write_cloud(const std::filesystem::path& path, const Cloud& cloud);

[[nodiscard]] std::string ply_bytes(const Cloud& cloud);
[[nodiscard]] std::string pcd_bytes(const Cloud& cloud);

}  // namespace scanfuse::io
