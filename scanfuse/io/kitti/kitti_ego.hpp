#pragma once

#include <filesystem>
#include <vector>

#include "scanfuse/core/diagnostics.hpp"
#include "scanfuse/core/result.hpp"
#include "scanfuse/io/folder/stamps.hpp"
#include "scanfuse/types/ego.hpp"

namespace scanfuse::io {

/// The poses of the imu beside a folder of scans; empty where no oxts file or folder is found. A
/// packet without a stamp of its own has that of the scan with its number.
[[nodiscard]] std::vector<PoseSample> read_kitti_poses(const std::filesystem::path& scan_folder,
                                                       const std::vector<ScanFile>& scans,
                                                       Diagnostics& diagnostics);

/// Where the lidar sits on the imu: from calib_imu_to_velo.txt (R and T, velodyne_from_imu) or the
/// Tr_imu_velo of calib.txt in one of the folders around the scans, else the nominal mounting of
/// [Geiger2013], 0.81 m ahead, 0.32 m right, 0.80 m above.
[[nodiscard]] Pose3 read_kitti_mount(const std::filesystem::path& scan_folder,
                                     Diagnostics& diagnostics);

}  // namespace scanfuse::io
