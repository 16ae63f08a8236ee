#include "scanfuse/io/rosbag/open_rosbag.hpp"

#include <algorithm>
#include <fstream>
#include <map>
#include <set>
#include <utility>

#include "scanfuse/io/rosbag/chunk_directory.hpp"

namespace scanfuse::io {

namespace rosbag {
namespace {

constexpr std::size_t kMostOpenBytes = std::size_t{512} << 20;
constexpr std::size_t kChunksAskedForCompression = 64;

/// A chunk being read, and how far.
struct OpenChunk {
  std::size_t order = 0;  ///< among the directory's chunks
  Chunk chunk;
  std::size_t next = 0;
  [[nodiscard]] Time time() const { return chunk.messages[next].time; }
};

class BagSource final : public RawMessageSource {
 public:
  BagSource(BagFile file, ChunkDirectory directory, const std::vector<std::string>& topics)
      : file_(std::move(file)),
        directory_(std::move(directory)),
        topics_(topics.begin(), topics.end()),
        diagnostics_(std::move(directory_.diagnostics)) {
    for (auto& connection : directory_.connections) add_channel(std::move(connection));
    describe();
  }

  const std::vector<RawChannel>& channels() const override { return channels_; }
  const RecordingInfo& info() const override { return info_; }
  const Diagnostics& diagnostics() const override { return diagnostics_; }

  Result<std::optional<RawMessage>> next() override {
    open_due_chunks();
    if (open_.empty()) return std::optional<RawMessage>{};
    const auto earliest =
        std::min_element(open_.begin(), open_.end(), [](const OpenChunk& a, const OpenChunk& b) {
          return std::pair(a.time(), a.order) < std::pair(b.time(), b.order);
        });
    const auto& entry = earliest->chunk.messages[earliest->next];
    const auto bytes = std::span(earliest->chunk.bytes).subspan(entry.begin, entry.bytes);
    RawMessage message{channel_of_.at(entry.connection), entry.time, {bytes.begin(), bytes.end()}};
    if (++earliest->next == earliest->chunk.messages.size()) {
      open_bytes_ -= earliest->chunk.bytes.size();
      open_.erase(earliest);
    }
    return message;
  }

 private:
  bool selected(const std::string& topic) const {
    return topics_.empty() || topics_.contains(topic);
  }

  void add_channel(Connection connection) {
    const auto place = static_cast<std::uint32_t>(channels_.size());
    if (!channel_of_.emplace(connection.id, place).second) return;
    channels_.push_back({std::move(connection.topic), std::move(connection.type), "ros1",
                         std::move(connection.definition)});
  }

  void describe() {
    info_.path = file_.name();
    info_.format = "rosbag1";
    std::map<std::uint32_t, std::int64_t> counts;
    for (const auto& chunk : directory_.chunks) {
      for (const auto& [connection, count] : chunk.counts) counts[connection] += count;
      info_.start = std::min(info_.start.value_or(chunk.start), chunk.start);
      info_.end = std::max(info_.end.value_or(chunk.end), chunk.end);
    }
    for (const auto& [connection, channel] : channel_of_) {
      topic_info(channels_[channel]).messages += counts[connection];
    }
    std::sort(info_.topics.begin(), info_.topics.end(),
              [](const auto& a, const auto& b) { return a.name < b.name; });
    describe_compression();
  }

  /// Several publishers of one topic have a connection each.
  TopicInfo& topic_info(const RawChannel& channel) {
    for (auto& topic : info_.topics) {
      if (topic.name == channel.topic && topic.type == channel.type) return topic;
    }
    TopicInfo topic;
    topic.name = channel.topic;
    topic.type = channel.type;
    topic.encoding = channel.encoding;
    return info_.topics.emplace_back(std::move(topic));
  }

