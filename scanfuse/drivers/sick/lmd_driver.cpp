#include "scanfuse/drivers/sick/lmd_driver.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "scanfuse/drivers/driver_base.hpp"
#include "scanfuse/geometry/angles.hpp"

namespace scanfuse::drivers::sick {
namespace {

constexpr std::uint16_t kFirstDistance = 16;  // smaller values are codes
constexpr double kSlowestTurnS = 1;
constexpr Duration kCounterPeriod = std::chrono::microseconds(std::int64_t{1} << 32);

double angle_rad(std::int64_t ten_thousandths) { return radians(ten_thousandths * 1e-4); }

double elevation_rad(const LmdScan& scan) { return radians(-0.01 * scan.layer_angle); }

double azimuth_rad(const LmdChannel& channel, std::size_t i) {
  const auto at = channel.first_angle + channel.step * static_cast<std::int64_t>(i);
  return angle_rad(at - 900'000);
}

/// Seconds between two beams, 0 where the device does not say how fast it turns.
double beam_s(const LmdScan& scan, const LmdChannel& channel) {
  if (scan.scan_frequency == 0) return 0;
  const double whole_s = 1 / (scan.scan_frequency * 0.01);
  return std::min(whole_s, kSlowestTurnS) * channel.step / 3'600'000.0;
}

void add_echo(const LmdScan& scan, int echo, std::vector<Return>& returns) {
  const std::string number = std::to_string(echo + 1);
  const LmdChannel* distances = scan.find("DIST" + number);
  if (distances == nullptr) return;
  const LmdChannel* strengths = scan.find("RSSI" + number);
  const double up = elevation_rad(scan), between_s = beam_s(scan, *distances);
  for (std::size_t i = 0; i < distances->values.size(); ++i) {
    if (distances->values[i] < kFirstDistance) continue;
    const double range_m = distances->value(i) * 1e-3;
    if (!is_range(range_m)) continue;
    Return r = return_at(range_m, azimuth_rad(*distances, i), up);
    if (strengths != nullptr && i < strengths->values.size()) {
      r.intensity = static_cast<float>(strengths->value(i));
      if (!std::isfinite(r.intensity)) r.intensity = 0;
    }
    r.time_offset_s = static_cast<float>(static_cast<double>(i) * between_s);
    r.beam = static_cast<std::int32_t>(i);
    r.echo = static_cast<std::uint8_t>(echo);
    returns.push_back(r);
  }
}

class LmdDriver final : public DriverBase {
 public:
  using DriverBase::DriverBase;

  Bytes hello() override {
    if (!answered_) dialect_ = dialect_ == Cola::kB ? Cola::kA : Cola::kB;
    return scan_request(dialect_, true);
  }
  Bytes farewell() override { return scan_request(dialect_, false); }

  void take(ByteView bytes, Time received, Output& out) override {
    stream_.feed(
        bytes, &cut_cola, [&](ByteView telegram) { open(open_cola(telegram), received, out); },
        odd());
  }

  void finish(Output& out) override {
    if (!layers_.empty()) emit(out);
  }

  void lost() override {
    stream_.clear(odd());
    layers_.clear();
    last_counter_.reset();
  }

 private:
  struct LayerScan {
    Time stamp;
    LmdScan scan;
  };

  void open(const ColaTelegram& telegram, Time received, Output& out) {
    answered_ = true;
    dialect_ = telegram.dialect;
    if (!is_lmd_scan(telegram.content)) return;
    auto scan = parse_lmd_scan(telegram);
    if (!scan) return odd().damage("scan telegram not understood", scan.error().message);
    watch_counter(scan->telegram_counter);
    const Time stamp = stamp_of(*scan, received);
    add({stamp, std::move(*scan)}, out);
  }

  Time stamp_of(const LmdScan& scan, Time received) {
    const Duration sent = counter_.unwrap(std::chrono::microseconds(scan.transmit_us));
    const std::uint32_t took_us = scan.transmit_us - scan.start_us;
    return stamp(sent - std::chrono::microseconds(took_us), sent, received);
  }

  void watch_counter(std::uint16_t counter) {
    const auto step = last_counter_ ? static_cast<std::uint16_t>(counter - *last_counter_) : 1;
    if (step > 1 && step < 1000) odd().note("telegrams missing", sensor(), step - 1);
    last_counter_ = counter;
  }

  /// A revolution is whole when every layer of the one before is there, or when one comes again.
  void add(LayerScan layer, Output& out) {
    const auto angle = layer.scan.layer_angle;
    if (std::ranges::any_of(layers_, [&](auto& l) { return l.scan.layer_angle == angle; })) {
      emit(out);
    }
    layers_.push_back(std::move(layer));
    if (layers_.size() == known_.size()) emit(out);
  }

  void emit(Output& out) {
    // Positive is down, 0 is the lowest layer.
    for (const auto& layer : layers_) known_.insert(-layer.scan.layer_angle);
    Scan scan = new_scan(layers_.front().stamp);
    for (const auto& [stamp, layer] : layers_) {
      const auto place = std::distance(known_.begin(), known_.find(-layer.layer_angle));
      const auto later_s = static_cast<float>(to_seconds(stamp - scan.stamp));
      for (Return r : returns_of(layer)) {
        r.layer = static_cast<std::int16_t>(place);
        r.time_offset_s += later_s;
        scan.returns.push_back(r);
      }
    }
    scan.beams = beams_of(layers_.front().scan);
    if (scan.beams) scan.beams->layers = static_cast<int>(known_.size());
    layers_.clear();
    out.scans.push_back(std::move(scan));
  }

  Cola dialect_ = Cola::kA;
  bool answered_ = false;
  StreamCutter stream_;
  Unwrapper counter_{kCounterPeriod};
  std::optional<std::uint16_t> last_counter_;
  std::set<int> known_;
  std::vector<LayerScan> layers_;
};

}  // namespace

std::vector<Return> returns_of(const LmdScan& scan) {
  std::vector<Return> returns;
  for (int echo = 0; echo < 5; ++echo) add_echo(scan, echo, returns);
  return returns;
}

std::optional<BeamPattern> beams_of(const LmdScan& scan) {
  const LmdChannel* distances = scan.find("DIST1");
  if (distances == nullptr || distances->step == 0 || distances->values.empty()) {
    return std::nullopt;
  }
  BeamPattern beams;
  beams.first_azimuth_rad = azimuth_rad(*distances, 0);
  beams.step_rad = angle_rad(distances->step);
  beams.columns = static_cast<int>(distances->values.size());
  const double farthest_m = distances->scale * 65535 * 1e-3;
  beams.max_range_m = is_range(farthest_m) ? farthest_m : 0;
  return beams;
}

std::unique_ptr<Driver> make_lmd_driver(const DriverOptions& options) {
  return std::make_unique<LmdDriver>(options);
}

}  // namespace scanfuse::drivers::sick
