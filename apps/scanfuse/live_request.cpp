#include "live_request.hpp"

#include <cstdio>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>

#include "scanfuse/drivers/device.hpp"
#include "scanfuse/io/text/byte_source.hpp"

namespace scanfuse::app {
namespace {

constexpr std::size_t kLongestMetadata = std::size_t{1} << 24;

Result<Pose3> read_mount(const std::string& text) {
  Pose2 pose;
  int read = 0;
  if (std::sscanf(text.c_str(), "%lf,%lf,%lf%n", &pose.x_m, &pose.y_m, &pose.heading_rad, &read) !=
          3 ||
      static_cast<std::size_t>(read) != text.size()) {
    return fail(Error::Code::kMalformed, "mount '{}': write X_M,Y_M,YAW_RAD, as 3.7,0,0", text);
  }
  if (!(std::abs(pose.x_m) < 1e4 && std::abs(pose.y_m) < 1e4 && std::abs(pose.heading_rad) < 1e4)) {
    return fail(Error::Code::kOutOfRange, "mount '{}': is out of this world", text);
  }
  return Pose3::from_planar(pose);
}

Result<std::string> read_metadata(const std::string& path) {
  auto file = io::open_bytes(path);
  if (!file) return tl::unexpected(file.error());
  return io::read_start(**file, kLongestMetadata);
}

Result<pipeline::LiveSource> read_source(const std::string& url, const std::string* mount) {
  auto parsed = drivers::parse_sensor_url(url);
  if (!parsed) return tl::unexpected(parsed.error());
  pipeline::LiveSource source{std::move(*parsed), {}, {}};
  const auto& query = source.url.query;
  const auto own = query.find("mount");
  if (mount == nullptr && own != query.end()) mount = &own->second;
  if (mount != nullptr) {
    auto pose = read_mount(*mount);
    if (!pose) return tl::unexpected(pose.error());
    source.mount = *pose;
  }
  if (const auto file = query.find("metadata"); file != query.end()) {
    auto text = read_metadata(file->second);
    if (!text) return tl::unexpected(text.error());
    source.metadata = std::move(*text);
  }
  return source;
}

Result<void> check_request(const LiveRequest& request) {
  const auto wrong = [](const char* what) { return fail(Error::Code::kMalformed, "{}", what); };
  if (request.empty()) {
    return wrong("no sensor named: give sensors, as sick://192.168.0.1:2112, or --ros2 --topic");
  }
  if (!request.topics.empty() && !request.ros2) return wrong("--topic needs --ros2");
  if (!request.topics.empty() && !request.sensors.empty()) {
    return wrong("give sensors or --topic, not both: a second scanfuse can publish the sensors");
  }
  if (!request.ego_topic.empty() && request.topics.empty())
    return wrong("--ego-topic needs --topic");
  if (!request.mounts.empty() && !request.topics.empty()) {
    return wrong("--mount is for sensors; of topics tf says where they are mounted");
  }
  return {};
}

Result<LiveInput> open_sensors(const LiveRequest& request, LiveInput input) {
  if (!request.mounts.empty() && request.mounts.size() != request.sensors.size()) {
    return fail(Error::Code::kMalformed, "{} --mount for {} sensors: give one for each, or none",
                request.mounts.size(), request.sensors.size());
  }
  std::vector<pipeline::LiveSource> sources;
  for (std::size_t i = 0; i < request.sensors.size(); ++i) {
    auto source =
        read_source(request.sensors[i], request.mounts.empty() ? nullptr : &request.mounts[i]);
    if (!source) return tl::unexpected(source.error());
    sources.push_back(std::move(*source));
  }
  pipeline::LiveReaderOptions options;
  options.scans_waiting = static_cast<std::size_t>(request.waiting);
  auto reader = pipeline::LiveReader::create(std::move(sources), options);
  if (!reader) return tl::unexpected(reader.error());
  input.stream = std::move(*reader);
  return input;
}

Result<LiveInput> open_topics(const LiveRequest& request, LiveInput input) {
  pipeline::Ros2ReaderOptions options{request.topics, static_cast<std::size_t>(request.waiting)};
  if (!request.ego_topic.empty()) {
    auto name = drivers::ros2_topic_name(request.ego_topic);
    if (!name) return tl::unexpected(name.error());
    input.feed.ego_topic = *name;
    options.topics.push_back(std::move(*name));
  }
  auto reader = pipeline::Ros2Reader::create(input.bus, options);
  if (!reader) return tl::unexpected(reader.error());
  input.stream = std::move(*reader);
  return input;
}

}  // namespace

void add_live_options(CLI::App& app, LiveRequest& request) {
  app.add_option("sensors", request.sensors, "Sensors, as sick://192.168.0.1:2112");
  app.add_flag("--ros2", request.ros2,
               "Join ROS 2 (ROS_DOMAIN_ID, ROS_LOCALHOST_ONLY hold), without ROS installed");
  app.add_option("--topic", request.topics,
                 "Instead of sensors a topic of ROS 2: LaserScan, PointCloud2, Odometry, poses")
      ->allow_extra_args(false);
  app.add_option("--ego-topic", request.ego_topic,
                 "Topic of ROS 2 with the ego's motion; without one it is taken from tf");
  app.add_option("--mount", request.mounts,
                 "Sensor in the ego frame: X_M,Y_M,YAW_RAD; one for each sensor, in their order")
      ->allow_extra_args(false);
  app.add_flag("--standing", request.standing,
               "The sensors stand: look for no ego motion in the scans where nothing tells it");
  app.add_option("--seconds", request.seconds, "Stop after so long; 0: at Ctrl-C")
      ->check(CLI::Range(0.0, 1e7))
      ->capture_default_str();
  app.add_option("--waiting", request.waiting,
                 "Scans of one sensor that may wait; then the newest wins")
      ->check(CLI::Range(1, 1000))
      ->capture_default_str();
}

Result<LiveInput> open_live(const LiveRequest& request) {
  if (auto fits = check_request(request); !fits) return tl::unexpected(fits.error());
  LiveInput input;
  input.feed.may_move = !request.standing;
  if (request.ros2) {
    auto bus = drivers::Ros2Bus::join();
    if (!bus) return tl::unexpected(bus.error());
    input.bus = std::move(*bus);
  }
  return request.topics.empty() ? open_sensors(request, std::move(input))
                                : open_topics(request, std::move(input));
}

nlohmann::json sensors_json(const pipeline::LiveStream& stream) {
  nlohmann::json all = nlohmann::json::object();
  for (const auto& [name, status] : stream.status()) {
    nlohmann::json odd = nlohmann::json::object();
    for (const auto& [what, entry] : status.diagnostics.entries()) odd[what] = entry.count;
    all[name] = {{"scans", status.scans},
                 {"bytes", status.bytes},
                 {"connections", status.connections},
                 {"dropped", status.dropped},
                 {"connected", status.connected},
                 {"last_error", status.last_error},
                 {"diagnostics", odd}};
  }
  return all;
}

void print_sensors(const pipeline::LiveStream& stream) {
  for (const auto& [name, status] : stream.status()) {
    fmt::print(stderr, "scanfuse: {}: {} scans, {} bytes, {} connections, {} scans left out{}{}\n",
               name, status.scans, status.bytes, status.connections, status.dropped,
               status.last_error.empty() ? "" : "; last: ", status.last_error);
  }
}

std::string sensors_help() {
  std::string text = "Sensors:\n";
  for (const auto& device : drivers::devices()) {
    const std::string url =
        device.link == drivers::Link::kTcp ? fmt::format("{}://HOST:{}", device.scheme, device.port)
        : device.link == drivers::Link::kUdp ? fmt::format("{}://:{}", device.scheme, device.port)
                                             : fmt::format("{}:///dev/ttyUSB0", device.scheme);
    text += fmt::format("  {:<26} {}\n", url, device.doc);
  }
  return text +
         "  ?name=NAME&mount=X_M,Y_M,YAW_RAD may follow.\n"
         "  With --ros2 a sensor's scans are published too; --ros2 --topic /scan takes scans\n"
         "  from ROS 2.\n";
}

}  // namespace scanfuse::app
