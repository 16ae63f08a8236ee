#include "scanfuse/io/ros/decoding_reader.hpp"

#include <algorithm>
#include <map>
#include <utility>

#include "scanfuse/io/ros/decode.hpp"

namespace scanfuse::io {

namespace {

/// How the messages of one channel become events.
struct ChannelPlan {
  bool wanted = false;
  bool truth = false;
};

class DecodingReader final : public RecordingReader {
 public:
  DecodingReader(std::unique_ptr<RawMessageSource> source, OpenOptions options,
                 TruthDecoder truth_decoder)
      : source_(std::move(source)), options_(std::move(options)), truth_decoder_(truth_decoder) {
    catch_up();
  }

  const RecordingInfo& info() const override { return info_; }

  const Diagnostics& diagnostics() const override {
    all_diagnostics_ = source_->diagnostics();
    all_diagnostics_.merge(diagnostics_);
    return all_diagnostics_;
  }

  Result<std::optional<Event>> next() override {
    while (true) {
      auto message = source_->next();
      if (!message) return tl::unexpected(std::move(message.error()));
      if (source_->channels().size() != plans_.size()) catch_up();
      if (!*message) {
        catch_up();  // counts of a file without an index are known only now
        return std::optional<Event>{};
      }
      auto payload = decode(**message);
      if (!payload) continue;
      const auto& topic = source_->channels()[(*message)->channel].topic;
      return Event{(*message)->log_time, topic, std::move(*payload)};
    }
  }

 private:
  using Payload = decltype(Event::payload);

  bool selected(const std::string& topic) const {
    return options_.topics.empty() || std::find(options_.topics.begin(), options_.topics.end(),
                                                topic) != options_.topics.end();
  }

  bool is_truth(std::string_view type, std::string_view encoding) const {
    return truth_decoder_ != nullptr && type == "scanfuse.Truth" && encoding == "json";
  }

  /// Takes in channels and topics that the source has found since.
  void catch_up() {
    info_ = source_->info();
    for (auto& topic : info_.topics) {
      const auto kind = ros::kind_of(topic.type, topic.encoding);
      topic.is_scan = ros::is_scan(kind);
      topic.decoded = kind != ros::MessageKind::kUnknown || is_truth(topic.type, topic.encoding);
    }
    for (auto i = plans_.size(); i < source_->channels().size(); ++i) {
      const auto& channel = source_->channels()[i];
      const bool truth = is_truth(channel.type, channel.encoding);
      const bool known =
          truth || ros::kind_of(channel.type, channel.encoding) != ros::MessageKind::kUnknown;
      plans_.push_back({known && selected(channel.topic), truth});
    }
  }

  std::optional<Payload> decode(const RawMessage& message) {
    const auto& plan = plans_[message.channel];
    if (!plan.wanted) return std::nullopt;
    return plan.truth ? decode_truth(message) : decode_ros(message);
  }

  std::optional<Payload> decode_truth(const RawMessage& message) {
    auto truth = truth_decoder_(message.bytes);
    if (truth) return Payload{std::move(*truth)};
    const auto& topic = source_->channels()[message.channel].topic;
    diagnostics_.damage(kUndecodable, "scanfuse.Truth on " + topic + ": " + truth.error().message);
    return std::nullopt;
  }

  std::optional<Payload> decode_ros(const RawMessage& message) {
    const auto& channel = source_->channels()[message.channel];
    auto decoded = ros::decode_message(channel, message.bytes);
    if (!decoded) {
      diagnostics_.damage(kUndecodable, decoded.error().message);
      return std::nullopt;
    }
    for (const auto& [what, entry] : decoded->diagnostics.entries()) {
      const auto where = channel.topic + (entry.first.empty() ? "" : ": " + entry.first);
      entry.damage ? diagnostics_.damage(what, where, entry.count)
                   : diagnostics_.note(what, where, entry.count);
    }
    if (auto* scan = std::get_if<Scan>(&decoded->payload)) scan->frame = frames_[channel.topic]++;
    return std::move(decoded->payload);
  }

  static constexpr std::string_view kUndecodable = "message that cannot be decoded skipped";

  std::unique_ptr<RawMessageSource> source_;
  OpenOptions options_;
  TruthDecoder truth_decoder_;
  RecordingInfo info_;
  std::vector<ChannelPlan> plans_;
  std::map<std::string, std::int64_t> frames_;  ///< scans so far, by topic
  Diagnostics diagnostics_;
  mutable Diagnostics all_diagnostics_;
};

}  // namespace

std::unique_ptr<RecordingReader> decode_messages(std::unique_ptr<RawMessageSource> source,
                                                 const OpenOptions& options,
                                                 TruthDecoder truth_decoder) {
  return std::make_unique<DecodingReader>(std::move(source), options, truth_decoder);
}

}  // namespace scanfuse::io
