#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "scanfuse/core/result.hpp"
#include "scanfuse/io/mcap/byte_source.hpp"
#include "scanfuse/io/mcap/records.hpp"

namespace scanfuse::io::mcap {

/// What stands behind the data section: copies of schemas and channels, and where things are.
struct Summary {
  std::map<std::uint16_t, Schema> schemas;
  std::map<std::uint16_t, Channel> channels;
  std::optional<Statistics> statistics;
  std::vector<ChunkIndex> chunks;  ///< in order of offset, each once
  std::vector<AttachmentIndex> attachments;
  std::vector<MetadataIndex> metadata;
  std::uint64_t start = 0;  ///< offset of the first record of the summary; 0: there is none
};

/// How the end of a file was found.
struct FileEnd {
  bool has_footer = false;
  std::string problem;  ///< why a summary that should be there is not used; empty: none
  Summary summary;      ///< empty when there is none or it has a problem
};

/// Reads footer and summary. A missing footer or a damaged summary is an outcome, not an error.
[[nodiscard]] Result<FileEnd> read_file_end(ByteSource& source);

/// Whether the chunk indexes can be relied on: every chunk and every channel they name is there.
[[nodiscard]] bool index_is_usable(const Summary& summary);

}  // namespace scanfuse::io::mcap
