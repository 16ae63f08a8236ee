#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <optional>

#include "scanfuse/drivers/driver_base.hpp"
#include "scanfuse/drivers/ouster/ouster.hpp"
#include "scanfuse/geometry/angles.hpp"

namespace scanfuse::drivers::ouster {
namespace {

using std::chrono::nanoseconds;

constexpr std::uint32_t kEncoderTicks = 90112;

/// Channels by layer: 0 is the lowest.
std::vector<std::int16_t> layers_of(const OusterBeams& beams) {
  std::vector<std::size_t> order(beams.altitudes_deg.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, {}, [&](std::size_t i) { return beams.altitudes_deg[i]; });
  std::vector<std::int16_t> layers(order.size());
  for (std::size_t i = 0; i < order.size(); ++i) layers[order[i]] = static_cast<std::int16_t>(i);
  return layers;
}

/// As the user's manual has it: beams start on a circle around the lidar's axis.
Return place(const OusterBeams& beams, const OusterColumn& column, std::size_t channel) {
  const double encoder =
      2 * kPi * (1.0 - static_cast<double>(column.number) / beams.columns_per_turn);
  const double azimuth = encoder - radians(beams.azimuths_deg[channel]);
  const double altitude = radians(beams.altitudes_deg[channel]);
  const double from_origin = column.pixels[channel].range_mm - beams.origin_mm;
  const double x =
      from_origin * std::cos(azimuth) * std::cos(altitude) + beams.origin_mm * std::cos(encoder);
  const double y =
      from_origin * std::sin(azimuth) * std::cos(altitude) + beams.origin_mm * std::sin(encoder);
  const double z = from_origin * std::sin(altitude);
  const auto& m = beams.sensor_from_lidar;
  const auto row = [&](std::size_t i) {
    return static_cast<float>(1e-3 * (m[i] * x + m[i + 1] * y + m[i + 2] * z + m[i + 3]));
  };
  Return r;
  r.x_m = row(0);
  r.y_m = row(4);
  r.z_m = row(8);
  return r;
}

class OusterDriver final : public DriverBase {
 public:
  explicit OusterDriver(const DriverOptions& options) : DriverBase(options) {
    if (options.metadata.empty()) return;
    auto beams = parse_beams(options.metadata);
    if (beams) {
      use(std::move(*beams));
    } else {
      odd().damage("metadata not understood", beams.error().message);
    }
  }

  void take(ByteView bytes, Time received, Output& out) override {
    auto columns = parse_packet(bytes);
    if (!columns) return odd().note("datagram of another kind", columns.error().message);
    const auto channels = columns->front().pixels.size();
    if (!beams_ || beams_->altitudes_deg.size() != channels) {
      odd().note("no metadata that fit: the usual beams are assumed", sensor());
      use(usual_beams(static_cast<int>(channels)));
    }
    const Duration began = device_time<nanoseconds>(columns->front().time_ns);
    const Duration sent = device_time<nanoseconds>(columns->back().time_ns);
    const Time at = stamp(began, sent, received);
    for (const OusterColumn& column : *columns) {
      if (!column.valid || column.number >= beams_->columns_per_turn) continue;
      if (scan_ && column.frame != turn_) emit(out);
      const Duration later = device_time<nanoseconds>(column.time_ns) - began;
      add(column, at + std::clamp<Duration>(later, Duration{0}, std::chrono::seconds(1)));
      if (column.number == beams_->columns_per_turn - 1) emit(out);
    }
  }
  void lost() override { scan_.reset(); }
  void finish(Output& out) override {
    if (scan_) emit(out);
  }

 private:
  void use(OusterBeams beams) {
    beams_ = std::move(beams);
    layers_ = layers_of(*beams_);
  }

