#include "scanfuse/io/carmen/open_carmen.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <deque>
#include <limits>
#include <map>

#include "scanfuse/io/carmen/carmen_line.hpp"
#include "scanfuse/io/text/numbers.hpp"
#include "scanfuse/io/text/stamp_watch.hpp"

namespace scanfuse::io {
namespace {

constexpr double kFarthestMount_m = 5;
constexpr Duration kUsualSweep = std::chrono::milliseconds(100);

std::string carmen_keyword(std::string_view line) {
  return std::string(line.substr(0, line.find_first_of(" \t")));
}

std::string carmen_topic(std::string_view keyword) {
  std::string topic = "/";
  for (const char c : keyword) topic += static_cast<char>(c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c);
  return topic;
}

Scan scan_from_carmen(const CarmenScan& line, const std::string& topic) {
  Scan scan;
  scan.stamp = line.stamp;
  scan.sensor = topic;
  scan.frame_id = topic.substr(1);
  const auto n = static_cast<int>(line.ranges_m.size());
  scan.beams = BeamPattern{line.first_azimuth_rad, line.step_rad, n, 1, 0, line.max_range_m};
  for (int i = 0; i < n; ++i) {
    const auto place = static_cast<std::size_t>(i);
    const double range = line.ranges_m[place];
    if (!(range > 0) || range >= line.max_range_m) continue;
    const double azimuth = line.first_azimuth_rad + i * line.step_rad;
    Return r;
    r.x_m = static_cast<float>(range * std::cos(azimuth));
    r.y_m = static_cast<float>(range * std::sin(azimuth));
    r.intensity = line.remissions.empty() ? 0 : line.remissions[place];
    r.beam = i;
    scan.returns.push_back(r);
  }
  return scan;
}

class CarmenReader final : public RecordingReader {
 public:
  CarmenReader(LineReader lines, OpenOptions options)
      : lines_(std::move(lines)), options_(std::move(options)) {
    info_.path = lines_.name();
    info_.format = "carmen";
    info_.compression = lines_.packing();
  }

  const RecordingInfo& info() const override { return info_; }
  const Diagnostics& diagnostics() const override { return diagnostics_; }

  /// Reads on until there is an event; false at the end.
  bool fill() {
    while (ready_.empty()) {
      const auto line = lines_.next(diagnostics_);
      if (!line) return false;
      take_line(*line);
    }
    return true;
  }

  Result<std::optional<Event>> next() override {
    if (!fill()) return std::nullopt;
    Event event = std::move(ready_.front());
    ready_.pop_front();
    return event;
  }

  [[nodiscard]] tl::unexpected<Error> nothing_found() const {
    if (lines_.broken()) return tl::unexpected(*lines_.broken());
    return fail(Error::Code::kMalformed, "{}: no laser or odometry line could be read{}{}",
                lines_.name(), first_fault_.empty() ? "" : "; the first: ", first_fault_);
  }

 private:
  void take_line(std::string_view line) {
    const std::string keyword = carmen_keyword(line);
    if (is_carmen_scan(keyword)) {
      auto scan = parse_carmen_scan(line);
      scan ? take_scan(std::move(*scan)) : skip(scan.error());
    } else if (keyword == "ODOM") {
      auto odometry = parse_carmen_odometry(line);
      odometry ? take_odometry(*odometry) : skip(odometry.error());
    } else if (!line.empty() && line.front() != '#' && !is_carmen_line(line)) {
      skip({Error::Code::kMalformed, fmt::format("unknown word '{:.40}'", keyword)});
    }
  }

  void skip(const Error& error) {
    const std::string place = fmt::format("{}: {}", lines_.where(), error.message);
    if (first_fault_.empty()) first_fault_ = place;
    diagnostics_.damage("bad line skipped", place);
  }

  /// Some logs never had times, or lost them to rounding: sweeps of one scanner that bear the same
  /// stamp follow each other at ten a second, for want of better.
  Time moved_on(const std::string& topic, Time stamp) {
    auto& sweep = sweeps_[topic];
    const bool again = sweep && sweep->stamp == stamp;
    const Duration late = again ? sweep->late + kUsualSweep : Duration{0};
    sweep = Sweep{stamp, late};
    if (!again || to_nanos(stamp) > std::numeric_limits<std::int64_t>::max() - late.count()) {
      return stamp;
    }
    diagnostics_.note("no time between scans: ten scans a second assumed", lines_.where());
    return stamp + late;
  }

