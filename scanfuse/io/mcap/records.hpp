#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace scanfuse::io::mcap {

// The records of the MCAP format, version 0 [Mcap2023]. Times are nanoseconds; offsets count
// bytes from the start of the file; lengths of records include their 9-byte head.

enum class Opcode : std::uint8_t {
  kHeader = 0x01,
  kFooter = 0x02,
  kSchema = 0x03,
  kChannel = 0x04,
  kMessage = 0x05,
  kChunk = 0x06,
  kMessageIndex = 0x07,
  kChunkIndex = 0x08,
  kAttachment = 0x09,
  kAttachmentIndex = 0x0A,
  kStatistics = 0x0B,
  kMetadata = 0x0C,
  kMetadataIndex = 0x0D,
  kSummaryOffset = 0x0E,
  kDataEnd = 0x0F,
};

inline constexpr std::size_t kMagicSize = 8;
inline constexpr std::size_t kRecordHeadSize = 9;  ///< opcode and length of the content
inline constexpr std::size_t kFooterSize = 20;     ///< content only

struct Header {
  std::string profile;
  std::string library;
};

struct Footer {
  std::uint64_t summary_start = 0;  ///< 0: no summary
  std::uint64_t summary_offset_start = 0;
  std::uint32_t summary_crc = 0;  ///< 0: not checked
};

struct Schema {
  std::uint16_t id = 0;  ///< 0 is not a schema
  std::string name;
  std::string encoding;  ///< "ros2msg", "ros1msg", "jsonschema", ...
  std::string data;
};

struct Channel {
  std::uint16_t id = 0;
  std::uint16_t schema_id = 0;  ///< 0: none
  std::string topic;
  std::string message_encoding;  ///< "cdr", "ros1", "json", ...
  std::map<std::string, std::string> metadata;
};

struct Message {
  std::uint16_t channel_id = 0;
  std::uint32_t sequence = 0;
  std::uint64_t log_time = 0;
  std::uint64_t publish_time = 0;
  std::vector<std::byte> data;
};

/// What stands before the (compressed) records of a chunk.
struct ChunkHead {
  std::uint64_t message_start_time = 0;
  std::uint64_t message_end_time = 0;
  std::uint64_t uncompressed_size = 0;
  std::uint32_t uncompressed_crc = 0;  ///< 0: not checked
  std::string compression;             ///< "", "lz4", "zstd"
  std::uint64_t compressed_size = 0;
};

struct MessageIndex {
  struct Entry {
    std::uint64_t log_time = 0;
    std::uint64_t offset = 0;  ///< in the uncompressed records of the chunk
  };
  std::uint16_t channel_id = 0;
  std::vector<Entry> entries;
};

struct ChunkIndex {
  std::uint64_t message_start_time = 0;
  std::uint64_t message_end_time = 0;
  std::uint64_t chunk_start_offset = 0;
  std::uint64_t chunk_length = 0;
  std::map<std::uint16_t, std::uint64_t> message_index_offsets;  ///< by channel; may be empty
  std::uint64_t message_index_length = 0;
  std::string compression;
  std::uint64_t compressed_size = 0;
  std::uint64_t uncompressed_size = 0;
};

struct Attachment {
  std::uint64_t log_time = 0;
  std::uint64_t create_time = 0;
  std::string name;
  std::string media_type;
  std::vector<std::byte> data;
};

struct AttachmentIndex {
  std::uint64_t offset = 0;
  std::uint64_t length = 0;
  std::uint64_t log_time = 0;
  std::uint64_t create_time = 0;
  std::uint64_t data_size = 0;
  std::string name;
  std::string media_type;
};

struct Statistics {
  std::uint64_t message_count = 0;
  std::uint16_t schema_count = 0;
  std::uint32_t channel_count = 0;
  std::uint32_t attachment_count = 0;
  std::uint32_t metadata_count = 0;
  std::uint32_t chunk_count = 0;
  std::uint64_t message_start_time = 0;
  std::uint64_t message_end_time = 0;
  std::map<std::uint16_t, std::uint64_t> channel_message_counts;
};

struct Metadata {
  std::string name;
  std::map<std::string, std::string> metadata;
};

struct MetadataIndex {
  std::uint64_t offset = 0;
  std::uint64_t length = 0;
  std::string name;
};

struct SummaryOffset {
  std::uint8_t group_opcode = 0;
  std::uint64_t group_start = 0;
  std::uint64_t group_length = 0;
};

struct DataEnd {
  std::uint32_t data_section_crc = 0;  ///< 0: not checked
};

}  // namespace scanfuse::io::mcap
