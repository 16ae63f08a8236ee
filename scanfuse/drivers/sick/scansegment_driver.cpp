#include "scanfuse/drivers/sick/scansegment_driver.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include "scanfuse/drivers/driver_base.hpp"
#include "scanfuse/geometry/angles.hpp"

namespace scanfuse::drivers::sick {
namespace {

using std::chrono::microseconds;

constexpr std::uint64_t kMostSegments = 1024;
constexpr int kParts = 12;

/// Elevations a ten-thousandth of a radian apart are one layer.
int layer_key(float elevation_rad) { return static_cast<int>(std::lround(elevation_rad * 1e4F)); }

class ScanSegmentDriver final : public DriverBase {
 public:
  using DriverBase::DriverBase;

  void take(ByteView bytes, Time received, Output& out) override {
    stream_.feed(
        bytes, &cut_scansegment, [&](ByteView telegram) { open(telegram, received, out); }, odd());
  }
  void lost() override {
    stream_.clear(odd());
    segments_.clear();
  }
  void finish(Output& out) override {
    if (segments_.empty()) return;
    if (auto scan = merge()) out.scans.push_back(std::move(*scan));
    segments_.clear();
  }

 private:
  void open(ByteView telegram, Time received, Output& out) {
    if (!is_segment(telegram)) return;
    auto segment = parse_segment(telegram);
    if (!segment) return odd().damage("segment not understood", segment.error().message);
    add(std::move(*segment), received, out);
  }

  /// A revolution ends with the last segment there was in the one before, or when the next begins.
  void add(Segment segment, Time received, Output& out) {
    const bool is_next = !segments_.empty() && segments_.begin()->second.frame != segment.frame;
    if (is_next || segments_.contains(segment.number) || segments_.size() >= kMostSegments) {
      emit(out);
    }
    received_ = received;
    const auto number = segment.number;
    segments_.insert_or_assign(number, std::move(segment));
    if (known_last_ && number == *known_last_) emit(out);
  }

  void emit(Output& out) {
    const std::uint64_t last = segments_.rbegin()->first;
    const std::uint64_t first = segments_.begin()->first;
    if (first == 0 && last < kMostSegments) {
      const auto whole = std::max(known_last_.value_or(0), last) + 1;
      if (known_last_ && segments_.size() < whole) {
        odd().note("segments missing", sensor(),
                   static_cast<std::int64_t>(whole - segments_.size()));
      }
      known_last_ = whole - 1;
    }
    if (auto scan = merge()) out.scans.push_back(std::move(*scan));
    segments_.clear();
  }

  std::optional<Scan> merge() {
    std::optional<std::uint64_t> start_us;
    for (const auto& [number, segment] : segments_) {
      for (const auto& line : segment.lines) {
        start_us = std::min(start_us.value_or(line.start_us), line.start_us);
        if (std::isfinite(line.elevation_rad) && std::abs(line.elevation_rad) < 2) {
          layers_.try_emplace(layer_key(line.elevation_rad), 0);
        }
      }
    }
    if (!start_us || layers_.size() > 256) return std::nullopt;
    std::int16_t place = 0;
    for (auto& [key, layer] : layers_) layer = place++;
    const Segment& newest = segments_.rbegin()->second;
    Scan scan = new_scan(stamp(device_time<microseconds>(*start_us),
                               device_time<microseconds>(newest.transmit_us), received_));
    for (const auto& [number, segment] : segments_) {
      for (const auto& line : segment.lines) add_line(line, *start_us, scan);
    }
    return scan;
  }

  void add_line(const SegmentLine& line, std::uint64_t start_us, Scan& scan) const {
    const auto layer = layers_.find(layer_key(line.elevation_rad));
    if (!std::isfinite(line.elevation_rad) || layer == layers_.end()) return;
    const double begin_s = std::min(1e-6 * static_cast<double>(line.start_us - start_us), 10.0);
    const double took_s =
        line.stop_us > line.start_us
            ? std::min(1e-6 * static_cast<double>(line.stop_us - line.start_us), 1.0)
            : 0.0;
    for (std::size_t i = 0; i < line.beams.size(); ++i) {
      const SegmentBeam& beam = line.beams[i];
      if (!std::isfinite(beam.azimuth_rad)) continue;
      for (std::size_t echo = 0; echo < beam.ranges_m.size(); ++echo) {
        if (!is_range(beam.ranges_m[echo])) continue;
        Return r = return_at(beam.ranges_m[echo], beam.azimuth_rad, line.elevation_rad);
        if (echo < beam.strengths.size()) r.intensity = beam.strengths[echo];
        const double share = line.beams.size() > 1 ? static_cast<double>(i) /
                                                         static_cast<double>(line.beams.size() - 1)
                                                   : 0.0;
        r.time_offset_s = static_cast<float>(begin_s + share * took_s);
        r.layer = layer->second;
        r.echo = static_cast<std::uint8_t>(echo);
        scan.returns.push_back(r);
      }
    }
  }

