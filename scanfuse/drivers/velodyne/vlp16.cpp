#include "scanfuse/drivers/velodyne/vlp16.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "scanfuse/drivers/driver_base.hpp"
#include "scanfuse/geometry/angles.hpp"

namespace scanfuse::drivers::velodyne {
namespace {

using std::chrono::microseconds;

constexpr std::uint16_t kBlockFlag = 0xEEFF;  // FF EE, as a little endian number
constexpr Duration kHour = std::chrono::hours(1);
constexpr int kTurn = 36000;
constexpr std::size_t kMostReturns = 400'000;

class Vlp16Driver final : public DriverBase {
 public:
  using DriverBase::DriverBase;

  void take(ByteView bytes, Time received, Output& out) override {
    if (bytes.size() != kVlp16PacketBytes) {
      // Where the sensor is comes along, from the same address to the next port.
      return odd().note("datagram of another kind", sensor());
    }
    const auto packet = parse_vlp16(bytes);
    if (!packet) return odd().damage("packet not understood", packet.error().message);
    const Duration began = counter_.unwrap(microseconds(packet->time_us % 3'600'000'000U));
    const Duration sent = began + duration_from_seconds(firing_s(*packet, 11, 1));
    const Time at = stamp(began, sent, received);
    for (int block = 0; block < 12; ++block) add_block(*packet, block, at, out);
  }
  void lost() override { scan_.reset(); }
  void finish(Output& out) override {
    if (scan_) emit(out);
  }

 private:
  static bool is_dual(const Vlp16Packet& packet) { return packet.mode == ReturnMode::kDual; }

  /// After the packet's time. Two blocks of one azimuth are fired at once in dual mode.
  static double firing_s(const Vlp16Packet& packet, int block, int firing) {
    const int before = is_dual(packet) ? block / 2 : block;
    return 1e-6 * kFiringUs * (2 * before + firing);
  }

  /// Hundredths of a degree from this block to the next in time.
  static double step_of(const Vlp16Packet& packet, int block) {
    const int stride = is_dual(packet) ? 2 : 1;
    const int from = block + stride < 12 ? block : block - stride;
    const int step = packet.blocks[static_cast<std::size_t>(from + stride)].azimuth -
                     packet.blocks[static_cast<std::size_t>(from)].azimuth;
    const int turned = (step + kTurn) % kTurn;
    return turned > kTurn / 2 ? 0 : turned;
  }

  void add_block(const Vlp16Packet& packet, int block, Time at, Output& out) {
    const Vlp16Block& data = packet.blocks[static_cast<std::size_t>(block)];
    const bool is_second = is_dual(packet) && block % 2 == 1;
    if (!is_second) {
      const int from_behind = (data.azimuth + kTurn / 2) % kTurn;
      if (scan_ && from_behind + kTurn / 2 < last_from_behind_) emit(out);
      last_from_behind_ = from_behind;
    }
    const double began_s = firing_s(packet, block, 0);
    if (!scan_) scan_ = new_scan(at + duration_from_seconds(began_s));
    const double step = step_of(packet, block);
    for (int firing = 0; firing < 2; ++firing) {
      for (int channel = 0; channel < kChannels; ++channel) {
        const auto place = static_cast<std::size_t>(firing * kChannels + channel);
        const Vlp16Echo& echo = data.echoes[place];
        if (echo.range_2mm == 0 || scan_->returns.size() >= kMostReturns) continue;
        if (is_second && same_echo(packet, block, place)) continue;
        const double turned_us = firing * kFiringUs + channel * kChannelUs;
        const double azimuth_deg = 0.01 * (data.azimuth + step * turned_us / (2 * kFiringUs));
        Return r = return_at(echo.range_2mm * 0.002, wrap_pi(-radians(azimuth_deg)),
                             radians(elevation_deg(channel)));
        r.intensity = echo.reflectivity;
        r.time_offset_s =
            static_cast<float>(to_seconds(at - scan_->stamp) + began_s + 1e-6 * turned_us);
        r.layer = static_cast<std::int16_t>(layer_of(channel));
        r.echo = is_second ? 1 : 0;
        scan_->returns.push_back(r);
      }
    }
  }

  /// Where there is one echo only, dual mode says it twice.
  static bool same_echo(const Vlp16Packet& packet, int block, std::size_t place) {
    const auto at = static_cast<std::size_t>(block);
    return packet.blocks[at].echoes[place].range_2mm ==
           packet.blocks[at - 1].echoes[place].range_2mm;
  }

  void emit(Output& out) {
    out.scans.push_back(std::move(*scan_));
    scan_.reset();
  }

  Unwrapper counter_{kHour};
  std::optional<Scan> scan_;
  int last_from_behind_ = 0;
};

class Vlp16Simulator final : public DeviceSimulator {
 public:
  Bytes answer(ByteView) override { return {}; }
  bool is_streaming() const override { return true; }

  std::vector<Telegram> encode(const Scan& scan) override {
    if (!scan.beams || scan.beams->columns < 1) return {};
    const int columns = scan.beams->columns;
    const auto by_column = sort_returns(scan);
    std::vector<Telegram> telegrams;
    for (int first = 0; first + 24 <= columns; first += 24) {
      Vlp16Packet packet;
      for (int firing = 0; firing < 24; ++firing) {
        fire(scan, by_column, columns - 1 - first - firing, firing, packet);
      }
      const double began_s = 1e-6 * kFiringUs * first;
      const auto us = ticks_of<microseconds>(scan.stamp + duration_from_seconds(began_s));
      packet.time_us = static_cast<std::uint32_t>(us % 3'600'000'000);
      telegrams.push_back({encode_vlp16(packet), began_s + 24e-6 * kFiringUs});
    }
    return telegrams;
  }

 private:
  /// Nearest echo of each column and layer.
  static std::vector<const Return*> sort_returns(const Scan& scan) {
    const auto columns = static_cast<std::size_t>(scan.beams->columns);
    std::vector<const Return*> all(columns * kChannels, nullptr);
    for (const Return& r : scan.returns) {
      const bool fits = r.beam >= 0 && r.beam < scan.beams->columns && r.layer >= 0 &&
                        r.layer < kChannels && r.echo == 0;
      if (fits) all[static_cast<std::size_t>(r.beam * kChannels + r.layer)] = &r;
    }
    return all;
  }

  static void fire(const Scan& scan, const std::vector<const Return*>& by_column, int column,
                   int firing, Vlp16Packet& packet) {
    Vlp16Block& block = packet.blocks[static_cast<std::size_t>(firing / 2)];
    if (firing % 2 == 0) {
      const double azimuth = scan.beams->first_azimuth_rad + column * scan.beams->step_rad;
      block.azimuth =
          static_cast<std::uint16_t>(std::lround(degrees(-azimuth) * 100 + 2 * kTurn) % kTurn);
    }
    for (int channel = 0; channel < kChannels; ++channel) {
      const Return* r = by_column[static_cast<std::size_t>(column * kChannels + layer_of(channel))];
      if (r == nullptr) continue;
      auto& echo = block.echoes[static_cast<std::size_t>(firing % 2 * kChannels + channel)];
      const auto raw = std::lround(std::hypot(r->x_m, r->y_m, r->z_m) / 0.002);
      echo.range_2mm = raw > 65535 ? std::uint16_t{0} : static_cast<std::uint16_t>(raw);
      echo.reflectivity =
          static_cast<std::uint8_t>(std::clamp(std::lround(r->intensity), 0L, 255L));
    }
  }
};

}  // namespace

int elevation_deg(int channel) { return channel % 2 == 0 ? channel - 15 : channel; }

Result<Vlp16Packet> parse_vlp16(ByteView datagram) {
  if (datagram.size() != kVlp16PacketBytes) {
    return fail(Error::Code::kMalformed, "a packet of {} bytes, not of 1206", datagram.size());
  }
  LittleReader in(datagram);
  Vlp16Packet packet;
  for (Vlp16Block& block : packet.blocks) {
    if (in.read<std::uint16_t>() != kBlockFlag) {
      return fail(Error::Code::kMalformed, "byte {}: no block starts there", in.place() - 2);
    }
    block.azimuth = static_cast<std::uint16_t>(in.read<std::uint16_t>() % kTurn);
    for (Vlp16Echo& echo : block.echoes) {
      echo.range_2mm = in.read<std::uint16_t>();
      echo.reflectivity = in.read<std::uint8_t>();
    }
  }
  packet.time_us = in.read<std::uint32_t>();
  packet.mode = static_cast<ReturnMode>(in.read<std::uint8_t>());
  packet.product = in.read<std::uint8_t>();
  return packet;
}

Bytes encode_vlp16(const Vlp16Packet& packet) {
  Bytes datagram;
  datagram.reserve(kVlp16PacketBytes);
  LittleWriter out(datagram);
  for (const Vlp16Block& block : packet.blocks) {
    out.write(kBlockFlag).write(block.azimuth);
    for (const Vlp16Echo& echo : block.echoes) out.write(echo.range_2mm).write(echo.reflectivity);
  }
  out.write(packet.time_us).write(static_cast<std::uint8_t>(packet.mode)).write(packet.product);
  return datagram;
}

std::unique_ptr<Driver> make_vlp16_driver(const DriverOptions& options) {
  return std::make_unique<Vlp16Driver>(options);
}

std::unique_ptr<DeviceSimulator> make_vlp16_simulator() {
  return std::make_unique<Vlp16Simulator>();
}

}  // namespace scanfuse::drivers::velodyne
