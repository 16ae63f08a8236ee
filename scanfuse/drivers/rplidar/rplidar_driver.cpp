#include <algorithm>
#include <cmath>
#include <vector>

#include "scanfuse/drivers/driver_base.hpp"
#include "scanfuse/drivers/rplidar/rplidar.hpp"
#include "scanfuse/geometry/angles.hpp"

namespace scanfuse::drivers::rplidar {
namespace {

constexpr std::byte kRequest{0xA5}, kStop{0x25}, kScan{0x20}, kExpress{0x82};
constexpr std::size_t kMostSamples = 20'000;
constexpr double kTurnQ6 = 360 * 64;

class RplidarDriver final : public DriverBase {
 public:
  RplidarDriver(const DriverOptions& options, Mode wanted) : DriverBase(options), wanted_(wanted) {}

  Bytes hello() override {
    if (wanted_ == Mode::kStandard) return {kRequest, kScan};
    // Five bytes that are to be 0, and their exclusive or with those before.
    return {kRequest,     kExpress,     std::byte{5},
            std::byte{0}, std::byte{0}, std::byte{0},
            std::byte{0}, std::byte{0}, std::byte{0xA5 ^ 0x82 ^ 5}};
  }
  Bytes farewell() override { return {kRequest, kStop}; }

  void take(ByteView bytes, Time received, Output& out) override {
    stream_.feed(bytes, cutter_, [&](ByteView telegram) { open(telegram, received, out); }, odd());
  }
  void lost() override {
    stream_.clear(odd());
    cutter_.set(Mode::kNone);
    samples_.clear();
    last_capsule_.reset();
  }

 private:
  struct Sample {
    double angle_q6 = 0;
    double range_m = 0;
    std::uint8_t quality = 0;
  };

  void open(ByteView telegram, Time received, Output& out) {
    if (is_descriptor(telegram)) return cutter_.set(mode_of_descriptor(telegram));
    if (cutter_.mode() == Mode::kExpress) {
      const auto capsule = parse_capsule(telegram);
      if (capsule) add(*capsule, received, out);
      return;
    }
    const auto node = parse_node(telegram);
    if (!node) return;
    if (node->starts_turn) emit(received, out);
    add({static_cast<double>(node->angle_q6), node->range_q2 * 0.25e-3, node->quality});
  }

  void add(const Capsule& capsule, Time received, Output& out) {
    if (last_capsule_ && !capsule.restarted) {
      double turned = static_cast<double>(capsule.start_q6) - last_capsule_->start_q6;
      if (turned < 0) turned += kTurnQ6;
      for (std::size_t k = 0; k < 32; ++k) {
        double angle = last_capsule_->start_q6 + turned * static_cast<double>(k + 1) / 32;
        if (angle >= kTurnQ6) angle -= kTurnQ6;
        if (angle < last_angle_q6_ - kTurnQ6 / 2) emit(received, out);
        last_angle_q6_ = angle;
        add({angle - last_capsule_->corrections_q3[k] * 8.0, last_capsule_->ranges_mm[k] * 1e-3,
             last_capsule_->ranges_mm[k] > 0 ? std::uint8_t{47} : std::uint8_t{0}});
      }
    }
    last_capsule_ = capsule;
  }

  void add(const Sample& sample) {
    if (samples_.size() < kMostSamples) samples_.push_back(sample);
  }

  /// A turn ended now and began when the one before ended.
  void emit(Time received, Output& out) {
    if (!samples_.empty() && began_) {
      const double took_s = std::clamp(to_seconds(received - *began_), 0.0, 2.0);
      Scan scan = new_scan(received - duration_from_seconds(took_s));
      const double between_s = took_s / static_cast<double>(samples_.size());
      for (std::size_t i = 0; i < samples_.size(); ++i) {
        if (!is_range(samples_[i].range_m)) continue;
        Return r = return_at(samples_[i].range_m, wrap_pi(-radians(samples_[i].angle_q6 / 64)), 0);
        r.intensity = samples_[i].quality;
        r.time_offset_s = static_cast<float>(static_cast<double>(i) * between_s);
        scan.returns.push_back(r);
      }
      out.scans.push_back(std::move(scan));
    }
    samples_.clear();
    began_ = received;
  }

  Mode wanted_;
  StreamCutter stream_;
  RplidarCutter cutter_;
  std::vector<Sample> samples_;
  std::optional<Capsule> last_capsule_;
  double last_angle_q6_ = 0;  ///< of a capsule's sample
  std::optional<Time> began_;
};

class RplidarSimulator final : public DeviceSimulator {
 public:
  Bytes answer(ByteView request) override {
    append(heard_, request);
    Bytes answers;
    std::size_t place = 0;
    while (place + 1 < heard_.size()) {
      if (heard_[place] != kRequest) {
        ++place;
        continue;
      }
      const std::byte command = heard_[place + 1];
      const std::size_t size = command == kExpress ? 9 : 2;
      if (place + size > heard_.size()) break;
      if (command == kStop) mode_ = Mode::kNone;
      if (command == kScan || command == kExpress) {
        mode_ = command == kScan ? Mode::kStandard : Mode::kExpress;
        restarted_ = true;
        append(answers, descriptor(mode_));
      }
      place += size;
    }
    heard_.erase(heard_.begin(), heard_.begin() + static_cast<std::ptrdiff_t>(place));
    return answers;
  }
  bool is_streaming() const override { return mode_ != Mode::kNone; }

