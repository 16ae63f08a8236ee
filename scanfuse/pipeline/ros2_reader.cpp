#include "scanfuse/pipeline/ros2_reader.hpp"

#include <algorithm>
#include <utility>

#include "scanfuse/io/ros/decode.hpp"

namespace scanfuse::pipeline {
namespace {

constexpr auto kLookEvery = std::chrono::milliseconds(100);
constexpr std::size_t kPosesWaiting = 1000;
constexpr const char* kNobody = "nobody publishes it";

io::ros::MessageKind kind_of(const drivers::Ros2Topic& topic) {
  return io::ros::kind_of(topic.type, "cdr");
}

}  // namespace

Result<std::unique_ptr<Ros2Reader>> Ros2Reader::create(std::shared_ptr<drivers::Ros2Bus> bus,
                                                       const Ros2ReaderOptions& options) {
  if (options.topics.empty()) return fail(Error::Code::kNotFound, "no topic named");
  std::unique_ptr<Ros2Reader> reader(new Ros2Reader(std::move(bus), options.scans_waiting));
  reader->info_.format = "ros2";
  for (const auto& text : options.topics) {
    auto name = drivers::ros2_topic_name(text);
    if (!name) return tl::unexpected(name.error());
    const auto same = [&](const Topic& other) { return other.topic.name == *name; };
    if (std::ranges::any_of(reader->topics_, same)) continue;
    reader->topics_.push_back({{*name, ""}, {}, {}, 0});
    reader->topics_.back().status.last_error = kNobody;
    reader->info_.topics.push_back({*name, "", "cdr", 0, false, true, true});
  }
  for (const auto& [name, qos] : {std::pair{"/tf", drivers::Ros2Qos::kReliable},
                                  std::pair{"/tf_static", drivers::Ros2Qos::kLatched}}) {
    reader->topics_.push_back({{name, "tf2_msgs/msg/TFMessage"}, {}, {}, 0});
    if (auto done = reader->subscribe(reader->topics_.size() - 1, qos); !done) {
      return tl::unexpected(done.error());
    }
  }
  return reader;
}

Result<void> Ros2Reader::subscribe(std::size_t index, drivers::Ros2Qos qos) {
  Topic& topic = topics_[index];
  if (!io::ros::is_scan(kind_of(topic.topic))) queue_->allow(index, kPosesWaiting);
  auto take = [queue = queue_, index](drivers::ByteView bytes) {
    queue->push({drivers::Bytes(bytes.begin(), bytes.end()), std::chrono::system_clock::now(),
                 std::chrono::steady_clock::now(), index});
  };
  const auto subscription = bus_->subscribe(topic.topic, qos, std::move(take));
  if (!subscription) return tl::unexpected(subscription.error());
  topic.subscription = *subscription;
  topic.status.last_error.clear();
  ++topic.status.connections;
  return {};
}

void Ros2Reader::look_around() {
  const auto now = std::chrono::steady_clock::now();
  if (now - looked_ < kLookEvery) return;
  looked_ = now;
  for (std::size_t i = 0; i < topics_.size(); ++i) {
    Topic& topic = topics_[i];
    if (topic.subscription) continue;
    for (const auto& type : bus_->types_of(topic.topic.name)) {
      topic.status.last_error = "a " + type + " is not understood";
      topic.topic.type = type;
      if (kind_of(topic.topic) == io::ros::MessageKind::kUnknown) continue;
      if (auto done = subscribe(i, drivers::Ros2Qos::kSensorData); !done) {
        topic.status.last_error = done.error().message;
      }
      break;
    }
  }
}

std::optional<io::Event> Ros2Reader::next_within(drivers::Milliseconds patience) {
  look_around();
  const auto message = queue_->pop(patience);
  if (!message) return std::nullopt;
  last_byte_ = message->last_byte;
  return decode(*message);
}

std::optional<io::Event> Ros2Reader::decode(const Message& message) {
  Topic& topic = topics_[message.sensor];
  Diagnostics& odd = topic.status.diagnostics;
  topic.status.bytes += static_cast<std::int64_t>(message.bytes.size());
  auto decoded =
      io::ros::decode_message({topic.topic.name, topic.topic.type, "cdr", ""}, message.bytes);
  if (!decoded) {
    odd.damage("message that cannot be decoded skipped", decoded.error().message);
    return std::nullopt;
  }
  odd.merge(decoded->diagnostics);
  ++topic.status.scans;
  if (auto* scan = std::get_if<Scan>(&decoded->payload)) scan->frame = topic.frames++;
  return io::Event{message.received, topic.topic.name, std::move(decoded->payload)};
}

std::vector<std::pair<std::string, drivers::SensorStatus>> Ros2Reader::status() const {
  std::vector<std::pair<std::string, drivers::SensorStatus>> all;
  for (std::size_t i = 0; i < topics_.size(); ++i) {
    const Topic& topic = topics_[i];
    all.emplace_back(topic.topic.name, topic.status);
    all.back().second.dropped = queue_->dropped(i);
    all.back().second.connected = topic.subscription && bus_->matched(*topic.subscription) > 0;
  }
  return all;
}

const Diagnostics& Ros2Reader::diagnostics() const {
  diagnostics_ = {};
  for (const Topic& topic : topics_) diagnostics_.merge(topic.status.diagnostics);
  return diagnostics_;
}

}  // namespace scanfuse::pipeline