  void add(const OusterColumn& column, Time at) {
    if (!scan_) scan_ = new_scan(at);
    turn_ = column.frame;
    const auto later_s = static_cast<float>(to_seconds(at - scan_->stamp));
    for (std::size_t channel = 0; channel < column.pixels.size(); ++channel) {
      if (column.pixels[channel].range_mm == 0) continue;
      Return r = place(*beams_, column, channel);
      if (!std::isfinite(r.squared_range()) || !std::isfinite(r.z_m)) continue;
      r.intensity = column.pixels[channel].reflectivity;
      r.time_offset_s = later_s;
      r.layer = layers_[channel];
      scan_->returns.push_back(r);
    }
  }

  void emit(Output& out) {
    out.scans.push_back(std::move(*scan_));
    scan_.reset();
  }

  std::optional<OusterBeams> beams_;
  std::vector<std::int16_t> layers_;
  std::optional<Scan> scan_;
  std::uint16_t turn_ = 0;
};

class OusterSimulator final : public DeviceSimulator {
 public:
  Bytes answer(ByteView) override { return {}; }
  bool is_streaming() const override { return true; }

  std::vector<Telegram> encode(const Scan& scan) override {
    double last_s = 1e-3;
    for (const Return& r : scan.returns) last_s = std::max<double>(last_s, r.time_offset_s);
    auto columns = empty_columns(scan, last_s);
    for (const Return& r : scan.returns) add(r, columns);
    ++frame_;
    std::vector<Telegram> telegrams;
    for (std::size_t at = 0; at + kColumnsPerPacket <= columns.size(); at += kColumnsPerPacket) {
      const auto from = columns.begin() + static_cast<std::ptrdiff_t>(at);
      const double share =
          static_cast<double>(at + kColumnsPerPacket) / static_cast<double>(columns.size());
      telegrams.push_back({encode_packet({from, from + kColumnsPerPacket}), share * last_s});
    }
    return telegrams;
  }

 private:
  std::vector<OusterColumn> empty_columns(const Scan& scan, double last_s) const {
    std::vector<OusterColumn> columns(static_cast<std::size_t>(beams_.columns_per_turn));
    for (std::size_t i = 0; i < columns.size(); ++i) {
      const double share = static_cast<double>(i) / static_cast<double>(columns.size());
      columns[i].time_ns =
          ticks_of<nanoseconds>(scan.stamp + duration_from_seconds(share * last_s));
      columns[i].number = static_cast<std::uint16_t>(i);
      columns[i].frame = frame_;
      columns[i].encoder = static_cast<std::uint32_t>(share * kEncoderTicks);
      columns[i].pixels.resize(beams_.altitudes_deg.size());
    }
    return columns;
  }

  /// Where two returns fall into one pixel, the nearer stays.
  void add(const Return& r, std::vector<OusterColumn>& columns) const {
    const int channels = static_cast<int>(beams_.altitudes_deg.size());
    const double azimuth = std::atan2(r.y_m, r.x_m) + kPi;  // of the lidar, turned by half a turn
    const double range_m = std::hypot(r.x_m, r.y_m, r.z_m);
    const int turn = beams_.columns_per_turn;
    const auto column = (turn - std::lround(azimuth / (2 * kPi) * turn) + turn) % turn;
    if (r.layer < 0 || r.layer >= channels || range_m * 1e3 >= 0xFFFFF) return;
    OusterPixel& pixel = columns[static_cast<std::size_t>(column)]
                             .pixels[static_cast<std::size_t>(channels - 1 - r.layer)];
    const auto range_mm = static_cast<std::uint32_t>(std::lround(range_m * 1e3));
    if (pixel.range_mm != 0 && pixel.range_mm <= range_mm) return;
    pixel.range_mm = range_mm;
    pixel.reflectivity =
        static_cast<std::uint16_t>(std::clamp(std::lround(r.intensity), 0L, 65535L));
  }

  OusterBeams beams_ = simulated_beams();
  std::uint16_t frame_ = 0;
};

}  // namespace

std::unique_ptr<Driver> make_ouster_driver(const DriverOptions& options) {
  return std::make_unique<OusterDriver>(options);
}

std::unique_ptr<DeviceSimulator> make_ouster_simulator() {
  return std::make_unique<OusterSimulator>();
}

}  // namespace scanfuse::drivers::ouster
