#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "scanfuse/drivers/driver_base.hpp"
#include "scanfuse/drivers/ibeo/lux.hpp"
#include "scanfuse/geometry/angles.hpp"

namespace scanfuse::drivers::ibeo {
namespace {

constexpr std::int64_t kNtpTo1970 = 2'208'988'800;  // seconds from 1900 on
constexpr std::uint8_t kClutter = 2, kDirt = 8;
constexpr int kLayers = 4;
constexpr std::uint16_t kTicks = 11520;

/// From 1900 on; the wrap of 2036 is the clock map's to see as a jump.
Duration from_ntp(std::uint64_t ntp) {
  const auto seconds = static_cast<std::int64_t>(ntp >> 32) - kNtpTo1970;
  const double fraction = static_cast<double>(ntp & 0xFFFFFFFF) / 4294967296.0;
  return std::chrono::seconds(seconds) + Duration{std::llround(fraction * 1e9)};
}

std::uint64_t to_ntp(Time time) {
  const auto seconds = std::chrono::floor<std::chrono::seconds>(time);
  const auto since_1900 = seconds.time_since_epoch().count() + kNtpTo1970;
  const auto fraction = static_cast<double>((time - seconds).count()) * 1e-9 * 4294967296.0;
  return static_cast<std::uint64_t>(since_1900) << 32 | static_cast<std::uint64_t>(fraction);
}

double elevation_rad(int layer) { return radians(-1.2 + 0.8 * layer); }

class LuxDriver final : public DriverBase {
 public:
  using DriverBase::DriverBase;

  void take(ByteView bytes, Time received, Output& out) override {
    stream_.feed(bytes, &cut_lux, [&](ByteView message) { open(message, received, out); }, odd());
  }
  void lost() override {
    stream_.clear(odd());
    last_number_.reset();
  }

 private:
  void open(ByteView message, Time received, Output& out) {
    const LuxHead head = parse_lux_head(message);
    if (head.type != kScanData) return;
    const auto scan = parse_lux_scan(message.subspan(kLuxHeadBytes));
    if (!scan) return odd().damage("scan not understood", scan.error().message);
    const int step = last_number_ ? static_cast<std::uint16_t>(scan->number - *last_number_) : 1;
    if (step > 1 && step < 1000) odd().note("telegrams missing", sensor(), step - 1);
    last_number_ = scan->number;
    // Some firmwares leave the time of sending at 0.
    const Duration end = from_ntp(scan->end_ntp);
    const Duration sent = head.ntp == 0 ? end : std::max(end, from_ntp(head.ntp));
    const Time at = stamp(from_ntp(scan->start_ntp), sent, received);
    out.scans.push_back(to_scan(*scan, at));
  }

  Scan to_scan(const LuxScan& lux, Time at) {
    Scan scan = new_scan(at);
    const double tick_rad = 2 * kPi / lux.ticks_per_turn;
    const double took_s =
        std::clamp(to_seconds(from_ntp(lux.end_ntp) - from_ntp(lux.start_ntp)), 0.0, 1.0);
    const double swept = static_cast<double>(lux.end_angle) - lux.start_angle;
    for (const LuxPoint& point : lux.points) {
      if ((point.flags & (kClutter | kDirt)) != 0 || point.layer >= kLayers) continue;
      if (!is_range(point.range_cm * 0.01)) continue;
      Return r =
          return_at(point.range_cm * 0.01, point.angle * tick_rad, elevation_rad(point.layer));
      r.intensity = point.width_cm;
      r.layer = point.layer;
      r.echo = point.echo;
      const double share =
          swept == 0 ? 0 : (static_cast<double>(point.angle) - lux.start_angle) / swept;
      r.time_offset_s = static_cast<float>(std::clamp(share, 0.0, 1.0) * took_s);
      scan.returns.push_back(r);
    }
    return scan;
  }

  StreamCutter stream_;
  std::optional<std::uint16_t> last_number_;
};

class LuxSimulator final : public DeviceSimulator {
 public:
  Bytes answer(ByteView) override { return {}; }
  bool is_streaming() const override { return true; }

  std::vector<Telegram> encode(const Scan& scan) override {
    LuxScan lux;
    lux.number = number_++;
    lux.ticks_per_turn = kTicks;
    double first_s = 0, last_s = 0;
    for (const Return& r : scan.returns) {
      const auto point = point_of(r);
      if (!point || lux.points.size() >= 65535) continue;
      if (lux.points.empty() || r.time_offset_s < first_s) first_s = r.time_offset_s;
      last_s = std::max<double>(last_s, r.time_offset_s);
      lux.points.push_back(*point);
    }
    set_angles(scan, lux);
    lux.start_ntp = to_ntp(scan.stamp + duration_from_seconds(first_s));
    const Time end = scan.stamp + duration_from_seconds(last_s);
    lux.end_ntp = to_ntp(end);
    return {{encode_lux_scan(lux, to_ntp(end)), last_s}};
  }

 private:
  static std::optional<LuxPoint> point_of(const Return& r) {
    const double range_m = std::hypot(r.x_m, r.y_m, r.z_m);
    const auto range_cm = std::lround(range_m * 100);
    if (range_cm < 1 || range_cm > 65535 || r.layer < 0 || r.layer >= kLayers || r.echo > 15) {
      return std::nullopt;
    }
    LuxPoint point;
    point.layer = static_cast<std::uint8_t>(r.layer);
    point.echo = r.echo;
    point.angle =
        static_cast<std::int16_t>(std::lround(std::atan2(r.y_m, r.x_m) * kTicks / (2 * kPi)));
    point.range_cm = static_cast<std::uint16_t>(range_cm);
    point.width_cm = static_cast<std::uint16_t>(std::clamp(std::lround(r.intensity), 0L, 65535L));
    return point;
  }

  /// The scan runs from the angle of its first point in time to that of its last.
  static void set_angles(const Scan& scan, LuxScan& lux) {
    const auto earlier = [](const Return& a, const Return& b) {
      return a.time_offset_s < b.time_offset_s;
    };
    if (scan.returns.empty()) return;
    const auto [first, last] = std::ranges::minmax_element(scan.returns, earlier);
    const auto ticks = [](const Return& r) {
      return static_cast<std::int16_t>(std::lround(std::atan2(r.y_m, r.x_m) * kTicks / (2 * kPi)));
    };
    lux.start_angle = ticks(*first);
    lux.end_angle = ticks(*last);
  }

  std::uint16_t number_ = 0;
};

}  // namespace

std::unique_ptr<Driver> make_lux_driver(const DriverOptions& options) {
  return std::make_unique<LuxDriver>(options);
}

std::unique_ptr<DeviceSimulator> make_lux_simulator() { return std::make_unique<LuxSimulator>(); }

}  // namespace scanfuse::drivers::ibeo
