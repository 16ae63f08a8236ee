#include <array>
#include <utility>

#include "scanfuse/io/mcap/bytes.hpp"
#include "scanfuse/io/mcap/record_codec.hpp"

namespace scanfuse::io::mcap {
namespace {

constexpr std::array<unsigned char, kMagicSize> kMagic{0x89, 'M', 'C', 'A', 'P', '0', '\r', '\n'};

/// Writes the head, lets `content` write what follows, then puts the length right.
template <class Content>
void framed(std::vector<std::byte>& out, Opcode opcode, Content content) {
  ByteWriter writer(out);
  writer.number(static_cast<std::uint8_t>(opcode));
  const std::size_t length_at = writer.size();
  writer.number(std::uint64_t{0});
  content(writer);
  writer.patch(length_at, static_cast<std::uint64_t>(writer.size() - length_at - 8));
}

void append_map(ByteWriter& writer, const std::map<std::string, std::string>& map) {
  const std::size_t length_at = writer.size();
  writer.number(std::uint32_t{0});
  for (const auto& [key, value] : map) {
    writer.text(key);
    writer.text(value);
  }
  writer.patch(length_at, static_cast<std::uint32_t>(writer.size() - length_at - 4));
}

void append_map(ByteWriter& writer, const std::map<std::uint16_t, std::uint64_t>& map) {
  writer.number(static_cast<std::uint32_t>(map.size() * 10));
  for (const auto& [key, value] : map) {
    writer.number(key);
    writer.number(value);
  }
}

}  // namespace

void append_magic(std::vector<std::byte>& out) {
  ByteWriter(out).raw(std::as_bytes(std::span(kMagic)));
}

bool is_magic(std::span<const std::byte> bytes) {
  return bytes.size() == kMagicSize && std::memcmp(bytes.data(), kMagic.data(), kMagicSize) == 0;
}

void append(std::vector<std::byte>& out, const Header& record) {
  framed(out, Opcode::kHeader, [&](ByteWriter& w) {
    w.text(record.profile);
    w.text(record.library);
  });
}

void append(std::vector<std::byte>& out, const Footer& record) {
  framed(out, Opcode::kFooter, [&](ByteWriter& w) {
    w.number(record.summary_start);
    w.number(record.summary_offset_start);
    w.number(record.summary_crc);
  });
}

void append(std::vector<std::byte>& out, const Schema& record) {
  framed(out, Opcode::kSchema, [&](ByteWriter& w) {
    w.number(record.id);
    w.text(record.name);
    w.text(record.encoding);
    w.text(record.data);
  });
}

void append(std::vector<std::byte>& out, const Channel& record) {
  framed(out, Opcode::kChannel, [&](ByteWriter& w) {
    w.number(record.id);
    w.number(record.schema_id);
    w.text(record.topic);
    w.text(record.message_encoding);
    append_map(w, record.metadata);
  });
}

void append(std::vector<std::byte>& out, const MessageView& record) {
  framed(out, Opcode::kMessage, [&](ByteWriter& w) {
    w.number(record.channel_id);
    w.number(record.sequence);
    w.number(record.log_time);
    w.number(record.publish_time);
    w.raw(record.data);
  });
}

void append(std::vector<std::byte>& out, const ChunkView& record) {
  framed(out, Opcode::kChunk, [&](ByteWriter& w) {
    w.number(record.head.message_start_time);
    w.number(record.head.message_end_time);
    w.number(record.head.uncompressed_size);
    w.number(record.head.uncompressed_crc);
    w.text(record.head.compression);
    w.number(static_cast<std::uint64_t>(record.records.size()));
    w.raw(record.records);
  });
}

void append(std::vector<std::byte>& out, const MessageIndex& record) {
  framed(out, Opcode::kMessageIndex, [&](ByteWriter& w) {
    w.number(record.channel_id);
    w.number(static_cast<std::uint32_t>(record.entries.size() * 16));
    for (const auto& entry : record.entries) {
      w.number(entry.log_time);
      w.number(entry.offset);
    }
  });
}

void append(std::vector<std::byte>& out, const ChunkIndex& record) {
  framed(out, Opcode::kChunkIndex, [&](ByteWriter& w) {
    w.number(record.message_start_time);
    w.number(record.message_end_time);
    w.number(record.chunk_start_offset);
    w.number(record.chunk_length);
    append_map(w, record.message_index_offsets);
    w.number(record.message_index_length);
    w.text(record.compression);
    w.number(record.compressed_size);
    w.number(record.uncompressed_size);
  });
}

void append(std::vector<std::byte>& out, const Attachment& record) {
  framed(out, Opcode::kAttachment, [&](ByteWriter& w) {
    const std::size_t start = w.size();
    w.number(record.log_time);
    w.number(record.create_time);
    w.text(record.name);
    w.text(record.media_type);
    w.number(static_cast<std::uint64_t>(record.data.size()));
    w.raw(record.data);
    w.number(crc32(std::span<const std::byte>(out).subspan(start)));
  });
}

void append(std::vector<std::byte>& out, const AttachmentIndex& record) {
  framed(out, Opcode::kAttachmentIndex, [&](ByteWriter& w) {
    w.number(record.offset);
    w.number(record.length);
    w.number(record.log_time);
    w.number(record.create_time);
    w.number(record.data_size);
    w.text(record.name);
    w.text(record.media_type);
  });
}

void append(std::vector<std::byte>& out, const Statistics& record) {
  framed(out, Opcode::kStatistics, [&](ByteWriter& w) {
    w.number(record.message_count);
    w.number(record.schema_count);
    w.number(record.channel_count);
    w.number(record.attachment_count);
    w.number(record.metadata_count);
    w.number(record.chunk_count);
    w.number(record.message_start_time);
    w.number(record.message_end_time);
    append_map(w, record.channel_message_counts);
  });
}

void append(std::vector<std::byte>& out, const Metadata& record) {
  framed(out, Opcode::kMetadata, [&](ByteWriter& w) {
    w.text(record.name);
    append_map(w, record.metadata);
  });
}

void append(std::vector<std::byte>& out, const MetadataIndex& record) {
  framed(out, Opcode::kMetadataIndex, [&](ByteWriter& w) {
    w.number(record.offset);
    w.number(record.length);
    w.text(record.name);
  });
}

void append(std::vector<std::byte>& out, const SummaryOffset& record) {
  framed(out, Opcode::kSummaryOffset, [&](ByteWriter& w) {
    w.number(record.group_opcode);
    w.number(record.group_start);
    w.number(record.group_length);
  });
}

void append(std::vector<std::byte>& out, const DataEnd& record) {
  framed(out, Opcode::kDataEnd, [&](ByteWriter& w) { w.number(record.data_section_crc); });
}

}  // namespace scanfuse::io::mcap
