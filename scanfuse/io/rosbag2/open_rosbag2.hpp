#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "scanfuse/io/raw_message_source.hpp"

namespace scanfuse::io {

/// Opens a ROS 2 bag: a folder with or without its metadata.yaml, or one `.db3` file. The files of
/// a split bag are read one after the other; within a `.db3` messages come in order of time.
/// `.mcap` files within a folder are read as MCAP. `topics`: only these; empty: all.
///
/// Nothing is written, locked or created beside the bag: folders may be read-only. Compression by
/// message (zstd) is undone as messages come, compression by file (`.db3.zstd`, `.mcap.zstd`) in
/// memory. A split file that is missing or unreadable is counted as damage as long as one is left.
[[nodiscard]] Result<std::unique_ptr<RawMessageSource>> open_rosbag2(
    const std::filesystem::path& path, const std::vector<std::string>& topics = {});

}  // namespace scanfuse::io
