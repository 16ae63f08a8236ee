#pragma once

#include "scanfuse/io/recording.hpp"

namespace scanfuse::io {

/// KITTI's lidar files: float32 x, y, z (m, lidar frame: x forward, y left, z up) and reflectance
/// in 0..1 per return. A number that is not finite drops its return, bytes beyond the last whole
/// return are damage.
///
/// The files hold no laser index. The layer, 0 the lowest of 64, is derived from the elevation by
/// the nominal beam angles of the HDL-64E (32 of 1/3 degree from 2 degrees down, 32 of 1/2 degree
/// below -8.83): right to about a layer.
[[nodiscard]] Result<Scan> read_kitti_bin(std::string_view bytes, const std::string& name,
                                          Diagnostics& diagnostics);

/// The folder that holds the .bin files of `path`: itself, or its velodyne_points/data,
/// velodyne/data, velodyne or data; empty where there is none.
[[nodiscard]] std::filesystem::path kitti_scan_folder(const std::filesystem::path& path);

/// A folder of .bin files, a raw drive folder (velodyne_points/data, with timestamps.txt) or one
/// .bin file; without timestamps ten scans a second from 0. Topics: "/velodyne" and, where an oxts
/// file or folder stands in it or beside it (oxts/data/*.txt, oxts.txt, oxts/0000.txt for the scans
/// in velodyne/0000), "/oxts" with the poses of "imu" in a local east-north frame, and "/tf_static"
/// with the lidar on the imu: from calib_imu_to_velo.txt if it is there, else the nominal mounting.
[[nodiscard]] Result<std::unique_ptr<RecordingReader>> open_kitti(const std::filesystem::path& path,
                                                                  const OpenOptions& options);

}  // namespace scanfuse::io
