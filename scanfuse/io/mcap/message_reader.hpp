#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "scanfuse/core/diagnostics.hpp"
#include "scanfuse/core/result.hpp"
#include "scanfuse/io/mcap/byte_source.hpp"
#include "scanfuse/io/mcap/chunk_loader.hpp"
#include "scanfuse/io/mcap/record_codec.hpp"
#include "scanfuse/io/mcap/summary.hpp"

namespace scanfuse::io::mcap {

struct ReaderOptions {
  std::vector<std::string> topics;   ///< only these; empty: all
  std::size_t max_open_chunks = 32;  ///< held at once where chunks overlap in time
  std::uint64_t max_chunk_bytes = std::uint64_t{1} << 30;  ///< uncompressed; longer: damage
};

/// Reads the messages of an MCAP file [Mcap2023] front to back.
///
/// With a sound chunk index: in order of log time, ties by place in the file, merging chunks whose
/// times overlap. More overlapping chunks than `max_open_chunks` are merged only that far, and
/// noted. Without an index: in file order, each chunk sorted by itself.
///
/// Damage is counted in `diagnostics()` and skipped: a chunk that fails its checksum (with its byte
/// offset), a file that ends early (its complete records are given, also those of a cut-off chunk).
class MessageReader {
 public:
  [[nodiscard]] static Result<MessageReader> open(std::unique_ptr<ByteSource> source,
                                                  const ReaderOptions& options = {});

  /// The next message, its data valid until the next call; nothing at the end.
  [[nodiscard]] Result<std::optional<MessageView>> next();
  /// Back to the first message. Keeps the schemas and channels met, forgets what was counted.
  void rewind();

  /// Grows while reading when there is no index.
  [[nodiscard]] const Directory& directory() const { return directory_; }
  [[nodiscard]] const Diagnostics& diagnostics() const { return diagnostics_; }
  [[nodiscard]] const Summary& summary() const { return end_.summary; }
  [[nodiscard]] bool indexed() const { return indexed_; }
  /// How far into the file reading has come, without an index.
  [[nodiscard]] std::uint64_t position() const { return records_.offset(); }
  [[nodiscard]] const std::string& name() const { return source_->name(); }

 private:
  MessageReader(std::unique_ptr<ByteSource> source, const ReaderOptions& options, FileEnd end);

  [[nodiscard]] Result<std::optional<MessageView>> next_indexed();
  [[nodiscard]] Result<std::optional<MessageView>> next_linear();
  [[nodiscard]] Result<void> open_next_chunk();
  [[nodiscard]] bool chunk_is_wanted(const ChunkIndex& index) const;
  [[nodiscard]] std::optional<MessageView> take_from_open_chunks();
  /// A message outside of chunks, or nothing when the record was something else.
  [[nodiscard]] std::optional<MessageView> take(const RawRecord& record);
  void keep_checked(const RawRecord& record);
  void check_counts();

  std::unique_ptr<ByteSource> source_;
  ReaderOptions options_;
  FileEnd end_;
  bool indexed_ = false;
  Directory directory_;
  Diagnostics at_open_;
  Diagnostics diagnostics_;
  ChunkLoader loader_;
  RecordReader records_;
  std::vector<ChunkIndex> by_time_;
  std::size_t next_chunk_ = 0;
  std::vector<OpenChunk> open_;
  bool ended_ = false;
  std::uint64_t last_time_ = 0;
  std::uint64_t given_ = 0;
};

}  // namespace scanfuse::io::mcap
