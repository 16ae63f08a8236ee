#include "scanfuse/io/carmen/carmen_line.hpp"

#include <cmath>

#include "scanfuse/io/text/numbers.hpp"

namespace scanfuse::io {
namespace {

constexpr std::int64_t kMostReadings = 100'000;

/// Hands out the words of a line one by one and remembers the first that was not as it should be.
class CarmenWords {
 public:
  explicit CarmenWords(std::string_view line) : rest_(line) {}

  std::string_view word(std::string_view what) {
    while (!rest_.empty() && is_blank(rest_.front())) rest_.remove_prefix(1);
    std::size_t size = 0;
    while (size < rest_.size() && !is_blank(rest_[size])) ++size;
    const std::string_view taken = rest_.substr(0, size);
    rest_.remove_prefix(size);
    if (taken.empty() && fault_.empty()) fault_ = fmt::format("the line ends before its {}", what);
    return taken;
  }
  double number(std::string_view what) {
    const auto text = word(what);
    const auto value = parse_number(text);
    if (value && std::abs(*value) <= kFarthestCoordinate_m) return *value;
    blame(what, text);
    return 0;
  }
  std::size_t count(std::string_view what) {
    const auto text = word(what);
    const auto value = parse_whole(text);
    if (value && *value >= 0 && *value <= kMostReadings) return static_cast<std::size_t>(*value);
    blame(what, text);
    return 0;
  }
  Pose2 pose(std::string_view what) {
    const double x = number(what), y = number(what);
    return {x, y, wrap_pi(number(what))};
  }
  std::vector<float> readings(std::size_t wanted, std::string_view what) {
    std::vector<float> values;
    for (std::size_t i = 0; i < wanted && fault_.empty(); ++i) {
      values.push_back(static_cast<float>(number(what)));
    }
    return values;
  }
  Time stamp() {
    const auto text = word("ipc timestamp");
    const auto value = parse_seconds(text);
    if (!value) blame("ipc timestamp", text);
    return Time{value.value_or(Duration{0})};
  }
  [[nodiscard]] const std::string& fault() const { return fault_; }
  void blame(std::string_view what, std::string_view text) {
    if (fault_.empty()) fault_ = fmt::format("{} '{:.40}' is not a fitting number", what, text);
  }

 private:
  static bool is_blank(char c) { return c == ' ' || c == '\t'; }
  std::string_view rest_;
  std::string fault_;
};

/// FLASER, RLASER: half a circle, no angles given.
void read_old_laser(CarmenWords& words, CarmenScan& scan) {
  const std::size_t n = words.count("number of readings");
  scan.ranges_m = words.readings(n, "range");
  scan.first_azimuth_rad = -kPi / 2;
  const double steps = n % 2 == 0 ? static_cast<double>(n) : static_cast<double>(n) - 1;
  scan.step_rad = kPi / std::max(1.0, steps);
  scan.max_range_m = n <= 181 ? 50 : 80;
  scan.world_from_laser = words.pose("laser pose");
  scan.world_from_robot = words.pose("robot pose");
}

/// ROBOTLASERn and RAWLASERn up to the remissions.
void read_described_laser(CarmenWords& words, CarmenScan& scan) {
  words.number("laser type");
  scan.first_azimuth_rad = words.number("start angle");
  const double field_of_view_rad = words.number("field of view");
  scan.step_rad = words.number("angular resolution");
  scan.max_range_m = words.number("maximum range");
  words.number("accuracy");
  words.number("remission mode");
  const std::size_t n = words.count("number of readings");
  scan.ranges_m = words.readings(n, "range");
  scan.remissions = words.readings(words.count("number of remissions"), "remission");
  if (scan.remissions.size() != scan.ranges_m.size()) scan.remissions.clear();
  if (scan.step_rad <= 0 && n > 1) scan.step_rad = field_of_view_rad / static_cast<double>(n - 1);
  const bool fits = scan.step_rad > 0 && scan.step_rad * static_cast<double>(n) < 6.4;
  if (!fits && n > 1) words.blame("angular resolution", fmt::format("{}", scan.step_rad));
  if (scan.max_range_m <= 0) scan.max_range_m = 80;
}

}  // namespace

bool is_carmen_scan(std::string_view keyword) {
  return keyword == "FLASER" || keyword == "RLASER" || keyword.starts_with("ROBOTLASER") ||
         keyword.starts_with("RAWLASER");
}

Result<CarmenScan> parse_carmen_scan(std::string_view line) {
  CarmenWords words(line);
  CarmenScan scan;
  scan.keyword = words.word("keyword");
  if (scan.keyword == "FLASER" || scan.keyword == "RLASER") {
    read_old_laser(words, scan);
  } else {
    read_described_laser(words, scan);
    if (scan.keyword.starts_with("ROBOT")) {
      scan.world_from_laser = words.pose("laser pose");
      scan.world_from_robot = words.pose("robot pose");
      for (const auto* what : {"laser tv", "laser rv", "forward safety distance",
                               "side safety distance", "turn axis"}) {
        words.number(what);
      }
    }
  }
  scan.stamp = words.stamp();
  if (!words.fault().empty()) return fail(Error::Code::kMalformed, "{}", words.fault());
  return scan;
}

Result<CarmenOdometry> parse_carmen_odometry(std::string_view line) {
  CarmenWords words(line);
  words.word("keyword");
  CarmenOdometry odometry;
  odometry.world_from_robot = words.pose("robot pose");
  odometry.speed_m_per_s = words.number("speed");
  odometry.yaw_rate_rad_per_s = words.number("yaw rate");
  words.number("acceleration");
  odometry.stamp = words.stamp();
  if (!words.fault().empty()) return fail(Error::Code::kMalformed, "{}", words.fault());
  return odometry;
}

}  // namespace scanfuse::io