  void describe_compression() {
    std::set<std::string> kinds;
    const auto asked = std::min(directory_.chunks.size(), kChunksAskedForCompression);
    for (std::size_t i = 0; i < asked; ++i) {
      const auto record = file_.record_at(directory_.chunks[i].offset);
      if (record && record->fields.op() == Op::kChunk) {
        kinds.insert(record->fields.text("compression"));
      }
    }
    for (const auto& kind : kinds)
      info_.compression += (info_.compression.empty() ? "" : ", ") + kind;
    if (kinds.empty()) info_.compression = "none";
  }

  bool has_selected(const ChunkEntry& entry) const {
    return std::any_of(entry.counts.begin(), entry.counts.end(), [&](const auto& count) {
      const auto channel = channel_of_.find(count.first);
      return channel == channel_of_.end() || selected(channels_[channel->second].topic);
    });
  }

  /// Every chunk that may hold a message earlier than those at hand.
  void open_due_chunks() {
    while (next_chunk_ < directory_.chunks.size()) {
      const auto& entry = directory_.chunks[next_chunk_];
      const auto is_earlier = [&](const OpenChunk& c) { return c.time() < entry.start; };
      if (std::any_of(open_.begin(), open_.end(), is_earlier)) return;
      if (!open_.empty() && open_bytes_ > kMostOpenBytes) {
        diagnostics_.note("too many chunks overlap in time: messages may be out of order",
                          file_.place(entry.offset));
        return;
      }
      if (has_selected(entry)) open_chunk(next_chunk_, entry.offset);
      ++next_chunk_;
    }
  }

  void open_chunk(std::size_t order, std::uint64_t offset) {
    auto chunk = read_chunk(file_, offset);
    if (!chunk) {
      diagnostics_.damage("chunk that cannot be read skipped", chunk.error().message);
      return;
    }
    if (!chunk->problem.empty()) {
      diagnostics_.damage("damaged chunk read in part",
                          file_.place(offset) + ": " + chunk->problem);
    }
    for (auto& connection : chunk->connections) add_channel(std::move(connection));
    std::erase_if(chunk->messages, [&](const ChunkMessage& m) { return !is_wanted(m, offset); });
    if (chunk->messages.empty()) return;
    open_bytes_ += chunk->bytes.size();
    open_.push_back({order, std::move(*chunk), 0});
  }

  bool is_wanted(const ChunkMessage& message, std::uint64_t offset) {
    const auto channel = channel_of_.find(message.connection);
    if (channel == channel_of_.end()) {
      diagnostics_.damage("message of an unknown connection skipped", file_.place(offset));
      return false;
    }
    return selected(channels_[channel->second].topic);
  }

  BagFile file_;
  ChunkDirectory directory_;
  std::set<std::string> topics_;
  Diagnostics diagnostics_;
  std::vector<RawChannel> channels_;
  std::map<std::uint32_t, std::uint32_t> channel_of_;  ///< by connection
  RecordingInfo info_;
  std::vector<OpenChunk> open_;
  std::size_t open_bytes_ = 0;
  std::size_t next_chunk_ = 0;
};

}  // namespace
}  // namespace rosbag

Result<std::unique_ptr<RawMessageSource>> open_rosbag(std::unique_ptr<std::istream> stream,
                                                      const std::filesystem::path& name,
                                                      const std::vector<std::string>& topics) {
  rosbag::BagFile file(std::move(stream), name);
  auto directory = rosbag::read_directory(file);
  if (!directory) return tl::unexpected(directory.error());
  return std::make_unique<rosbag::BagSource>(std::move(file), std::move(*directory), topics);
}

Result<std::unique_ptr<RawMessageSource>> open_rosbag(const std::filesystem::path& path,
                                                      const std::vector<std::string>& topics) {
  auto stream = std::make_unique<std::ifstream>(path, std::ios::binary);
  if (!*stream) return fail(Error::Code::kNotFound, "{}: cannot be opened", path.string());
  return open_rosbag(std::move(stream), path, topics);
}

}  // namespace scanfuse::io
