#include "scanfuse/io/mcap/record_reader.hpp"

#include <algorithm>
#include <array>

#include "scanfuse/io/mcap/bytes.hpp"
#include "scanfuse/io/mcap/record_codec.hpp"

namespace scanfuse::io::mcap {

void RecordReader::start_crc(std::uint32_t seed) {
  crc_wanted_ = true;
  crc_ = seed;
}

std::optional<std::uint32_t> RecordReader::crc_before_latest() const {
  if (!crc_wanted_) return std::nullopt;
  return crc_before_;
}

void RecordReader::advance_crc(std::span<const std::byte> head) {
  crc_before_ = crc_;
  if (crc_wanted_) crc_ = crc32(content_, crc32(head, crc_));
}

Result<std::optional<RawRecord>> RecordReader::next() {
  if (offset_ > end_ || end_ - offset_ < kRecordHeadSize) return std::nullopt;
  std::array<std::byte, kRecordHeadSize> head;
  if (auto done = source_->read(offset_, head); !done) return tl::unexpected(done.error());
  ByteCursor cursor(head);
  RawRecord record;
  record.opcode = cursor.number<std::uint8_t>();
  record.offset = offset_;
  const std::uint64_t length = cursor.number<std::uint64_t>();
  const std::uint64_t left = end_ - offset_ - kRecordHeadSize;
  const std::uint64_t available = std::min(length, left);
  const bool too_long = available > kMaxRecordBytes;
  record.complete = length <= left;
  record.skipped = too_long;
  if (too_long) crc_wanted_ = false;
  content_.resize(too_long ? 0 : static_cast<std::size_t>(available));
  if (auto done = source_->read(offset_ + kRecordHeadSize, content_); !done) {
    return tl::unexpected(done.error());
  }
  advance_crc(head);
  record.content = content_;
  offset_ += kRecordHeadSize + available;
  return record;
}

std::optional<RawRecord> ChunkRecords::next() {
  if (bytes_.size() - place_ < kRecordHeadSize) return std::nullopt;
  ByteCursor cursor(bytes_.subspan(place_));
  RawRecord record;
  record.opcode = cursor.number<std::uint8_t>();
  record.offset = place_;
  const std::uint64_t length = cursor.number<std::uint64_t>();
  if (length > cursor.rest().size()) return std::nullopt;
  record.content = cursor.take(length);
  place_ += kRecordHeadSize + static_cast<std::size_t>(length);
  return record;
}

}  // namespace scanfuse::io::mcap
