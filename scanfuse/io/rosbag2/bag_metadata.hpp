#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "scanfuse/core/result.hpp"

namespace scanfuse::io::rosbag2 {

/// What is needed of a bag's metadata.yaml; all else stands in the files themselves.
struct BagMetadata {
  std::vector<std::string> files;  ///< relative, in order of time
  std::string compression_format;  ///< "zstd" or empty
  std::string compression_mode;    ///< "file", "message" or empty, in lower case
};

/// Reads the block-style YAML that rosbag2 writes, not YAML at large. Keys it does not know are
/// passed over.
[[nodiscard]] BagMetadata parse_metadata(std::string_view yaml);

/// The bag's files that exist, in order: those of the metadata, else those of the folder with
/// numbers in their names in order of value. Empty if there are none.
struct BagFiles {
  std::vector<std::filesystem::path> paths;
  std::vector<std::string> missing;  ///< named by the metadata, but not there
  bool messages_compressed = false;
};
[[nodiscard]] Result<BagFiles> list_bag_files(const std::filesystem::path& folder);

}  // namespace scanfuse::io::rosbag2
