#pragma once

#include <filesystem>
#include <iosfwd>
#include <memory>
#include <string>
#include <vector>

#include "scanfuse/io/raw_message_source.hpp"

namespace scanfuse::io {

/// Opens a ROS 1 bag of version 2.0 (chunks plain, bz2 or lz4). Messages come in order of their
/// receipt times, over chunks that overlap in time as well; only chunks that overlap are held in
/// memory, and no more than about 512 MB of them (beyond that the order is given up, and noted).
/// `topics`: only these; empty: all.
///
/// A bag without a usable index (recording interrupted, file cut off) is searched chunk by chunk,
/// and what is whole is read; a damaged chunk is read as far as it goes. Both are counted as
/// damage. Bags of versions 1.x are an error that says how to convert them.
[[nodiscard]] Result<std::unique_ptr<RawMessageSource>> open_rosbag(
    const std::filesystem::path& path, const std::vector<std::string>& topics = {});

/// The same from a stream that can seek; `name` stands for it in messages.
[[nodiscard]] Result<std::unique_ptr<RawMessageSource>> open_rosbag(
    std::unique_ptr<std::istream> stream, const std::filesystem::path& name,
    const std::vector<std::string>& topics = {});

}  // namespace scanfuse::io
