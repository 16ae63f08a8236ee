#pragma once

#include <cstdint>
#include <map>
#include <vector>

#include "scanfuse/core/diagnostics.hpp"
#include "scanfuse/io/rosbag/chunk.hpp"

namespace scanfuse::io::rosbag {

/// Where a chunk stands, and what it holds.
struct ChunkEntry {
  std::uint64_t offset = 0;
  Time start;
  Time end;
  std::map<std::uint32_t, std::int64_t> counts;  ///< messages by connection
};

/// What a bag holds: its chunks in order of their start, and its connections.
struct ChunkDirectory {
  std::vector<ChunkEntry> chunks;
  std::vector<Connection> connections;
  Diagnostics diagnostics;
};

/// From the index at the bag's end, or, where that is missing or wrong, by reading all chunks.
/// Fails if the file is no bag of version 2.0.
[[nodiscard]] Result<ChunkDirectory> read_directory(BagFile& file);

}  // namespace scanfuse::io::rosbag