  std::vector<Telegram> encode(const Scan& scan) override {
    auto turn = turn_of(scan);
    return mode_ == Mode::kExpress ? capsules_of(turn) : nodes_of(turn);
  }

 private:
  struct Sample {
    double angle_deg = 0;  ///< clockwise, 0 to 360
    double range_m = 0;
    double quality = 0;
    double after_s = 0;
  };

  /// A sample for each column of the pattern, in the order of time, also where nothing is seen.
  static std::vector<Sample> turn_of(const Scan& scan) {
    std::vector<Sample> turn;
    if (!scan.beams || scan.beams->columns < 1) return turn;
    const auto columns = static_cast<std::size_t>(scan.beams->columns);
    double last_s = 0;
    for (const Return& r : scan.returns) last_s = std::max<double>(last_s, r.time_offset_s);
    turn.resize(columns);
    for (std::size_t i = 0; i < columns; ++i) {
      const auto column = static_cast<double>(columns - 1 - i);  // it turns clockwise
      const double azimuth = scan.beams->first_azimuth_rad + column * scan.beams->step_rad;
      const double angle = std::fmod(degrees(-azimuth) + 720, 360);
      turn[i] = {angle, 0, 0, last_s * static_cast<double>(i + 1) / static_cast<double>(columns)};
    }
    for (const Return& r : scan.returns) {
      if (r.beam < 0 || r.beam >= scan.beams->columns || r.echo > 0) continue;
      Sample& sample = turn[columns - 1 - static_cast<std::size_t>(r.beam)];
      sample.range_m = std::hypot(r.x_m, r.y_m);
      sample.quality = r.intensity;
    }
    return turn;
  }

  static std::vector<Telegram> nodes_of(const std::vector<Sample>& turn) {
    std::vector<Telegram> telegrams;
    Telegram telegram;
    for (std::size_t i = 0; i < turn.size(); ++i) {
      Node node;
      node.starts_turn = i == 0;
      node.angle_q6 = static_cast<std::uint16_t>(std::lround(turn[i].angle_deg * 64));
      node.range_q2 =
          static_cast<std::uint16_t>(std::clamp(std::lround(turn[i].range_m * 4000), 0L, 65535L));
      node.quality = static_cast<std::uint8_t>(std::clamp(std::lround(turn[i].quality), 0L, 63L));
      append(telegram.bytes, encode_node(node));
      telegram.after_s = turn[i].after_s;
      if (telegram.bytes.size() >= 50 * kNodeBytes || i + 1 == turn.size()) {
        telegrams.push_back(std::move(telegram));
        telegram = {};
      }
    }
    return telegrams;
  }

  std::vector<Telegram> capsules_of(const std::vector<Sample>& turn) {
    std::vector<Telegram> telegrams;
    for (const Sample& sample : turn) {
      samples_.push_back(sample);
      if (samples_.size() <= 32) continue;
      // A capsule tells of the samples after its start, up to the start of the next.
      Capsule capsule;
      capsule.restarted = std::exchange(restarted_, false);
      capsule.start_q6 =
          static_cast<std::uint16_t>(std::lround(samples_[0].angle_deg * 64)) & 0x7FFF;
      for (std::size_t k = 0; k < 32; ++k) {
        const long range_mm = std::lround(samples_[k + 1].range_m * 1000);
        capsule.ranges_mm[k] = static_cast<std::uint16_t>(std::clamp(range_mm, 0L, 16383L));
      }
      telegrams.push_back({encode_capsule(capsule), sample.after_s});
      samples_.erase(samples_.begin(), samples_.begin() + 32);
    }
    return telegrams;
  }

  Mode mode_ = Mode::kNone;
  bool restarted_ = false;
  Bytes heard_;
  std::vector<Sample> samples_;
};

}  // namespace

std::unique_ptr<Driver> make_rplidar_driver(const DriverOptions& options) {
  return std::make_unique<RplidarDriver>(options, Mode::kStandard);
}
std::unique_ptr<Driver> make_express_driver(const DriverOptions& options) {
  return std::make_unique<RplidarDriver>(options, Mode::kExpress);
}
std::unique_ptr<DeviceSimulator> make_rplidar_simulator() {
  return std::make_unique<RplidarSimulator>();
}

}  // namespace scanfuse::drivers::rplidar
