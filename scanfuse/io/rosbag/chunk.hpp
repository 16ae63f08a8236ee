#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "scanfuse/core/time.hpp"
#include "scanfuse/io/rosbag/bag_record.hpp"

namespace scanfuse::io::rosbag {

struct Connection {
  std::uint32_t id = 0;
  std::string topic;
  std::string type;
  std::string definition;
};

/// The connection that a connection record describes.
[[nodiscard]] Result<Connection> read_connection(const RecordFields& fields,
                                                 std::span<const std::byte> data);

/// A message within its chunk's bytes.
struct ChunkMessage {
  std::uint32_t connection = 0;
  Time time;
  std::size_t begin = 0;
  std::size_t bytes = 0;
};

/// A chunk, unpacked and sorted by time. Where it is damaged, it holds what stands before the
/// damage.
struct Chunk {
  std::vector<std::byte> bytes;
  std::vector<ChunkMessage> messages;
  std::vector<Connection> connections;
  std::string problem;  ///< empty: all of it was read
};

/// Reads the chunk at `offset`. Fails only if there is no chunk.
[[nodiscard]] Result<Chunk> read_chunk(BagFile& file, std::uint64_t offset);

/// Unpacked bytes, and what was wrong with them.
struct Unpacked {
  std::vector<std::byte> bytes;
  std::string problem;
};

/// `compression` is "none", "bz2" or "lz4"; at most `size` bytes come out.
[[nodiscard]] Unpacked unpack(const std::string& compression, std::vector<std::byte> packed,
                              std::uint32_t size);

}  // namespace scanfuse::io::rosbag
