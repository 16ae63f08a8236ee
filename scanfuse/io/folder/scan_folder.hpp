#pragma once

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
  /// A scan from the bytes of a file of this name.
  Result<Scan> (*read)(std::string_view bytes, const std::string& name, Diagnostics&) = nullptr;
};

/// Reads the files one at a time, poses between them by time. A file that cannot be read, or is
/// past 2 GiB, is counted as damage and passed over; when none can, the error is that of the first.
[[nodiscard]] Result<std::unique_ptr<RecordingReader>> read_scan_folder(ScanFolder folder,
                                                                        const OpenOptions& options);

}  // namespace scanfuse::io
