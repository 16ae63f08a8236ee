#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "scanfuse/core/result.hpp"
#include "scanfuse/io/mcap/compression.hpp"
#include "scanfuse/io/mcap/record_codec.hpp"
#include "scanfuse/io/mcap/records.hpp"

namespace scanfuse::io::mcap {

/// Takes the bytes of a file from front to back.
class ByteSink {
 public:
  virtual ~ByteSink() = default;
  [[nodiscard]] virtual Result<void> write(std::span<const std::byte> bytes) = 0;
  /// From then on what was written outlives this process.
  [[nodiscard]] virtual Result<void> flush() { return {}; }
  [[nodiscard]] virtual Result<void> commit() = 0;
};

/// A file that appears when committed (AtomicFile).
[[nodiscard]] Result<std::unique_ptr<ByteSink>> sink_to_file(const std::filesystem::path& path);
/// Appends to `bytes`, which must outlive the sink.
[[nodiscard]] std::unique_ptr<ByteSink> sink_to_memory(std::vector<std::byte>& bytes);

/// What is written; the defaults are what a reader wants to find.
struct WriterOptions {
  std::string profile;
  std::string library = "scanfuse";
  Compression compression = Compression::kZstd;
  int level = 3;                        ///< of zstd
  std::uint64_t chunk_bytes = 1 << 20;  ///< a chunk is closed once it holds this many
  bool chunks = true;                   ///< false: messages stand in the data section
  bool message_index = true;
  bool chunk_index = true;
  bool statistics = true;
  bool repeated_schemas = true;  ///< in the summary
  bool repeated_channels = true;
  bool attachment_index = true;
  bool metadata_index = true;
  bool summary_offsets = true;
};

/// Writes an MCAP file [Mcap2023]. The same calls give the same bytes. After a failed call the
/// writer is of no further use; destroyed without `finish`, it leaves no file.
class Writer {
 public:
  [[nodiscard]] static Result<Writer> create(const std::filesystem::path& path,
                                             const WriterOptions& options = {});
  [[nodiscard]] static Result<Writer> create(std::unique_ptr<ByteSink> sink,
                                             const WriterOptions& options = {});

  /// Gives the schema its id, counted from 1.
  [[nodiscard]] Result<std::uint16_t> add_schema(Schema schema);
  /// Gives the channel its id, counted from 1. Its `schema_id` is 0 or of `add_schema`.
  [[nodiscard]] Result<std::uint16_t> add_channel(Channel channel);
  [[nodiscard]] Result<void> write(const MessageView& message);
  [[nodiscard]] Result<void> write(const Attachment& attachment);
  [[nodiscard]] Result<void> write(const Metadata& metadata);
  /// Closes the chunk and flushes the sink: should this process end now, a reader finds everything
  /// that was written so far.
  [[nodiscard]] Result<void> checkpoint();
  /// Writes the summary and commits the sink.
  [[nodiscard]] Result<void> finish();

 private:
  /// The chunk being filled.
  struct OpenChunk {
    std::vector<std::byte> records;
    std::uint64_t start = 0, end = 0;
    bool has_messages = false;
    std::map<std::uint16_t, MessageIndex> index;
  };

  Writer(std::unique_ptr<ByteSink> sink, const WriterOptions& options);
  [[nodiscard]] Result<void> flush(std::vector<std::byte>& bytes);
  template <class Record>
  [[nodiscard]] Result<void> write_data(const Record& record);
  [[nodiscard]] Result<void> close_chunk();
  [[nodiscard]] Result<ChunkIndex> write_chunk_record();
  [[nodiscard]] std::vector<std::byte> summary_bytes(Footer& footer) const;

  std::unique_ptr<ByteSink> sink_;
  WriterOptions options_;
  Compressor compressor_;
  std::uint64_t offset_ = 0;
  std::uint32_t crc_ = 0;
  OpenChunk chunk_;
  std::vector<Schema> schemas_;
  std::vector<Channel> channels_;
  std::vector<ChunkIndex> chunk_indexes_;
  std::vector<AttachmentIndex> attachment_indexes_;
  std::vector<MetadataIndex> metadata_indexes_;
  Statistics statistics_;
  std::vector<std::byte> scratch_;
};

}  // namespace scanfuse::io::mcap
