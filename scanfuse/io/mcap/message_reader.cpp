#include "scanfuse/io/mcap/message_reader.hpp"

#include <algorithm>
#include <utility>

namespace scanfuse::io::mcap {
namespace {

std::string place_of(const RawRecord& record) { return fmt::format("byte {}", record.offset); }

std::uint32_t crc_of_magic() {
  std::vector<std::byte> magic;
  append_magic(magic);
  return crc32(magic);
}

}  // namespace

MessageReader::MessageReader(std::unique_ptr<ByteSource> source, const ReaderOptions& options,
                             FileEnd end)
    : source_(std::move(source)),
      options_(options),
      end_(std::move(end)),
      loader_(options.max_chunk_bytes),
      records_(*source_, kMagicSize, source_->size()) {
  indexed_ = index_is_usable(end_.summary);
  directory_.wanted_topics.insert(options.topics.begin(), options.topics.end());
  for (const auto& [id, schema] : end_.summary.schemas) directory_.add(schema);
  for (const auto& [id, channel] : end_.summary.channels) directory_.add(channel);
  for (const auto& chunk : end_.summary.chunks) {
    directory_.compressions.insert(chunk.compression.empty() ? "none" : chunk.compression);
  }
  by_time_ = end_.summary.chunks;
  std::stable_sort(by_time_.begin(), by_time_.end(), [](const auto& a, const auto& b) {
    return a.message_start_time < b.message_start_time;
  });
  if (!end_.has_footer) at_open_.damage("file was cut off or never finished: no footer", name());
  if (!end_.problem.empty()) at_open_.damage("summary not used", end_.problem);
  rewind();
}

Result<MessageReader> MessageReader::open(std::unique_ptr<ByteSource> source,
                                          const ReaderOptions& options) {
  std::vector<std::byte> magic(kMagicSize);
  if (source->size() < kMagicSize) {
    return fail(Error::Code::kMalformed, "{}: {} bytes are too few for an MCAP file",
                source->name(), source->size());
  }
  if (auto done = source->read(0, magic); !done) return tl::unexpected(done.error());
  if (!is_magic(magic)) {
    return fail(Error::Code::kMalformed, "{}: byte 0: not an MCAP file (its first 8 bytes differ)",
                source->name());
  }
  auto end = read_file_end(*source);
  if (!end) return tl::unexpected(end.error());
  return MessageReader(std::move(source), options, std::move(*end));
}

void MessageReader::rewind() {
  diagnostics_ = at_open_;
  records_ = RecordReader(*source_, kMagicSize, source_->size());
  records_.start_crc(crc_of_magic());
  next_chunk_ = 0;
  open_.clear();
  ended_ = false;
  last_time_ = 0;
  given_ = 0;
}

Result<std::optional<MessageView>> MessageReader::next() {
  auto message = indexed_ ? next_indexed() : next_linear();
  if (message && *message) ++given_;
  return message;
}

bool MessageReader::chunk_is_wanted(const ChunkIndex& index) const {
  if (index.message_index_offsets.empty()) return true;
  return std::any_of(index.message_index_offsets.begin(), index.message_index_offsets.end(),
                     [&](const auto& entry) { return directory_.wants(entry.first); });
}

Result<void> MessageReader::open_next_chunk() {
  const ChunkIndex& index = by_time_[next_chunk_++];
  if (!chunk_is_wanted(index)) return {};
  RecordReader reader(*source_, index.chunk_start_offset, end_.summary.start);
  auto record = reader.next();
  if (!record) return tl::unexpected(record.error());
  if (!*record || !(*record)->is(Opcode::kChunk) || !(*record)->complete) {
    diagnostics_.damage("indexed chunk not found at its place",
                        fmt::format("byte {}", index.chunk_start_offset));
    return {};
  }
  auto chunk = loader_.load(**record, directory_, diagnostics_);
  if (chunk && !chunk->messages.empty()) open_.push_back(std::move(*chunk));
  return {};
}

/// The earliest message of all open chunks. An emptied chunk is closed at the following call,
/// because the message handed out still points into it.
std::optional<MessageView> MessageReader::take_from_open_chunks() {
  OpenChunk* earliest = nullptr;
  for (auto& chunk : open_) {
    if (chunk.next == chunk.messages.size()) continue;
    if (earliest == nullptr) {
      earliest = &chunk;
      continue;
    }
    const auto mine = chunk.messages[chunk.next].log_time;
    const auto best = earliest->messages[earliest->next].log_time;
    if (mine < best || (mine == best && chunk.file_offset < earliest->file_offset)) {
      earliest = &chunk;
    }
  }
  if (earliest == nullptr) return std::nullopt;
  return earliest->messages[earliest->next++];
}

Result<std::optional<MessageView>> MessageReader::next_indexed() {
  std::erase_if(open_, [](const auto& chunk) { return chunk.next == chunk.messages.size(); });
  while (next_chunk_ < by_time_.size()) {
    std::optional<std::uint64_t> earliest;
    for (const auto& chunk : open_) {
      const auto time = chunk.messages[chunk.next].log_time;
      if (!earliest || time < *earliest) earliest = time;
    }
    if (earliest && by_time_[next_chunk_].message_start_time > *earliest) break;
    if (open_.size() >= options_.max_open_chunks) {
      diagnostics_.note("more chunks overlap in time than are merged", name());
      break;
    }
    if (auto done = open_next_chunk(); !done) return tl::unexpected(done.error());
  }
  auto message = take_from_open_chunks();
  if (!message) {
    check_counts();
  } else if (message->log_time < last_time_) {
    diagnostics_.note("log time goes back", fmt::format("{} ns", message->log_time));
  }
  if (message) last_time_ = message->log_time;
  return message;
}

void MessageReader::check_counts() {
  if (std::exchange(ended_, true) || !end_.summary.statistics) return;
  if (!directory_.wanted_topics.empty() || diagnostics_.any_damage()) return;
  const auto promised = end_.summary.statistics->message_count;
  if (promised > given_) {
    diagnostics_.damage(
        "messages counted by the file but not found by its index", name(),
        static_cast<std::int64_t>(std::min<std::uint64_t>(promised - given_, INT64_MAX)));
  }
}

Result<std::optional<MessageView>> MessageReader::next_linear() {
  std::erase_if(open_, [](const auto& chunk) { return chunk.next == chunk.messages.size(); });
  if (auto message = take_from_open_chunks()) return message;
  while (!ended_) {
    auto record = records_.next();
    if (!record) return tl::unexpected(record.error());
    if (!*record) break;
    if (auto message = take(**record)) return message;
    if (auto message = take_from_open_chunks()) return message;
  }
  ended_ = true;
  return std::nullopt;
}

std::optional<MessageView> MessageReader::take(const RawRecord& record) {
  if (!record.complete) {
    ended_ = true;
    diagnostics_.damage("last record cut off", place_of(record));
    if (!record.is(Opcode::kChunk)) return std::nullopt;
  }
  if (record.opcode == 0) {
    ended_ = true;
    diagnostics_.damage("bytes that are no record; the rest is not read", place_of(record));
    return std::nullopt;
  }
  if (record.is(Opcode::kChunk)) {
    auto chunk = loader_.load(record, directory_, diagnostics_);
    if (chunk && !chunk->messages.empty()) open_.push_back(std::move(*chunk));
    return std::nullopt;
  }
  if (!record.is(Opcode::kMessage)) {
    keep_checked(record);
    return std::nullopt;
  }
  const auto message = parse<MessageView>(record.content);
  if (!message || !directory_.channels.contains(message->channel_id)) {
    diagnostics_.damage("damaged record skipped", place_of(record));
    return std::nullopt;
  }
  if (!directory_.wants(message->channel_id)) return std::nullopt;
  return message;
}

void MessageReader::keep_checked(const RawRecord& record) {
  bool sound = true;
  if (record.is(Opcode::kSchema)) {
    auto schema = parse<Schema>(record.content);
    sound = schema.has_value();
    if (schema) directory_.add(std::move(*schema));
  } else if (record.is(Opcode::kChannel)) {
    auto channel = parse<Channel>(record.content);
    sound = channel.has_value();
    if (channel) directory_.add(std::move(*channel));
  } else if (record.is(Opcode::kAttachment) && !record.skipped) {
    const auto checked = parse<CheckedAttachment>(record.content);
    sound = checked && checked->crc_matches;
  } else if (record.is(Opcode::kFooter)) {
    ended_ = true;
  } else if (record.is(Opcode::kDataEnd)) {
    ended_ = true;
    const auto end = parse<DataEnd>(record.content);
    const auto actual = records_.crc_before_latest();
    sound = end && (end->data_section_crc == 0 || !actual || *actual == end->data_section_crc);
  }
  if (!sound) diagnostics_.damage("record damaged or with a wrong checksum", place_of(record));
}

}  // namespace scanfuse::io::mcap
