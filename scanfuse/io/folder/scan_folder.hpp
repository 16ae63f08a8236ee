#pragma once

#include <functional>
#include <vector>

#include "scanfuse/io/folder/stamps.hpp"
#include "scanfuse/io/recording.hpp"

namespace scanfuse::io {

/// A recording that holds one scan a file.
struct ScanFolder {
  std::filesystem::path path;
  std::string format;  ///< "pcd", "kitti"
  std::string topic;   ///< of the scans
  std::string type;
  std::string frame_id;
  std::vector<ScanFile> files;
  std::vector<PoseSample> poses;        ///< ascending; given out under `pose_topic`
  std::vector<TransformSample> mounts;  ///< given out first, under "/tf_static"
  std::string pose_topic;
  Diagnostics diagnostics;
  std::function<Result<Scan>(const std::filesystem::path&, Diagnostics&)> load;
};

/// Reads the files one at a time, poses between them by time. A file that cannot be read is counted
/// as damage and passed over; when none can, the error is that of the first.
[[nodiscard]] Result<std::unique_ptr<RecordingReader>> read_scan_folder(ScanFolder folder,
                                                                        const OpenOptions& options);

/// The bytes of one file; an error past 2 GiB.
[[nodiscard]] Result<std::string> read_small_file(const std::filesystem::path& path);

}  // namespace scanfuse::io
