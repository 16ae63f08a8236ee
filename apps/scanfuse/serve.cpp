#include "serve.hpp"

#include <chrono>
#include <optional>
#include <thread>

#include "scanfuse/drivers/transport/device_server.hpp"

namespace scanfuse::app {
namespace {

using SteadyClock = std::chrono::steady_clock;

/// Scans are made and handed on before they begin.
constexpr auto kAhead = std::chrono::milliseconds(20);

struct ServedDevice {
  std::unique_ptr<drivers::DeviceServer> server;
  simulate::SimulateOptions options;
};

/// One clock for all devices.
struct ServeClock {
  SteadyClock::time_point steady = SteadyClock::now() + std::chrono::milliseconds(200);
  Time utc = std::chrono::system_clock::now() + std::chrono::milliseconds(200);
};

Result<ServedDevice> open_served(const ServeRequest& request, const std::string& address) {
  auto url = drivers::parse_serve_address(address);
  if (!url) return tl::unexpected(url.error());
  ServedDevice served{nullptr, request.options};
  const std::string preset = request.sensor.value_or(preset_of_device(url->device->scheme));
  if (auto done = set_option(served.options, "sensor", preset); !done) {
    return tl::unexpected(done.error());
  }
  auto server = drivers::DeviceServer::open(*url);
  if (!server) return tl::unexpected(server.error());
  served.server = std::move(*server);
  return served;
}

/// Plays the scenario once, from `begin` after the clock's start on; when it ended.
Result<Duration> play(const ServeRequest& request, const ServedDevice& served,
                      const ServeClock& clock, Duration begin, std::uint64_t seed,
                      std::int64_t& sent) {
  auto simulation = simulate::Simulation::create(request.scenario, seed, served.options);
  if (!simulation) return tl::unexpected(simulation.error());
  const auto turn = duration_from_seconds(1 / simulation->sensor().rate_hz);
  Duration end = begin;
  std::optional<Time> first;
  while (!interrupted) {
    // A machine that simulates more slowly than time goes leaves scans out, and stays in time.
    const bool is_late = SteadyClock::now() > clock.steady + end;
    auto frame = is_late ? simulation->next_truth() : simulation->next();
    if (!frame) break;
    if (!first) first = frame->scan.stamp;
    const Duration at = begin + (frame->scan.stamp - *first);
    end = at + turn;
    if (is_late) continue;
    std::this_thread::sleep_until(clock.steady + at - kAhead);
    frame->scan.stamp = clock.utc + at;
    frame->scan.frame = sent++;
    frame->scan.beams = simulation->sensor().pattern;
    served.server->publish(frame->scan, clock.steady + at);
  }
  return end;
}

Result<void> play_all(const ServeRequest& request, const ServedDevice& served,
                      const ServeClock& clock, std::uint64_t seed) {
  std::int64_t sent = 0;
  Duration begin{0};
  while (!interrupted) {
    const auto end = play(request, served, clock, begin, seed, sent);
    if (!end) return tl::unexpected(end.error());
    if (request.options.frames > 0) break;
    begin = *end;
  }
  std::this_thread::sleep_for(std::chrono::milliseconds(interrupted ? 0 : 500));
  return {};
}

}  // namespace

std::string preset_of_device(std::string_view scheme) {
  for (const auto& [device, preset] :
       {std::pair{"ibeo", "lux"}, std::pair{"hokuyo", "hokuyo-utm30"},
        std::pair{"rplidar", "rplidar-a2"}, std::pair{"vlp16", "vlp16"},
        std::pair{"ouster", "vlp16"}, std::pair{"multiscan", "vlp16"}}) {
    if (scheme == device) return preset;
  }
  return "sick-lms111";
}

Result<void> serve_scenario(const ServeRequest& request, const CommonOptions& common) {
  // An unknown scenario should be told before anything is served.
  if (auto probe = simulate::Simulation::create(request.scenario, common.seed, request.options);
      !probe) {
    return tl::unexpected(probe.error());
  }
  std::vector<ServedDevice> all;
  for (const auto& address : request.addresses) {
    auto served = open_served(request, address);
    if (!served) return tl::unexpected(served.error());
    if (!common.quiet) fmt::print(stderr, "scanfuse: serving {}\n", served->server->address());
    all.push_back(std::move(*served));
  }
  const ServeClock clock;
  std::vector<Result<void>> outcomes(all.size());
  {
    std::vector<std::jthread> threads;
    for (std::size_t i = 0; i < all.size(); ++i) {
      threads.emplace_back([&, i] { outcomes[i] = play_all(request, all[i], clock, common.seed); });
    }
  }
  for (auto& outcome : outcomes) {
    if (!outcome) return outcome;
  }
  return {};
}

}  // namespace scanfuse::app
