#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdio>
#include <memory>
#include <thread>
#include <vector>

#include "bench_rows.hpp"
#include "command.hpp"
#include "live_run.hpp"
#include "process_memory.hpp"
#include "scanfuse/core/random.hpp"
#include "scanfuse/drivers/stream.hpp"
#include "scanfuse/drivers/transport/device_server.hpp"
#include "scanfuse/pipeline/config.hpp"
#include "scanfuse/pipeline/live_reader.hpp"
#include "scanfuse/simulate/simulate.hpp"

// Three simulated sensors at full rate over loopback, with faults, tracked for minutes.
namespace scanfuse::app {
namespace {

using drivers::DeviceServer;
using SteadyClock = std::chrono::steady_clock;
using std::chrono::milliseconds;

constexpr int kPlayedScans = 50;  // made beforehand and played forth and back
constexpr auto kFaultEvery = milliseconds(2500);

/// What the soak did to the sensors, to be found again in the diagnostics.
struct Faults {
  std::atomic<int> hung_up = 0, garbage = 0, cut = 0, left_out = 0, jumped = 0;
};

/// A sensor's scans, made before the clock runs: simulating must not take the tracker's time.
class PlayedSensor {
 public:
  [[nodiscard]] static Result<std::unique_ptr<PlayedSensor>> create(const std::string& address,
                                                                    simulate::SensorPreset preset) {
    simulate::SimulateOptions options;
    options.sensor = preset;
    options.frames = kPlayedScans;
    auto simulation = simulate::Simulation::create("road-users", 1, options);
    if (!simulation) return tl::unexpected(simulation.error());
    auto url = drivers::parse_serve_address(address);
    if (!url) return tl::unexpected(url.error());
    auto server = DeviceServer::open(*url);
    if (!server) return tl::unexpected(server.error());
    std::unique_ptr<PlayedSensor> sensor(new PlayedSensor);
    sensor->server_ = std::move(*server);
    sensor->turn_ = duration_from_seconds(1 / simulation->sensor().rate_hz);
    while (auto frame = simulation->next()) {
      frame->scan.beams = simulation->sensor().pattern;
      sensor->scans_.push_back(std::move(frame->scan));
    }
    return sensor;
  }

  /// Publishes in real time until told to stop.
  void play(const std::stop_token& stop) {
    auto begins = SteadyClock::now();
    for (std::size_t i = 0; !stop.stop_requested(); ++i, begins += turn_) {
      std::this_thread::sleep_until(begins - milliseconds(5));
      // Forth and back, so that nothing leaps.
      const std::size_t cycle = 2 * scans_.size() - 2, at = i % cycle;
      Scan& scan = scans_[at < scans_.size() ? at : cycle - at];
      scan.stamp = std::chrono::system_clock::now() + (begins - SteadyClock::now()) +
                   milliseconds(offset_ms_.load());
      scan.frame = static_cast<std::int64_t>(i);
      server_->publish(scan, begins);
    }
  }
  /// The device's clock leaps.
  void jump(int by_ms) { offset_ms_ += by_ms; }
  [[nodiscard]] DeviceServer& server() const { return *server_; }

 private:
  PlayedSensor() = default;
  std::unique_ptr<DeviceServer> server_;
  std::vector<Scan> scans_;
  Duration turn_{};
  std::atomic<int> offset_ms_ = 0;
};

using Sensors = std::vector<std::unique_ptr<PlayedSensor>>;

/// One fault every few seconds, by turns, on sensors by turns; none in the first and last seconds,
/// so that each can show.
void inject(const Sensors& sensors, const std::stop_token& stop, SteadyClock::time_point end,
            Faults& faults) {
  RandomStream random(99);
  for (int i = 0; !stop.stop_requested(); ++i) {
    std::this_thread::sleep_for(kFaultEvery);
    if (SteadyClock::now() > end - std::chrono::seconds(8)) return;
    PlayedSensor& sensor = *sensors[static_cast<std::size_t>(i / 5) % sensors.size()];
    // Connections are of TCP, and a lost datagram of the VLP-16 has no number to miss it by.
    PlayedSensor& stream = *sensors[static_cast<std::size_t>(i / 5) % 2];
    switch (i % 5) {
      case 0: {
        drivers::Bytes garbage(200 + random.below(800));
        for (auto& b : garbage) b = static_cast<std::byte>(random.below(256));
        sensor.server().send_garbage(garbage);
        ++faults.garbage;
        break;
      }
      case 1:
        stream.server().hang_up();
        ++faults.hung_up;
        break;
      case 2:
        stream.server().cut_short(1);
        ++faults.cut;
        break;
      case 3:
        stream.server().leave_out(1);
        ++faults.left_out;
        break;
      default:
        sensor.jump(i % 2 == 0 ? 1500 : -1500);
        ++faults.jumped;
    }
  }
}

/// The middle of the memory taken in the first and in the last quarter, once all has warmed up.
class MemoryWatch {
 public:
  void look(double at_s) {
    if (at_s < next_s_) return;
    next_s_ = at_s + 0.5;
    samples_.push_back(resident_mb());
  }
  [[nodiscard]] double growth_percent() const {
    if (samples_.size() < 16) return 0;
    const auto quarter = static_cast<std::ptrdiff_t>(samples_.size() / 4);
    // The first quarter is for buffers to grow to what they need.
    const double early = median_of({samples_.begin() + quarter, samples_.begin() + 2 * quarter});
    const double late = median_of({samples_.end() - quarter, samples_.end()});
    return 100 * (late - early) / early;
  }
  [[nodiscard]] double last_mb() const { return samples_.empty() ? 0 : samples_.back(); }