  void take_scan(CarmenScan line) {
    const std::string topic = carmen_topic(line.keyword);
    watch_.see(topic, line.stamp, lines_.where(), diagnostics_);
    line.stamp = moved_on(topic, line.stamp);
    if (line.world_from_laser && line.world_from_robot) take_poses(line, topic);
    Scan scan = scan_from_carmen(line, topic);
    scan.frame = frame_++;
    give(line.stamp, topic, "carmen laser", true, std::move(scan));
  }

  void take_poses(const CarmenScan& line, const std::string& topic) {
    const Pose2 offset = line.world_from_robot->inverse() * *line.world_from_laser;
    auto mount = std::find_if(mounts_.begin(), mounts_.end(),
                              [&](const auto& known) { return known.topic == topic; });
    if (mount == mounts_.end()) {
      const bool plausible = std::hypot(offset.x_m, offset.y_m) <= kFarthestMount_m;
      if (!plausible) diagnostics_.note("laser far from its robot: taken as one", lines_.where());
      mount = mounts_.insert(mounts_.end(), {topic, plausible ? offset : Pose2{}});
      const Pose3 pose = Pose3::from_planar(mount->robot_from_laser);
      give(line.stamp, "/tf", "carmen mount", false,
           std::vector{TransformSample{line.stamp, "base_link", topic.substr(1), pose, true}});
    }
    const Pose2 off = mount->robot_from_laser.inverse() * offset;
    if (std::hypot(off.x_m, off.y_m) > 0.01 || std::abs(off.heading_rad) > 0.01) {
      diagnostics_.note("laser and robot pose disagree: the laser's counts", lines_.where());
    }
    const Pose2 robot = *line.world_from_laser * mount->robot_from_laser.inverse();
    give(line.stamp, "/odom", "carmen pose", false,
         PoseSample{line.stamp, "odom", "base_link", Pose3::from_planar(robot), {}, {}});
  }

  void take_odometry(const CarmenOdometry& line) {
    watch_.see("/odom_wheels", line.stamp, lines_.where(), diagnostics_);
    give(line.stamp, "/odom_wheels", "carmen ODOM", false,
         PoseSample{line.stamp, "odom_wheels", "base_link",
                    Pose3::from_planar(line.world_from_robot), line.speed_m_per_s,
                    line.yaw_rate_rad_per_s});
  }

  template <class Payload>
  void give(Time stamp, const std::string& topic, const char* type, bool is_scan, Payload payload) {
    info_.start = std::min(info_.start.value_or(stamp), stamp);
    info_.end = std::max(info_.end.value_or(stamp), stamp);
    auto known = std::find_if(info_.topics.begin(), info_.topics.end(),
                              [&](const TopicInfo& t) { return t.name == topic; });
    if (known == info_.topics.end()) {
      known =
          info_.topics.insert(info_.topics.end(), {topic, type, "text", 0, false, true, is_scan});
    }
    ++known->messages;
    const auto& wanted = options_.topics;
    const bool taken = wanted.empty() || topic == "/tf" ||
                       std::find(wanted.begin(), wanted.end(), topic) != wanted.end();
    if (taken) ready_.push_back(Event{stamp, topic, std::move(payload)});
  }

  struct Mount {
    std::string topic;
    Pose2 robot_from_laser;
  };
  struct Sweep {
    Time stamp;     ///< as written
    Duration late;  ///< what had to be added
  };

  LineReader lines_;
  OpenOptions options_;
  RecordingInfo info_;
  Diagnostics diagnostics_;
  StampWatch watch_;
  std::map<std::string, std::optional<Sweep>> sweeps_;
  std::vector<Mount> mounts_;
  std::deque<Event> ready_;
  std::string first_fault_;
  std::int64_t frame_ = 0;
};

}  // namespace

bool is_carmen_line(std::string_view line) {
  const std::string keyword = carmen_keyword(line);
  constexpr std::array kWords = {"PARAM",   "SYNC",    "ODOM",       "NEFF", "TRUEPOS", "IMU",
                                 "LASER",   "MARKER",  "ARM",        "GPS",  "SONAR",   "BUMPER",
                                 "NMEAGGA", "NMEARMC", "NMEAGGAALT", "POSE"};
  if (is_carmen_scan(keyword)) return true;
  return std::any_of(kWords.begin(), kWords.end(), [&](std::string_view word) {
    return keyword.starts_with(word) && keyword.size() <= word.size() + 1;
  });
}

Result<std::unique_ptr<RecordingReader>> open_carmen(LineReader lines, const OpenOptions& options) {
  auto reader = std::make_unique<CarmenReader>(std::move(lines), options);
  if (!reader->fill() && reader->info().topics.empty()) return reader->nothing_found();
  return reader;
}

}  // namespace scanfuse::io
