#include "scanfuse/serve/foxglove.hpp"

#include <algorithm>
#include <chrono>

#include "scanfuse/io/mcap/result_messages.hpp"
#include "scanfuse/io/mcap/topic_writer.hpp"
#include "scanfuse/io/ros/definitions.hpp"
#include "scanfuse/io/ros/encode_results.hpp"

namespace scanfuse::serve {
namespace {

using Clock = std::chrono::steady_clock;
constexpr auto kLook = std::chrono::milliseconds(10);
constexpr auto kIdle = std::chrono::milliseconds(250);
constexpr std::size_t kMostSubscriptions = 256;
constexpr std::uint32_t kTimeSlot = 1;
constexpr std::uint32_t kFirstSlot = 16;
constexpr std::uint32_t kMostChannels = 1 << 20;

enum FixedChannel : std::uint32_t { kTf = 1, kMarkers, kScene, kDiagnostics, kFirstSensor };

std::string_view as_text(const std::vector<std::byte>& bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

FoxgloveChannel cdr_channel(std::uint32_t id, std::string topic, const std::string& type) {
  return {id, std::move(topic), "cdr", type, io::ros::definition_of(type), "ros2msg"};
}

std::string sensor_frame(const Scan& scan) {
  return scan.frame_id.empty() ? "sensor" : scan.frame_id;
}

/// Always as a point cloud, so that a topic has one type.
io::ros::EncodedMessage cloud_of(const Scan& scan) {
  Scan cloud = scan;
  cloud.beams.reset();
  cloud.frame_id = sensor_frame(scan);
  return io::ros::encode_cdr(cloud);
}

io::ros::EncodedMessage transforms_of(const pipeline::PosedScan& posed) {
  std::vector<TransformSample> edges;
  edges.push_back({posed.scan.stamp, "world", "ego", posed.world_from_ego});
  const std::string frame = sensor_frame(posed.scan);
  if (frame != "ego" && frame != "world") {
    edges.push_back({posed.scan.stamp, "ego", frame, posed.ego_from_sensor});
  }
  return io::ros::encode_cdr(std::span<const TransformSample>(edges));
}

}  // namespace

FoxgloveDesk::FoxgloveDesk(const Workbench& bench, std::function<void(ClientId, Message)> send)
    : bench_(bench), send_(std::move(send)) {
  channels_ = {cdr_channel(kTf, "/tf", "tf2_msgs/msg/TFMessage"),
               cdr_channel(kMarkers, "/scanfuse/markers", "visualization_msgs/msg/MarkerArray"),
               {kScene, "/scanfuse/scene", "json", "foxglove.SceneUpdate",
                std::string(io::mcap::json_schema("foxglove.SceneUpdate")), "jsonschema"},
               cdr_channel(kDiagnostics, "/diagnostics", "diagnostic_msgs/msg/DiagnosticArray")};
  thread_ = std::thread([this] { loop(); });
}

FoxgloveDesk::~FoxgloveDesk() {
  {
    const std::lock_guard lock(guard_);
    stopping_ = true;
  }
  changed_.notify_all();
  thread_.join();
}

void FoxgloveDesk::open(ClientId client) {
  {
    const std::lock_guard lock(guard_);
    clients_[client];
  }
  changed_.notify_all();
}

void FoxgloveDesk::receive(ClientId client, std::string text) {
  {
    const std::lock_guard lock(guard_);
    auto& unread = clients_[client].unread;
    if (unread.size() < kMostSubscriptions) unread.push_back(std::move(text));
  }
  changed_.notify_all();
}

void FoxgloveDesk::close(ClientId client) {
  const std::lock_guard lock(guard_);
  clients_.erase(client);
}

void FoxgloveDesk::loop() {
  while (true) {
    update_channels();
    const bool anybody = attend();
    if (anybody && is_due()) {
      publish(next_++);
      continue;
    }
    std::unique_lock lock(guard_);
    if (!anybody) started_ = {};
    changed_.wait_for(lock, anybody ? kLook : kIdle, [&] { return stopping_; });
    if (stopping_) return;
  }
}

/// Sensors are known once they were heard.
void FoxgloveDesk::update_channels() {
  const auto sensors = bench_.log().sensors();
  while (sensor_channels_.size() < sensors.size()) {
    const auto id = static_cast<std::uint32_t>(kFirstSensor + sensor_channels_.size());
    channels_.push_back(cdr_channel(id, io::mcap::topic_of(sensors[sensor_channels_.size()].name),
                                    "sensor_msgs/msg/PointCloud2"));
    sensor_channels_.push_back(id);
  }
}

bool FoxgloveDesk::attend() {
  const std::lock_guard lock(guard_);
  bool anybody = false;
  for (auto& [id, client] : clients_) {
    if (!client.greeted) {
      const Time start = bench_.log().stamp(0);
      send_(id, {foxglove_server_info("scanfuse " + bench_.options().title,
                                      std::to_string(to_nanos(start))),
                 false, 0});
      client.greeted = true;
    }
    if (client.channels_told < channels_.size()) {
      send_(id, {foxglove_advertise(
                     {channels_.begin() + static_cast<std::ptrdiff_t>(client.channels_told),
                      channels_.end()}),
                 false, 0});
      client.channels_told = channels_.size();
    }
    for (const auto& text : std::exchange(client.unread, {})) hear(id, client, text);
    anybody = anybody || !client.channel_of.empty();
  }
  return anybody;
}

void FoxgloveDesk::hear(ClientId id, Client& client, const std::string& text) {
  const auto complain = [&](const std::string& what) {
    send_(id, {foxglove_status(FoxgloveLevel::kWarning, what), false, 0});
  };
  const auto request = parse_foxglove(text);
  if (!request) return complain(request.error().message);
  if (const auto* subscribe = std::get_if<FoxgloveSubscribe>(&*request)) {
    for (const auto& [subscription, channel] : subscribe->wanted) {
      const bool known =
          std::ranges::find(channels_, channel, &FoxgloveChannel::id) != channels_.end();
      if (!known) {
        complain(fmt::format("no channel {}", channel));
      } else if (client.channel_of.size() >= kMostSubscriptions) {
        complain("too many subscriptions");
      } else {
        client.channel_of[subscription] = channel;
      }
    }
  } else if (const auto* end = std::get_if<FoxgloveUnsubscribe>(&*request)) {
    for (const auto subscription : end->subscriptions) client.channel_of.erase(subscription);
  } else {
    complain("this server shows; it offers none of that");
  }
}

bool FoxgloveDesk::is_due() {
  const auto main = bench_.run(RunName::kMain);
  const std::uint32_t end = main->end();
  if (bench_.is_live()) {
    if (end == 0 || next_ >= end) return false;
    next_ = end - 1;  // what was missed is not shown late
    return true;
  }
  if (next_ >= end) {
    if (!bench_.status().done || end == 0) return false;
    next_ = 0;
    started_ = {};
  }
  const auto times = bench_.log().times_s(next_, next_ + 1);
  const double due_s = times.empty() ? 0 : times.front();
  if (started_ == Clock::time_point{}) {
    started_ = Clock::now();
    started_at_s_ = due_s;
  }
  const auto due = started_ + std::chrono::duration<double>(due_s - started_at_s_);
  const auto now = Clock::now();
  if (now - due > std::chrono::seconds(2)) started_ = {};  // the machine slept, or is too slow
  return now >= due;
}

void FoxgloveDesk::publish_to(std::uint32_t channel, Time stamp, std::string_view payload,
                              bool newest_wins) {
  const std::lock_guard lock(guard_);
  for (const auto& [id, client] : clients_) {
    std::uint32_t slot = kFirstSlot + channel;  // one for each subscription of the channel
    for (const auto& [subscription, wanted] : client.channel_of) {
      if (wanted != channel) continue;
      send_(id, {foxglove_data(subscription, stamp, payload), true, newest_wins ? slot : 0});
      slot += kMostChannels;
    }
  }
}

std::string FoxgloveDesk::diagnostics_payload(Time stamp) const {
  std::vector<io::ros::DiagnosticStatus> all;
  const BenchStatus status = bench_.status();
  io::ros::DiagnosticStatus reading{io::ros::DiagnosticLevel::kOk, "scanfuse: reading", "ok", {}};
  if (!status.problem.empty()) {
    reading.level = io::ros::DiagnosticLevel::kError;
    reading.message = status.problem;
  }
  reading.values = {{"frames", std::to_string(status.frames)}};
  all.push_back(std::move(reading));
  const Diagnostics odd = bench_.diagnostics();
  for (const auto& [what, entry] : odd.entries()) {
    all.push_back(
        {entry.damage ? io::ros::DiagnosticLevel::kError : io::ros::DiagnosticLevel::kWarn,
         "scanfuse: " + what,
         entry.first,
         {{"count", std::to_string(entry.count)}}});
  }
  const auto message = io::ros::encode_diagnostics(stamp, all);
  return std::string(as_text(message.bytes));
}

void FoxgloveDesk::publish(std::uint32_t frame) {
  const auto posed = bench_.log().get(frame);
  const auto step = bench_.run(RunName::kMain)->step(frame);
  if (!posed || !step) return;
  const Time stamp = posed->scan.stamp;
  {
    const std::lock_guard lock(guard_);
    for (const auto& [id, client] : clients_) send_(id, {foxglove_time(stamp), true, kTimeSlot});
  }
  publish_to(kTf, stamp, as_text(transforms_of(*posed).bytes), false);
  const auto sensor = bench_.log().sensor_of(frame);
  if (sensor < sensor_channels_.size()) {
    publish_to(sensor_channels_[sensor], stamp, as_text(cloud_of(posed->scan).bytes), true);
  }
  publish_to(kMarkers, stamp, as_text(io::ros::encode_markers(*step).bytes), true);
  publish_to(kScene, stamp, scene_.update(*step), false);
  publish_to(kDiagnostics, stamp, diagnostics_payload(stamp), true);
}

}  // namespace scanfuse::serve
