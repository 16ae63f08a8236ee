#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "scanfuse/core/diagnostics.hpp"
#include "scanfuse/io/mcap/compression.hpp"
#include "scanfuse/io/mcap/record_codec.hpp"
#include "scanfuse/io/mcap/record_reader.hpp"
#include "scanfuse/io/mcap/records.hpp"

namespace scanfuse::io::mcap {

/// The schemas and channels met so far, and which topics are wanted.
struct Directory {
  std::map<std::uint16_t, Schema> schemas;
  std::map<std::uint16_t, Channel> channels;
  std::vector<std::uint16_t> channel_order;  ///< ids in the order they were met
  std::set<std::string> wanted_topics;       ///< empty: all
  std::set<std::string> compressions;        ///< "none", "lz4", "zstd" as met

  void add(Schema schema);
  void add(Channel channel);
  [[nodiscard]] bool wants(std::uint16_t channel_id) const;
};

/// A decompressed chunk and its wanted messages in order of log time (ties: as they stand).
struct OpenChunk {
  std::uint64_t file_offset = 0;
  std::vector<std::byte> bytes;
  std::vector<MessageView> messages;  ///< into `bytes`
  std::size_t next = 0;
};

/// Opens chunk records. A chunk that fails its checksum or does not decompress is counted as damage
/// and gives nothing; a chunk that the end of the file cut off gives its complete records.
class ChunkLoader {
 public:
  explicit ChunkLoader(std::uint64_t max_chunk_bytes) : max_chunk_bytes_(max_chunk_bytes) {}

  [[nodiscard]] std::optional<OpenChunk> load(const RawRecord& record, Directory& directory,
                                              Diagnostics& diagnostics);

 private:
  [[nodiscard]] std::optional<std::vector<std::byte>> sound_bytes(const RawRecord& record,
                                                                  Directory& directory,
                                                                  Diagnostics& diagnostics);
  Decompressor decompressor_;
  std::uint64_t max_chunk_bytes_;
};

}  // namespace scanfuse::io::mcap
