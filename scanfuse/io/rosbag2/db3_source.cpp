#include "scanfuse/io/rosbag2/db3_source.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

namespace scanfuse::io::rosbag2 {

namespace {

class Db3Source final : public RawMessageSource {
 public:
  [[nodiscard]] static Result<std::unique_ptr<RawMessageSource>> make(
      Database database, const std::vector<std::string>& topics) {
    // Times and places first: an index gives them in order, and a large message is read only when
    // it is wanted.
    auto order = database.query("SELECT rowid, timestamp FROM messages ORDER BY timestamp, rowid");
    if (!order) return tl::unexpected(order.error());
    auto fetch = database.query("SELECT topic_id, data FROM messages WHERE rowid = ?1");
    if (!fetch) return tl::unexpected(fetch.error());
    auto source = std::unique_ptr<Db3Source>(
        new Db3Source(std::move(database), std::move(*order), std::move(*fetch), topics));
    const auto channels = source->read_channels();
    if (!channels) return tl::unexpected(channels.error());
    source->survey_messages();
    return source;
  }

  const std::vector<RawChannel>& channels() const override { return channels_; }
  const RecordingInfo& info() const override { return info_; }
  const Diagnostics& diagnostics() const override { return diagnostics_; }

  Result<std::optional<RawMessage>> next() override {
    while (!done_) {
      const auto state = order_.step();
      if (state != Query::Step::kRow) {
        done_ = true;
        if (state == Query::Step::kFailed) lose("damaged database: the rest is not read", order_);
        break;
      }
      if (auto message = fetch(order_.integer(0), order_.integer(1))) return message;
    }
    return std::optional<RawMessage>{};
  }

 private:
  Db3Source(Database database, Query order, Query fetch, const std::vector<std::string>& topics)
      : database_(std::move(database)),
        order_(std::move(order)),
        fetch_(std::move(fetch)),
        topics_(topics.begin(), topics.end()) {
    info_.path = database_.name();
    info_.format = "rosbag2";
    info_.compression = "none";
    if (database_.log_ignored()) {
      diagnostics_.damage("write-ahead log that cannot be read: its messages are lost",
                          database_.name());
    }
  }

  void lose(std::string_view what, const Query& query) {
    diagnostics_.damage(what, database_.name() + ": " + query.problem());
  }

  std::optional<RawMessage> fetch(std::int64_t row, std::int64_t time) {
    fetch_.restart_with(row);
    if (fetch_.step() != Query::Step::kRow) {
      lose("message that cannot be read skipped", fetch_);
      return std::nullopt;
    }
    const auto channel = channel_of_.find(fetch_.integer(0));
    if (channel == channel_of_.end()) {
      diagnostics_.damage("message of an unknown topic skipped",
                          fmt::format("{}: message {}", database_.name(), row));
      return std::nullopt;
    }
    const auto& topic = channels_[channel->second].topic;
    if (!topics_.empty() && !topics_.contains(topic)) return std::nullopt;
    const auto bytes = fetch_.blob(1);
    return RawMessage{channel->second, time_from_nanos(time), {bytes.begin(), bytes.end()}};
  }

  /// Message definitions by type; schema version 4 has them, earlier ones do not.
  std::map<std::string, std::string> read_definitions() {
    std::map<std::string, std::string> definitions;
    auto query = database_.query(
        "SELECT topic_type, encoded_message_definition FROM message_definitions ORDER BY id");
    while (query && query->step() == Query::Step::kRow) {
      definitions.emplace(query->text(0), query->text(1));
    }
    return definitions;
  }

  Result<void> read_channels() {
    const auto definitions = read_definitions();
    auto query =
        database_.query("SELECT id, name, type, serialization_format FROM topics ORDER BY id");
    if (!query) return tl::unexpected(query.error());
    auto state = query->step();
    for (; state == Query::Step::kRow; state = query->step()) {
      RawChannel channel{query->text(1), query->text(2), query->text(3), {}};
      const auto definition = definitions.find(channel.type);
      if (definition != definitions.end()) channel.definition = definition->second;
      if (!channel_of_.emplace(query->integer(0), channels_.size()).second) continue;
      channels_.push_back(std::move(channel));
    }
    if (state == Query::Step::kFailed) lose("damaged table of topics read in part", *query);
    return {};
  }

  /// Counts and time span, from one pass that leaves the messages' data alone.
  void survey_messages() {
    std::vector<std::int64_t> counts(channels_.size(), 0);
    auto query = database_.query("SELECT topic_id, timestamp FROM messages");
    while (query && query->step() == Query::Step::kRow) {
      const Time time = time_from_nanos(query->integer(1));
      info_.start = std::min(info_.start.value_or(time), time);
      info_.end = std::max(info_.end.value_or(time), time);
      const auto channel = channel_of_.find(query->integer(0));
      if (channel != channel_of_.end()) ++counts[channel->second];
    }
    for (std::size_t i = 0; i < channels_.size(); ++i) {
      TopicInfo topic;
      topic.name = channels_[i].topic;
      topic.type = channels_[i].type;
      topic.encoding = channels_[i].encoding;
      topic.messages = counts[i];
      info_.topics.push_back(std::move(topic));
    }
  }

  Database database_;
  Query order_;
  Query fetch_;
  std::set<std::string> topics_;
  std::map<std::int64_t, std::uint32_t> channel_of_;  ///< by topic id
  std::vector<RawChannel> channels_;
  RecordingInfo info_;
  Diagnostics diagnostics_;
  bool done_ = false;
};

}  // namespace

Result<std::unique_ptr<RawMessageSource>> open_db3(Database database,
                                                   const std::vector<std::string>& topics) {
  return Db3Source::make(std::move(database), topics);
}

}  // namespace scanfuse::io::rosbag2
