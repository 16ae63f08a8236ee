#pragma once

#include "scanfuse/io/recording.hpp"

namespace scanfuse::io {

/// One PCD file in memory as a scan without stamp: DATA ascii, binary or binary_compressed, any
/// layout of fields. Needs x and y; takes z, intensity (or reflectivity, i), ring (or layer, laser,
/// channel, profile) as the layer, beam, `t` (U 4: nanoseconds) or `time`, `time_offset` (F:
/// seconds) as the beam's time after the scan's. Points that are not finite are "no return" and
/// noted; bad lines and a cut end are damage. VIEWPOINT is not applied: points are taken as in the
/// sensor's frame.
[[nodiscard]] Result<Scan> read_pcd(std::string_view file, const std::string& name,
                                    Diagnostics& diagnostics);

/// A .pcd file, or a folder of them; stamps as in folder/stamps.hpp. One topic, "/points".
[[nodiscard]] Result<std::unique_ptr<RecordingReader>> open_pcd(const std::filesystem::path& path,
                                                                const OpenOptions& options);

}  // namespace scanfuse::io