 private:
  std::vector<double> samples_;
  double next_s_ = 0;
};

BenchRow row(std::string name, double value, std::string unit, Target target = {}) {
  return {.name = std::move(name), .value = value, .unit = std::move(unit), .target = target};
}

std::vector<BenchRow> rows_of(const LiveOutcome& outcome, const MemoryWatch& memory,
                              const Faults& faults, const pipeline::LiveReader& reader,
                              double seconds) {
  std::int64_t dropped = 0, anew = 0;
  Diagnostics odd;
  for (const auto& [name, status] : reader.status()) {
    dropped += status.dropped;
    anew += std::max<std::int64_t>(0, status.connections - 1);
    odd.merge(status.diagnostics);
  }
  const auto counted = [&](const char* what) { return static_cast<double>(odd.count(what)); };
  std::vector<BenchRow> rows;
  rows.push_back(
      row("from last byte to tracks, median", 1e3 * outcome.latency_s(0.5), "ms", at_most(3)));
  rows.push_back(
      row("from last byte to tracks, 99 %", 1e3 * outcome.latency_s(0.99), "ms", at_most(15)));
  rows.push_back(
      row("from last byte to tracks, longest", 1e3 * outcome.latency_s(1), "ms", at_most(100)));
  rows.push_back(
      row("longest time without tracks", 1e3 * outcome.longest_gap_s, "ms", at_most(100)));
  rows.push_back(
      row("growth of memory after the first quarter", memory.growth_percent(), "%", at_most(2)));
  rows.push_back(row("memory at the end", memory.last_mb(), "MB"));
  rows.push_back(
      row("scans tracked a second", static_cast<double>(outcome.scans) / seconds, "1/s"));
  rows.push_back(row("scans left out for newer ones", static_cast<double>(dropped), ""));
  rows.push_back(row("connections ended by faults", faults.hung_up, ""));
  rows.push_back(
      row("connections made anew", static_cast<double>(anew), "", at_least(faults.hung_up)));
  rows.push_back(row("garbage sent, times", faults.garbage, ""));
  rows.push_back(row("bytes of no telegram, datagrams of another kind",
                     counted(drivers::StreamCutter::kGarbage) + counted("datagram of another kind"),
                     "", at_least(faults.garbage)));
  rows.push_back(row("telegrams cut or left out", faults.cut + faults.left_out, ""));
  rows.push_back(row("telegrams missed", counted("telegrams missing"), "",
                     at_least(faults.cut + faults.left_out)));
  rows.push_back(row("clock jumps made", faults.jumped, ""));
  rows.push_back(row("clock jumps counted", counted("clock of the device jumped"), "",
                     between(faults.jumped, faults.jumped + faults.hung_up)));
  return rows;
}

Result<Sensors> open_sensors() {
  Sensors sensors;
  for (const auto& [address, preset] : {std::pair{"sick:0", simulate::SensorPreset::kSickLms111},
                                        std::pair{"ibeo:0", simulate::SensorPreset::kLux},
                                        std::pair{"vlp16:23680", simulate::SensorPreset::kVlp16}}) {
    auto sensor = PlayedSensor::create(address, preset);
    if (!sensor) return tl::unexpected(sensor.error());
    sensors.push_back(std::move(*sensor));
  }
  return sensors;
}

Result<std::unique_ptr<pipeline::LiveReader>> read_sensors(const Sensors& sensors) {
  std::vector<pipeline::LiveSource> sources;
  for (const auto& sensor : sensors) {
    auto url = drivers::parse_sensor_url(sensor->server().address());
    if (!url) return tl::unexpected(url.error());
    sources.push_back({std::move(*url), {}, {}});
  }
  return pipeline::LiveReader::create(std::move(sources));
}

}  // namespace

Result<std::vector<BenchRow>> bench_live(double seconds, const std::string& preset) {
  catch_interrupts();
  const auto options = pipeline::preset(preset);
  if (!options) return tl::unexpected(options.error());
  const auto sensors = open_sensors();
  if (!sensors) return tl::unexpected(sensors.error());
  auto reader = read_sensors(*sensors);
  if (!reader) return tl::unexpected(reader.error());
  pipeline::LiveReader& live = **reader;
  pipeline::ScanFeed feed(std::move(*reader), {});
  Faults faults;
  MemoryWatch memory;
  const auto start = SteadyClock::now();
  const auto end = start + duration_from_seconds(seconds);
  std::vector<std::jthread> players;
  for (const auto& sensor : *sensors) {
    players.emplace_back([&](const std::stop_token& stop) { sensor->play(stop); });
  }
  players.emplace_back([&](const std::stop_token& stop) { inject(*sensors, stop, end, faults); });
  const auto outcome = run_live(feed, live, *options, seconds, [&](auto&, auto&) {
    memory.look(to_seconds(SteadyClock::now() - start));
    return Result<void>{};
  });
  for (auto& player : players) player.request_stop();
  if (!outcome) return tl::unexpected(outcome.error());
  return rows_of(*outcome, memory, faults, live, seconds);
}

}  // namespace scanfuse::app