  StreamCutter stream_;
  std::map<std::uint64_t, Segment> segments_;
  std::optional<std::uint64_t> known_last_;
  std::map<int, std::int16_t> layers_;
  Time received_;
};

class ScanSegmentSimulator final : public DeviceSimulator {
 public:
  Bytes answer(ByteView) override { return {}; }
  bool is_streaming() const override { return true; }

  std::vector<Telegram> encode(const Scan& scan) override {
    if (!scan.beams || scan.beams->layers < 1 || scan.beams->columns < 1) return {};
    const double turn_s = turn_time_s(scan);
    std::vector<Telegram> telegrams;
    ++frame_;
    for (int part = 0; part < kParts; ++part) {
      Segment segment = empty_segment(scan, part, turn_s);
      for (const Return& r : scan.returns) add(scan, r, part, segment);
      const double end_s = turn_s * (part + 1) / kParts;
      segment.transmit_us = ticks_of<microseconds>(scan.stamp + duration_from_seconds(end_s));
      telegrams.push_back({encode_compact(segment), end_s});
    }
    return telegrams;
  }

 private:
  static double turn_time_s(const Scan& scan) {
    double last_s = 0;
    for (const Return& r : scan.returns) last_s = std::max<double>(last_s, r.time_offset_s);
    return std::max(last_s, 1e-3);
  }
  static int first_column(const Scan& scan, int part) {
    return scan.beams->columns * part / kParts;
  }

  Segment empty_segment(const Scan& scan, int part, double turn_s) {
    const int from = first_column(scan, part), to = first_column(scan, part + 1);
    Segment segment;
    segment.telegram = telegrams_++;
    segment.frame = frame_;
    segment.number = static_cast<std::uint64_t>(part);
    SegmentLine line;
    const auto at = [&](double share) {
      return ticks_of<microseconds>(scan.stamp + duration_from_seconds(turn_s * share));
    };
    line.start_us = at(static_cast<double>(part) / kParts);
    line.stop_us = at(static_cast<double>(part + 1) / kParts);
    for (int column = from; column < to; ++column) {
      SegmentBeam beam;
      beam.azimuth_rad =
          static_cast<float>(scan.beams->first_azimuth_rad + column * scan.beams->step_rad);
      beam.ranges_m.assign(3, 0);
      beam.strengths.assign(3, 0);
      line.beams.push_back(std::move(beam));
    }
    segment.lines.assign(static_cast<std::size_t>(scan.beams->layers), line);
    for (std::size_t i = 0; i < segment.lines.size(); ++i) {
      const auto known = elevations_.find(static_cast<int>(i));
      if (known != elevations_.end()) segment.lines[i].elevation_rad = known->second;
    }
    return segment;
  }

  void add(const Scan& scan, const Return& r, int part, Segment& segment) {
    const int from = first_column(scan, part), to = first_column(scan, part + 1);
    if (r.beam < from || r.beam >= to || r.layer < 0 || r.layer >= scan.beams->layers) return;
    const float range_m = std::hypot(r.x_m, r.y_m, r.z_m);
    if (r.echo >= 3 || range_m > 65.5F) return;
    SegmentLine& line = segment.lines[static_cast<std::size_t>(r.layer)];
    SegmentBeam& beam = line.beams[static_cast<std::size_t>(r.beam - from)];
    beam.ranges_m[r.echo] = range_m;
    beam.strengths[r.echo] =
        static_cast<std::uint16_t>(std::clamp(std::lround(r.intensity), 0L, 65535L));
    const auto known = elevations_.try_emplace(r.layer, std::asin(r.z_m / range_m));
    line.elevation_rad = known.first->second;
  }

  std::map<int, float> elevations_;  ///< of the layers, from what they saw first
  std::uint64_t telegrams_ = 0;
  std::uint64_t frame_ = 0;
};

}  // namespace

std::unique_ptr<Driver> make_scansegment_driver(const DriverOptions& options) {
  return std::make_unique<ScanSegmentDriver>(options);
}

std::unique_ptr<DeviceSimulator> make_scansegment_simulator() {
  return std::make_unique<ScanSegmentSimulator>();
}

}  // namespace scanfuse::drivers::sick
