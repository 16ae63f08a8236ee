#include <zlib.h>

#include <limits>

#include "scanfuse/io/mcap/bytes.hpp"
#include "scanfuse/io/mcap/record_codec.hpp"

namespace scanfuse::io::mcap {
namespace {

using u8 = std::uint8_t;
using u16 = std::uint16_t;
using u32 = std::uint32_t;
using u64 = std::uint64_t;

template <class Record>
std::optional<Record> finished(const ByteCursor& in, Record record) {
  if (!in.ok()) return std::nullopt;
  return record;
}

/// A map takes its entries from its own counted bytes; a torn entry fails the whole record.
std::map<std::string, std::string> text_map(ByteCursor& in) {
  std::map<std::string, std::string> map;
  ByteCursor entries(in.counted());
  while (entries.ok() && !entries.at_end()) {
    std::string key = entries.text();
    map[std::move(key)] = entries.text();
  }
  if (!entries.ok()) (void)in.take(std::numeric_limits<u64>::max());
  return map;
}

std::map<u16, u64> number_map(ByteCursor& in) {
  std::map<u16, u64> map;
  ByteCursor entries(in.counted());
  while (entries.ok() && !entries.at_end()) {
    const u16 key = entries.number<u16>();
    map[key] = entries.number<u64>();
  }
  if (!entries.ok()) (void)in.take(std::numeric_limits<u64>::max());
  return map;
}

std::vector<std::byte> copy(std::span<const std::byte> bytes) {
  return {bytes.begin(), bytes.end()};
}

}  // namespace

u32 crc32(std::span<const std::byte> bytes, u32 seed) {
  return static_cast<u32>(
      ::crc32_z(seed, reinterpret_cast<const Bytef*>(bytes.data()), bytes.size()));
}

template <>
std::optional<Header> parse<Header>(std::span<const std::byte> content) {
  ByteCursor in(content);
  Header record;
  record.profile = in.text();
  record.library = in.text();
  return finished(in, std::move(record));
}

template <>
std::optional<Footer> parse<Footer>(std::span<const std::byte> content) {
  ByteCursor in(content);
  Footer record;
  record.summary_start = in.number<u64>();
  record.summary_offset_start = in.number<u64>();
  record.summary_crc = in.number<u32>();
  return finished(in, record);
}

template <>
std::optional<Schema> parse<Schema>(std::span<const std::byte> content) {
  ByteCursor in(content);
  Schema record;
  record.id = in.number<u16>();
  record.name = in.text();
  record.encoding = in.text();
  record.data = in.text();
  return finished(in, std::move(record));
}

template <>
std::optional<Channel> parse<Channel>(std::span<const std::byte> content) {
  ByteCursor in(content);
  Channel record;
  record.id = in.number<u16>();
  record.schema_id = in.number<u16>();
  record.topic = in.text();
  record.message_encoding = in.text();
  record.metadata = text_map(in);
  return finished(in, std::move(record));
}

template <>
std::optional<MessageView> parse<MessageView>(std::span<const std::byte> content) {
  ByteCursor in(content);
  MessageView record;
  record.channel_id = in.number<u16>();
  record.sequence = in.number<u32>();
  record.log_time = in.number<u64>();
  record.publish_time = in.number<u64>();
  record.data = in.rest();
  return finished(in, record);
}

template <>
std::optional<ChunkView> parse<ChunkView>(std::span<const std::byte> content) {
  ByteCursor in(content);
  ChunkView record;
  record.head.message_start_time = in.number<u64>();
  record.head.message_end_time = in.number<u64>();
  record.head.uncompressed_size = in.number<u64>();
  record.head.uncompressed_crc = in.number<u32>();
  record.head.compression = in.text();
  record.head.compressed_size = in.number<u64>();
  const u64 left = in.rest().size();
  record.records = in.take(std::min(left, record.head.compressed_size));
  return finished(in, std::move(record));
}

template <>
std::optional<MessageIndex> parse<MessageIndex>(std::span<const std::byte> content) {
  ByteCursor in(content);
  MessageIndex record;
  record.channel_id = in.number<u16>();
  ByteCursor entries(in.counted());
  while (entries.ok() && !entries.at_end()) {
    const u64 log_time = entries.number<u64>();
    record.entries.push_back({log_time, entries.number<u64>()});
  }
  if (!entries.ok()) return std::nullopt;
  return finished(in, std::move(record));
}

template <>
std::optional<ChunkIndex> parse<ChunkIndex>(std::span<const std::byte> content) {
  ByteCursor in(content);
  ChunkIndex record;
  record.message_start_time = in.number<u64>();
  record.message_end_time = in.number<u64>();
  record.chunk_start_offset = in.number<u64>();
  record.chunk_length = in.number<u64>();
  record.message_index_offsets = number_map(in);
  record.message_index_length = in.number<u64>();
  record.compression = in.text();
  record.compressed_size = in.number<u64>();
  record.uncompressed_size = in.number<u64>();
  return finished(in, std::move(record));
}

template <>
std::optional<CheckedAttachment> parse<CheckedAttachment>(std::span<const std::byte> content) {
  ByteCursor in(content);
  CheckedAttachment record;
  record.attachment.log_time = in.number<u64>();
  record.attachment.create_time = in.number<u64>();
  record.attachment.name = in.text();
  record.attachment.media_type = in.text();
  record.attachment.data = copy(in.take(in.number<u64>()));
  const std::size_t checked = content.size() - in.rest().size();
  const u32 expected = in.number<u32>();
  if (!in.ok()) return std::nullopt;
  record.crc_matches = expected == 0 || expected == crc32(content.first(checked));
  return record;
}

template <>
std::optional<AttachmentIndex> parse<AttachmentIndex>(std::span<const std::byte> content) {
  ByteCursor in(content);
  AttachmentIndex record;
  record.offset = in.number<u64>();
  record.length = in.number<u64>();
  record.log_time = in.number<u64>();
  record.create_time = in.number<u64>();
  record.data_size = in.number<u64>();
  record.name = in.text();
  record.media_type = in.text();
  return finished(in, std::move(record));
}

template <>
std::optional<Statistics> parse<Statistics>(std::span<const std::byte> content) {
  ByteCursor in(content);
  Statistics record;
  record.message_count = in.number<u64>();
  record.schema_count = in.number<u16>();
  record.channel_count = in.number<u32>();
  record.attachment_count = in.number<u32>();
  record.metadata_count = in.number<u32>();
  record.chunk_count = in.number<u32>();
  record.message_start_time = in.number<u64>();
  record.message_end_time = in.number<u64>();
  record.channel_message_counts = number_map(in);
  return finished(in, std::move(record));
}

template <>
std::optional<Metadata> parse<Metadata>(std::span<const std::byte> content) {
  ByteCursor in(content);
  Metadata record;
  record.name = in.text();
  record.metadata = text_map(in);
  return finished(in, std::move(record));
}

template <>
std::optional<MetadataIndex> parse<MetadataIndex>(std::span<const std::byte> content) {
  ByteCursor in(content);
  MetadataIndex record;
  record.offset = in.number<u64>();
  record.length = in.number<u64>();
  record.name = in.text();
  return finished(in, std::move(record));
}

template <>
std::optional<SummaryOffset> parse<SummaryOffset>(std::span<const std::byte> content) {
  ByteCursor in(content);
  SummaryOffset record;
  record.group_opcode = in.number<u8>();
  record.group_start = in.number<u64>();
  record.group_length = in.number<u64>();
  return finished(in, record);
}

template <>
std::optional<DataEnd> parse<DataEnd>(std::span<const std::byte> content) {
  ByteCursor in(content);
  DataEnd record;
  record.data_section_crc = in.number<u32>();
  return finished(in, record);
}

}  // namespace scanfuse::io::mcap
