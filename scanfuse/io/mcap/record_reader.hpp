#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "scanfuse/core/result.hpp"
#include "scanfuse/io/mcap/byte_source.hpp"
#include "scanfuse/io/mcap/records.hpp"

namespace scanfuse::io::mcap {

/// One record as it stands in the file. Unknown opcodes are passed on; skip them.
struct RawRecord {
  std::uint8_t opcode = 0;
  std::uint64_t offset = 0;            ///< of its head, from the start of the file (or buffer)
  std::span<const std::byte> content;  ///< valid until the next call
  bool complete = true;  ///< false: the file ends inside the record; `content` is what there is
  bool skipped = false;  ///< longer than the limit; `content` is empty

  [[nodiscard]] bool is(Opcode code) const { return opcode == static_cast<std::uint8_t>(code); }
};

/// Walks over the records of a file between two offsets, one at a time. Chunks are handed out as
/// they are; `ChunkRecords` walks over their content.
class RecordReader {
 public:
  /// A longer record is stepped over, not loaded.
  static constexpr std::uint64_t kMaxRecordBytes = std::uint64_t{1} << 30;

  RecordReader(ByteSource& source, std::uint64_t begin, std::uint64_t end)
      : source_(&source), offset_(begin), end_(end) {}

  /// The next record; nothing at the end, which includes fewer than 9 bytes left over.
  [[nodiscard]] Result<std::optional<RawRecord>> next();
  /// Where the next record starts.
  [[nodiscard]] std::uint64_t offset() const { return offset_; }
  /// From here on, keeps the checksum of what is read, continuing `seed`.
  void start_crc(std::uint32_t seed);
  /// Of everything before the latest record; nothing when not started, or after a skipped record.
  [[nodiscard]] std::optional<std::uint32_t> crc_before_latest() const;

 private:
  void advance_crc(std::span<const std::byte> head);

  ByteSource* source_;
  std::uint64_t offset_;
  std::uint64_t end_;
  std::vector<std::byte> content_;
  bool crc_wanted_ = false;
  std::uint32_t crc_ = 0;
  std::uint32_t crc_before_ = 0;
};

/// Walks over the records in the uncompressed bytes of a chunk, as far as they are whole.
class ChunkRecords {
 public:
  explicit ChunkRecords(std::span<const std::byte> bytes) : bytes_(bytes) {}
  [[nodiscard]] std::optional<RawRecord> next();
  /// After the last record: nothing is left over.
  [[nodiscard]] bool ended_well() const { return place_ == bytes_.size(); }

 private:
  std::span<const std::byte> bytes_;
  std::size_t place_ = 0;
};

}  // namespace scanfuse::io::mcap
