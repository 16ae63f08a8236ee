#include <algorithm>
#include <cmath>
#include <map>

#include "scanfuse/drivers/sick/lmd_driver.hpp"
#include "scanfuse/geometry/angles.hpp"

namespace scanfuse::drivers::sick {
namespace {

constexpr std::uint32_t kSerial = 20'260'001;

/// The strength as the device's scale of 8 or 16 bits has it.
std::uint16_t strength(float intensity) {
  return static_cast<std::uint16_t>(std::clamp(std::lround(intensity), 0L, 65535L));
}

std::uint32_t microseconds(Time time) {
  return static_cast<std::uint32_t>(
      std::chrono::floor<std::chrono::microseconds>(time).time_since_epoch().count());
}

/// One layer of a scan as a telegram of its own.
class LayerTelegram {
 public:
  LayerTelegram(const BeamPattern& beams, int echoes) {
    for (const auto* content : {"DIST", "RSSI"}) {
      for (int echo = 0; echo < echoes; ++echo) {
        LmdChannel channel;
        channel.content = content + std::to_string(echo + 1);
        // Ranges past 65 m are said in steps of two millimetres, as the LMS5xx does.
        channel.scale = content[0] == 'D' && beams.max_range_m > 65 ? 4 : 1;
        channel.first_angle =
            static_cast<std::int32_t>(std::lround(degrees(beams.first_azimuth_rad) * 1e4)) +
            900'000;
        channel.step = static_cast<std::uint16_t>(std::lround(degrees(beams.step_rad) * 1e4));
        channel.values.assign(static_cast<std::size_t>(beams.columns), 0);
        scan.channels16.push_back(std::move(channel));
      }
    }
    echoes_ = static_cast<std::size_t>(echoes);
  }

  void add(const Return& r) {
    auto& distances = scan.channels16[r.echo];
    const auto beam = static_cast<std::size_t>(r.beam);
    const double range_m = std::hypot(r.x_m, r.y_m, r.z_m);
    const auto raw = std::lround(range_m * 1e3 / distances.scale);
    if (raw < 16 || raw > 65535) return;
    distances.values[beam] = static_cast<std::uint16_t>(raw);
    scan.channels16[echoes_ + r.echo].values[beam] = strength(r.intensity);
    const double up = std::asin(std::clamp(r.z_m / range_m, -1.0, 1.0));
    scan.layer_angle = static_cast<std::int16_t>(std::lround(-degrees(up) * 100));
  }

  LmdScan scan;

 private:
  std::size_t echoes_ = 1;
};

class LmdSimulator final : public DeviceSimulator {
 public:
  Bytes answer(ByteView request) override {
    Bytes answers;
    stream_.feed(
        request, &cut_cola, [&](ByteView telegram) { reply(open_cola(telegram), answers); },
        ignored_);
    return answers;
  }
  bool is_streaming() const override { return streaming_; }

  std::vector<Telegram> encode(const Scan& scan) override {
    if (!scan.beams) return {};
    const int layers = std::max(1, scan.beams->layers);
    int echoes = 1;
    for (const Return& r : scan.returns) echoes = std::max(echoes, std::min(r.echo + 1, 5));
    std::vector<LayerTelegram> telegrams(static_cast<std::size_t>(layers),
                                         LayerTelegram(*scan.beams, echoes));
    double last_s = 0;
    for (const Return& r : scan.returns) {
      if (r.beam < 0 || r.beam >= scan.beams->columns || r.layer < 0 || r.layer >= layers) continue;
      if (r.echo >= echoes) continue;
      telegrams[static_cast<std::size_t>(r.layer)].add(r);
      last_s = std::max(last_s, static_cast<double>(r.time_offset_s));
    }
    std::vector<Telegram> all;
    for (int layer = 0; layer < layers; ++layer) {
      LmdScan& telegram = telegrams[static_cast<std::size_t>(layer)].scan;
      // A layer that sees nothing stays where it was.
      auto& angle = angles_.try_emplace(layer, telegram.layer_angle).first->second;
      telegram.layer_angle = angle;
      all.push_back({finish(telegram, scan, last_s), last_s});
    }
    return all;
  }

 private:
  void reply(const ColaTelegram& request, Bytes& answers) {
    dialect_ = request.dialect;
    const std::string_view text = text_of(request.content);
    if (text.starts_with("sEN LMDscandata ") && text.size() > 16) {
      streaming_ = text[16] == '1' || text[16] == '\1';
      Bytes content(request.content.begin(), request.content.end());
      content[2] = std::byte{'A'};
      append(answers, close_cola(dialect_, content));
    } else {
      append(answers, close_cola(dialect_, view_of(std::string("sFA ") + '\3')));
    }
  }

  Bytes finish(LmdScan& scan, const Scan& from, double last_s) {
    const auto& beams = *from.beams;
    scan.serial = kSerial;
    scan.telegram_counter = counter_++;
    scan.scan_counter = static_cast<std::uint16_t>(from.frame);
    scan.start_us = microseconds(from.stamp);
    // All beams share one speed: the time of the last one tells it.
    const double turn_s = last_s * 2 * kPi / (beams.step_rad * beams.columns);
    scan.transmit_us = microseconds(from.stamp + duration_from_seconds(last_s));
    if (turn_s > 0) {
      scan.scan_frequency = static_cast<std::uint32_t>(std::lround(std::min(100 / turn_s, 1e6)));
    }
    return encode_lmd_scan(scan, dialect_);
  }

  Cola dialect_ = Cola::kB;
  bool streaming_ = false;
  StreamCutter stream_;
  std::uint16_t counter_ = 0;
  std::map<int, std::int16_t> angles_;  ///< of the layers
  Diagnostics ignored_;
};

}  // namespace

std::unique_ptr<DeviceSimulator> make_lmd_simulator() { return std::make_unique<LmdSimulator>(); }

}  // namespace scanfuse::drivers::sick
