#include "scanfuse/io/mcap/message_source.hpp"

#include <algorithm>
#include <limits>
#include <map>
#include <utility>

#include "scanfuse/io/mcap/message_reader.hpp"

namespace scanfuse::io {
namespace {

constexpr std::uint64_t kReadAheadBytes = std::uint64_t{64} << 20;

/// MCAP counts unsigned nanoseconds; what does not fit stays at the far end of our clock.
Time time_from_log(std::uint64_t nanos) {
  constexpr auto kLast = std::numeric_limits<std::int64_t>::max();
  return time_from_nanos(static_cast<std::int64_t>(std::min<std::uint64_t>(nanos, kLast)));
}

/// What a summary says, or a walk over the file found.
struct Counts {
  std::map<std::uint16_t, std::uint64_t> messages;
  std::optional<std::uint64_t> start, end;
  bool counted = false;
};

Counts counts_of(const mcap::Statistics& statistics) {
  Counts counts;
  counts.messages = statistics.channel_message_counts;
  counts.counted = !counts.messages.empty() || statistics.message_count == 0;
  if (statistics.message_count > 0) {
    counts.start = statistics.message_start_time;
    counts.end = statistics.message_end_time;
  }
  return counts;
}

class McapSource final : public RawMessageSource {
 public:
  explicit McapSource(mcap::MessageReader reader) : reader_(std::move(reader)) {}

  Result<void> start() {
    info_.path = reader_.name();
    info_.format = "mcap";
    Counts counts;
    if (reader_.summary().statistics) counts = counts_of(*reader_.summary().statistics);
    if (!counts.counted || !reader_.indexed()) {
      auto found = read_ahead();
      if (!found) return tl::unexpected(found.error());
      if (!counts.counted) counts = std::move(*found);
    }
    add_new_channels();
    fill_info(counts);
    return {};
  }

  [[nodiscard]] const std::vector<RawChannel>& channels() const override { return channels_; }
  [[nodiscard]] const Diagnostics& diagnostics() const override { return reader_.diagnostics(); }
  [[nodiscard]] const RecordingInfo& info() const override { return info_; }

  [[nodiscard]] Result<std::optional<RawMessage>> next() override {
    auto message = reader_.next();
    if (!message) return tl::unexpected(message.error());
    add_new_channels();
    if (!*message) return std::nullopt;
    const auto& view = **message;
    return RawMessage{index_of_.at(view.channel_id),
                      time_from_log(view.log_time),
                      {view.data.begin(), view.data.end()}};
  }

 private:
  /// Walks over the first part of the file and back to its start.
  Result<Counts> read_ahead() {
    Counts counts;
    for (;;) {
      auto message = reader_.next();
      if (!message) return tl::unexpected(message.error());
      if (!*message) {
        counts.counted = reader_.directory().wanted_topics.empty();
        break;
      }
      const auto time = (*message)->log_time;
      ++counts.messages[(*message)->channel_id];
      counts.start = std::min(counts.start.value_or(time), time);
      counts.end = std::max(counts.end.value_or(time), time);
      read_ahead_bytes_ += (*message)->data.size();
      if (reader_.position() > kReadAheadBytes || read_ahead_bytes_ > 4 * kReadAheadBytes) break;
    }
    if (!counts.counted) counts.end.reset();
    reader_.rewind();
    return counts;
  }

  void add_new_channels() {
    const auto& directory = reader_.directory();
    while (channels_.size() < directory.channel_order.size()) {
      const auto id = directory.channel_order[channels_.size()];
      const auto& channel = directory.channels.at(id);
      RawChannel raw{channel.topic, {}, channel.message_encoding, {}};
      const auto schema = directory.schemas.find(channel.schema_id);
      if (schema != directory.schemas.end()) {
        raw.type = schema->second.name;
        raw.definition = schema->second.data;
      }
      index_of_.emplace(id, static_cast<std::uint32_t>(channels_.size()));
      info_.topics.push_back({raw.topic, raw.type, raw.encoding, 0, false, false, false});
      channels_.push_back(std::move(raw));
    }
  }

  void fill_info(const Counts& counts) {
    for (const auto& [id, index] : index_of_) {
      const auto found = counts.messages.find(id);
      auto& topic = info_.topics[index];
      topic.counted = counts.counted;
      if (counts.counted && found != counts.messages.end()) {
        topic.messages = static_cast<std::int64_t>(
            std::min<std::uint64_t>(found->second, std::numeric_limits<std::int64_t>::max()));
      }
    }
    for (const auto& name : reader_.directory().compressions) {
      info_.compression += (info_.compression.empty() ? "" : ", ") + name;
    }
    if (info_.compression.empty()) info_.compression = "none";
    if (counts.start) info_.start = time_from_log(*counts.start);
    if (counts.end) info_.end = time_from_log(*counts.end);
  }

  mcap::MessageReader reader_;
  std::vector<RawChannel> channels_;
  std::map<std::uint16_t, std::uint32_t> index_of_;
  RecordingInfo info_;
  std::uint64_t read_ahead_bytes_ = 0;
};

}  // namespace

Result<std::unique_ptr<RawMessageSource>> open_mcap(std::unique_ptr<mcap::ByteSource> bytes,
                                                    const std::vector<std::string>& topics) {
  mcap::ReaderOptions options;
  options.topics = topics;
  auto reader = mcap::MessageReader::open(std::move(bytes), options);
  if (!reader) return tl::unexpected(reader.error());
  auto source = std::make_unique<McapSource>(std::move(*reader));
  if (auto started = source->start(); !started) return tl::unexpected(started.error());
  return source;
}

Result<std::unique_ptr<RawMessageSource>> open_mcap(const std::filesystem::path& path,
                                                    const std::vector<std::string>& topics) {
  auto bytes = mcap::open_bytes(path);
  if (!bytes) return tl::unexpected(bytes.error());
  return open_mcap(std::move(*bytes), topics);
}

}  // namespace scanfuse::io
