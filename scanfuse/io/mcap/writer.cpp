#include "scanfuse/io/mcap/writer.hpp"

#include <algorithm>
#include <utility>

#include "scanfuse/core/assert.hpp"

namespace scanfuse::io::mcap {
namespace {

/// The length of a record's content is a uint64, but texts inside it are counted by a uint32.
constexpr std::uint64_t kLongestText = 0xFFFF'FFFF;

/// Appends the records of one group to the summary and remembers where they stand.
class SummaryGroups {
 public:
  SummaryGroups(std::vector<std::byte>& out, std::uint64_t file_offset)
      : out_(out), file_offset_(file_offset) {}

  template <class Record>
  void add(Opcode opcode, const std::vector<Record>& records, bool wanted) {
    if (!wanted || records.empty()) return;
    const std::size_t start = out_.size();
    for (const auto& record : records) append(out_, record);
    offsets_.push_back(
        {static_cast<std::uint8_t>(opcode), file_offset_ + start, out_.size() - start});
  }
  [[nodiscard]] const std::vector<SummaryOffset>& offsets() const { return offsets_; }

 private:
  std::vector<std::byte>& out_;
  std::uint64_t file_offset_;
  std::vector<SummaryOffset> offsets_;
};

}  // namespace

Writer::Writer(std::unique_ptr<ByteSink> sink, const WriterOptions& options)
    : sink_(std::move(sink)), options_(options), compressor_(options.compression, options.level) {}

Result<Writer> Writer::create(const std::filesystem::path& path, const WriterOptions& options) {
  auto sink = sink_to_file(path);
  if (!sink) return tl::unexpected(sink.error());
  return create(std::move(*sink), options);
}

Result<Writer> Writer::create(std::unique_ptr<ByteSink> sink, const WriterOptions& options) {
  Writer writer(std::move(sink), options);
  append_magic(writer.scratch_);
  append(writer.scratch_, Header{options.profile, options.library});
  if (auto done = writer.flush(writer.scratch_); !done) return tl::unexpected(done.error());
  return writer;
}

/// Hands bytes of the data section to the sink, and empties them.
Result<void> Writer::flush(std::vector<std::byte>& bytes) {
  crc_ = crc32(bytes, crc_);
  offset_ += bytes.size();
  auto done = sink_->write(bytes);
  bytes.clear();
  return done;
}

template <class Record>
Result<void> Writer::write_data(const Record& record) {
  if (options_.chunks) {
    append(chunk_.records, record);
    return {};
  }
  append(scratch_, record);
  return flush(scratch_);
}

Result<std::uint16_t> Writer::add_schema(Schema schema) {
  if (schemas_.size() >= 0xFFFF || schema.data.size() > kLongestText) {
    return fail(Error::Code::kOutOfRange, "schema '{}': too long, or more than 65535 schemas",
                schema.name);
  }
  schema.id = static_cast<std::uint16_t>(schemas_.size() + 1);
  schemas_.push_back(std::move(schema));
  if (auto done = write_data(schemas_.back()); !done) return tl::unexpected(done.error());
  return schemas_.back().id;
}

Result<std::uint16_t> Writer::add_channel(Channel channel) {
  SCANFUSE_ASSERT(channel.schema_id <= schemas_.size());
  if (channels_.size() >= 0xFFFF) {
    return fail(Error::Code::kOutOfRange, "topic '{}': more than 65535 channels", channel.topic);
  }
  channel.id = static_cast<std::uint16_t>(channels_.size() + 1);
  channels_.push_back(std::move(channel));
  if (auto done = write_data(channels_.back()); !done) return tl::unexpected(done.error());
  return channels_.back().id;
}

Result<void> Writer::write(const MessageView& message) {
  SCANFUSE_ASSERT(message.channel_id >= 1 && message.channel_id <= channels_.size());
  auto& all = statistics_;
  const bool first = all.message_count++ == 0;
  ++all.channel_message_counts[message.channel_id];
  all.message_start_time =
      first ? message.log_time : std::min(all.message_start_time, message.log_time);
  all.message_end_time = std::max(all.message_end_time, message.log_time);
  if (!options_.chunks) return write_data(message);

  auto& index = chunk_.index[message.channel_id];
  index.channel_id = message.channel_id;
  index.entries.push_back({message.log_time, chunk_.records.size()});
  chunk_.start = chunk_.has_messages ? std::min(chunk_.start, message.log_time) : message.log_time;
  chunk_.end = std::max(chunk_.end, message.log_time);
  chunk_.has_messages = true;
  append(chunk_.records, message);
  if (chunk_.records.size() >= options_.chunk_bytes) return close_chunk();
  return {};
}

Result<ChunkIndex> Writer::write_chunk_record() {
  auto packed = compressor_.compress(chunk_.records);
  if (!packed) return tl::unexpected(packed.error());
  ChunkView view;
  view.head = {chunk_.start,
               chunk_.end,
               chunk_.records.size(),
               crc32(chunk_.records),
               std::string(compressor_.name()),
               packed->size()};
  view.records = *packed;
  ChunkIndex entry;
  entry.message_start_time = chunk_.start;
  entry.message_end_time = chunk_.end;
  entry.chunk_start_offset = offset_;
  entry.compression = view.head.compression;
  entry.compressed_size = packed->size();
  entry.uncompressed_size = chunk_.records.size();
  append(scratch_, view);
  entry.chunk_length = scratch_.size();
  if (auto done = flush(scratch_); !done) return tl::unexpected(done.error());
  return entry;
}

Result<void> Writer::close_chunk() {
  if (chunk_.records.empty()) return {};
  auto entry = write_chunk_record();
  if (!entry) return tl::unexpected(entry.error());
  if (options_.message_index) {
    const std::uint64_t index_start = offset_;
    for (auto& [channel, index] : chunk_.index) {
      entry->message_index_offsets[channel] = offset_;
      append(scratch_, index);
      if (auto done = flush(scratch_); !done) return done;
    }
    entry->message_index_length = offset_ - index_start;
  }
  chunk_indexes_.push_back(std::move(*entry));
  chunk_ = {};
  return {};
}

Result<void> Writer::write(const Attachment& attachment) {
  if (auto done = close_chunk(); !done) return done;
  append(scratch_, attachment);
  attachment_indexes_.push_back({offset_, scratch_.size(), attachment.log_time,
                                 attachment.create_time, attachment.data.size(), attachment.name,
                                 attachment.media_type});
  return flush(scratch_);
}

Result<void> Writer::write(const Metadata& metadata) {
  if (auto done = close_chunk(); !done) return done;
  append(scratch_, metadata);
  metadata_indexes_.push_back({offset_, scratch_.size(), metadata.name});
  return flush(scratch_);
}

std::vector<std::byte> Writer::summary_bytes(Footer& footer) const {
  Statistics totals = statistics_;
  totals.schema_count = static_cast<std::uint16_t>(schemas_.size());
  totals.channel_count = static_cast<std::uint32_t>(channels_.size());
  totals.attachment_count = static_cast<std::uint32_t>(attachment_indexes_.size());
  totals.metadata_count = static_cast<std::uint32_t>(metadata_indexes_.size());
  totals.chunk_count = static_cast<std::uint32_t>(chunk_indexes_.size());

  std::vector<std::byte> out;
  SummaryGroups groups(out, offset_);
  groups.add(Opcode::kSchema, schemas_, options_.repeated_schemas);
  groups.add(Opcode::kChannel, channels_, options_.repeated_channels);
  groups.add(Opcode::kStatistics, std::vector{totals}, options_.statistics);
  groups.add(Opcode::kMetadataIndex, metadata_indexes_, options_.metadata_index);
  groups.add(Opcode::kAttachmentIndex, attachment_indexes_, options_.attachment_index);
  groups.add(Opcode::kChunkIndex, chunk_indexes_, options_.chunk_index);
  if (!out.empty()) footer.summary_start = offset_;
  if (options_.summary_offsets && !groups.offsets().empty()) {
    footer.summary_offset_start = offset_ + out.size();
    for (const auto& record : groups.offsets()) append(out, record);
  }
  return out;
}

Result<void> Writer::checkpoint() {
  if (auto done = close_chunk(); !done) return done;
  return sink_->flush();
}

Result<void> Writer::finish() {
  if (auto done = close_chunk(); !done) return done;
  append(scratch_, DataEnd{crc_});
  if (auto done = flush(scratch_); !done) return done;
  Footer footer;
  std::vector<std::byte> out = summary_bytes(footer);
  append(out, footer);
  const std::span<const std::byte> checked(out.data(), out.size() - 4);
  const std::uint32_t crc = crc32(checked);
  for (std::size_t i = 0; i < 4; ++i) {
    out[checked.size() + i] = static_cast<std::byte>(crc >> (8 * i));
  }
  append_magic(out);
  if (auto done = sink_->write(out); !done) return done;
  return sink_->commit();
}

}  // namespace scanfuse::io::mcap
