#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "scanfuse/io/mcap/records.hpp"

namespace scanfuse::io::mcap {

/// CRC-32 (the polynomial of zlib), continued from `seed`.
[[nodiscard]] std::uint32_t crc32(std::span<const std::byte> bytes, std::uint32_t seed = 0);

/// The content of a record (without its head) as a struct; nothing when it is too short or its
/// counts do not fit. Bytes after the known fields are ignored, as the format asks.
template <class Record>
[[nodiscard]] std::optional<Record> parse(std::span<const std::byte> content);

/// A message whose data still stand in the buffer they were parsed from.
struct MessageView {
  std::uint16_t channel_id = 0;
  std::uint32_t sequence = 0;
  std::uint64_t log_time = 0;
  std::uint64_t publish_time = 0;
  std::span<const std::byte> data;
};

/// A chunk whose compressed records still stand in the buffer. When the record was cut off,
/// `records` is what is left of them: shorter than `head.compressed_size`.
struct ChunkView {
  ChunkHead head;
  std::span<const std::byte> records;
};

/// An attachment with the outcome of its checksum.
struct CheckedAttachment {
  Attachment attachment;
  bool crc_matches = true;
};

// These records can be parsed.
template <>
std::optional<Header> parse<Header>(std::span<const std::byte> content);
template <>
std::optional<Footer> parse<Footer>(std::span<const std::byte> content);
template <>
std::optional<Schema> parse<Schema>(std::span<const std::byte> content);
template <>
std::optional<Channel> parse<Channel>(std::span<const std::byte> content);
template <>
std::optional<MessageView> parse<MessageView>(std::span<const std::byte> content);
template <>
std::optional<ChunkView> parse<ChunkView>(std::span<const std::byte> content);
template <>
std::optional<MessageIndex> parse<MessageIndex>(std::span<const std::byte> content);
template <>
std::optional<ChunkIndex> parse<ChunkIndex>(std::span<const std::byte> content);
template <>
std::optional<CheckedAttachment> parse<CheckedAttachment>(std::span<const std::byte> content);
template <>
std::optional<AttachmentIndex> parse<AttachmentIndex>(std::span<const std::byte> content);
template <>
std::optional<Statistics> parse<Statistics>(std::span<const std::byte> content);
template <>
std::optional<Metadata> parse<Metadata>(std::span<const std::byte> content);
template <>
std::optional<MetadataIndex> parse<MetadataIndex>(std::span<const std::byte> content);
template <>
std::optional<SummaryOffset> parse<SummaryOffset>(std::span<const std::byte> content);
template <>
std::optional<DataEnd> parse<DataEnd>(std::span<const std::byte> content);

/// Appends a whole record, head and content.
void append(std::vector<std::byte>& out, const Header& record);
void append(std::vector<std::byte>& out, const Footer& record);
void append(std::vector<std::byte>& out, const Schema& record);
void append(std::vector<std::byte>& out, const Channel& record);
void append(std::vector<std::byte>& out, const MessageView& record);
void append(std::vector<std::byte>& out, const ChunkView& record);
void append(std::vector<std::byte>& out, const MessageIndex& record);
void append(std::vector<std::byte>& out, const ChunkIndex& record);
void append(std::vector<std::byte>& out, const Attachment& record);  ///< with its checksum
void append(std::vector<std::byte>& out, const AttachmentIndex& record);
void append(std::vector<std::byte>& out, const Statistics& record);
void append(std::vector<std::byte>& out, const Metadata& record);
void append(std::vector<std::byte>& out, const MetadataIndex& record);
void append(std::vector<std::byte>& out, const SummaryOffset& record);
void append(std::vector<std::byte>& out, const DataEnd& record);
void append_magic(std::vector<std::byte>& out);
[[nodiscard]] bool is_magic(std::span<const std::byte> bytes);

}  // namespace scanfuse::io::mcap
