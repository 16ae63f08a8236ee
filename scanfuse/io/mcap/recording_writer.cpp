#include "scanfuse/io/mcap/recording_writer.hpp"

#include <algorithm>
#include <utility>

#include "scanfuse/io/mcap/result_messages.hpp"
#include "scanfuse/io/mcap/topic_writer.hpp"

namespace scanfuse::io {
namespace {

std::string topic_or(const Event& event, const char* usual) {
  return event.topic.empty() ? usual : event.topic;
}

}  // namespace

struct McapRecordingWriter::State {
  mcap::TopicWriter out;
  const Event* event = nullptr;

  Result<void> operator()(const Scan& scan) {
    const std::string topic = event->topic.empty() ? mcap::topic_of(scan.sensor) : event->topic;
    return out.write_cdr(topic, event->log_time, ros::encode_cdr(scan));
  }
  Result<void> operator()(const PoseSample& pose) {
    return out.write_cdr(topic_or(*event, "/odom"), event->log_time, ros::encode_cdr(pose));
  }
  Result<void> operator()(const ImuSample& imu) {
    return out.write_cdr(topic_or(*event, "/imu"), event->log_time, ros::encode_cdr(imu));
  }
  Result<void> operator()(const TruthFrame& truth) {
    return out.write_json(topic_or(*event, "/scanfuse/truth"), "scanfuse.Truth", event->log_time,
                          mcap::truth_json(truth));
  }
  Result<void> operator()(const std::vector<TransformSample>& transforms) {
    auto edges = transforms;
    const auto middle = std::stable_partition(edges.begin(), edges.end(),
                                              [](const auto& e) { return e.is_static; });
    const std::span all(edges);
    const auto fixed = static_cast<std::size_t>(middle - edges.begin());
    for (const auto& [topic, part] :
         {std::pair{"/tf_static", all.first(fixed)}, std::pair{"/tf", all.subspan(fixed)}}) {
      if (part.empty()) continue;
      if (auto done = out.write_cdr(topic, event->log_time, ros::encode_cdr(part)); !done) {
        return done;
      }
    }
    return {};
  }
};

McapRecordingWriter::McapRecordingWriter(std::unique_ptr<State> state) : state_(std::move(state)) {}
McapRecordingWriter::McapRecordingWriter(McapRecordingWriter&&) noexcept = default;
McapRecordingWriter& McapRecordingWriter::operator=(McapRecordingWriter&&) noexcept = default;
McapRecordingWriter::~McapRecordingWriter() = default;

Result<McapRecordingWriter> McapRecordingWriter::create(const std::filesystem::path& path) {
  mcap::WriterOptions options;
  options.profile = "ros2";
  auto out = mcap::TopicWriter::create(path, options);
  if (!out) return tl::unexpected(out.error());
  return McapRecordingWriter(std::make_unique<State>(State{std::move(*out), nullptr}));
}

Result<void> McapRecordingWriter::write(const Event& event) {
  state_->event = &event;
  return std::visit(*state_, event.payload);
}

Result<void> McapRecordingWriter::checkpoint() { return state_->out.checkpoint(); }

Result<void> McapRecordingWriter::finish() { return state_->out.finish(); }

}  // namespace scanfuse::io
