#include <fmt/format.h>
#include <time.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numeric>
#include <string>
#include <utility>

#include "bench_rows.hpp"
#include "bench_set_pieces.hpp"
#include "scanfuse/core/random.hpp"
#include "scanfuse/pipeline/config.hpp"
#include "scanfuse/simulate/simulate.hpp"

namespace scanfuse::app {
namespace {

constexpr int kRounds = 12;  // through the scenario, after one to warm up
constexpr auto kStages = choices(pipeline::Stage{});

double clock_us(clockid_t clock) {
  timespec now{};
  clock_gettime(clock, &now);
  return static_cast<double>(now.tv_sec) * 1e6 + static_cast<double>(now.tv_nsec) * 1e-3;
}
double cpu_us() { return clock_us(CLOCK_THREAD_CPUTIME_ID); }
double wall_us() { return clock_us(CLOCK_MONOTONIC); }

double quantile(std::vector<double> values, double share) {
  if (values.empty()) return std::nan("");
  const auto place = static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), values.begin() + place, values.end());
  return values[static_cast<std::size_t>(place)];
}

/// A scenario's scans, in memory, as the feed would give them.
Result<std::vector<pipeline::PosedScan>> recorded(std::string_view scenario, std::uint64_t seed) {
  auto simulation = simulate::Simulation::create(scenario, seed);
  if (!simulation) return tl::unexpected(simulation.error());
  pipeline::PoseBuffer ego;
  std::vector<pipeline::PosedScan> scans;
  while (auto frame = simulation->next()) {
    ego.add(frame->ego.stamp, frame->ego.pose);
    pipeline::PosedScan posed;
    posed.scan = std::move(frame->scan);
    posed.world_from_ego = frame->ego.pose;
    posed.ego_from_sensor = simulation->ego_from_sensor();
    scans.push_back(std::move(posed));
  }
  for (auto& posed : scans) posed.twist = ego.twist_at(posed.scan.stamp);
  return scans;
}

/// What a scanner of one layer and one echo would have seen: the second lowest, which is as wide as
/// the pattern.
void keep_one_layer(std::vector<pipeline::PosedScan>& scans) {
  for (auto& posed : scans) {
    std::erase_if(posed.scan.returns, [](const Return& r) { return r.layer != 1 || r.echo > 0; });
    for (Return& r : posed.scan.returns) r.layer = 0;
    posed.scan.beams->layers = 1;
  }
}

/// Lets the stream go on after its end, as if the scenario came again.
void move_on(std::vector<pipeline::PosedScan>& scans) {
  const Duration step = scans.back().scan.stamp - scans[scans.size() - 2].scan.stamp;
  const Duration length = scans.back().scan.stamp - scans.front().scan.stamp + step;
  for (auto& posed : scans) posed.scan.stamp += length;
}

struct ChainTimes {
  std::vector<double> cpu_us, wall_us;
  std::array<std::vector<double>, kStages.size()> stage_us;
  double returns = 0;  ///< of the median scan
};

/// Whole scans and stages in rounds of their own: reading the clock takes time too.
ChainTimes time_chain(std::vector<pipeline::PosedScan> scans,
                      const pipeline::PerceptionOptions& options) {
  pipeline::Perception perception(options);
  ChainTimes times;
  std::vector<double> returns;
  for (const auto& posed : scans) {
    returns.push_back(static_cast<double>(posed.scan.returns.size()));
    perception.step(posed);
  }
  times.returns = quantile(returns, 0.5);
  for (int round = 0; round < kRounds; ++round) {
    move_on(scans);
    for (const auto& posed : scans) {
      const double wall = wall_us(), cpu = cpu_us();
      perception.step(posed);
      times.cpu_us.push_back(cpu_us() - cpu);
      times.wall_us.push_back(wall_us() - wall);
    }
  }
  for (int round = 0; round < kRounds; ++round) {
    move_on(scans);
    for (const auto& posed : scans) {
      double last = cpu_us();
      perception.step(posed, [&](pipeline::Stage stage) {
        const double now = cpu_us();
        times.stage_us[static_cast<std::size_t>(stage)].push_back(now - last);
        last = cpu_us();
      });
    }
  }
  return times;
}

void add_chain(std::vector<BenchRow>& rows, const std::string& name, const ChainTimes& times) {
  const double median = quantile(times.cpu_us, 0.5), p99 = quantile(times.cpu_us, 0.99);
  const auto label = [&](const char* what) { return fmt::format("{} {}", name, what); };
  rows.push_back({label("returns in a scan, median"), times.returns, ""});
  rows.push_back({label("whole chain, median"), median, "us CPU", at_most(100)});
  rows.push_back({label("whole chain, 99th percentile"), p99, "us CPU"});
  rows.push_back({label("99th percentile / median"), p99 / median, "", at_most(2.5)});
  rows.push_back({label("whole chain, median, wall"), quantile(times.wall_us, 0.5), "us"});
  rows.push_back(
      {label("whole chain, 99th percentile, wall"), quantile(times.wall_us, 0.99), "us"});
  rows.push_back({label("whole chain"), times.returns / median, "M pts/s"});
  for (const auto& [stage, index] : kStages) {
    const double us = quantile(times.stage_us[static_cast<std::size_t>(index)], 0.5);
    rows.push_back({fmt::format("{} {}, median", name, stage), us, "us CPU"});
    rows.push_back({fmt::format("{} {}", name, stage), times.returns / us, "M pts/s"});
  }
}

/// `points` points: a street's surfaces over 110 degrees, or all over the plane.
VirtualScan flat_points(int points, bool street) {
  RandomStream random(7);
  VirtualScan scan;
  scan.step_rad = radians(110) / points;
  double range = 20;
  for (int i = 0; i < points; ++i) {
    if (random.chance(15.0 / points)) range = random.uniform(6, 70);
    const double r =
        street ? range + random.normal(0, 0.03) : 110 * std::sqrt(random.uniform(0, 1));
    const double bearing = -radians(55) + i * scan.step_rad;
    PlanarPoint p;
    p.x_m = static_cast<float>(r * std::cos(bearing));
    p.y_m = static_cast<float>(r * std::sin(bearing));
    p.range_m = static_cast<float>(r);
    p.bearing_rad = static_cast<float>(bearing);
    p.column = i;
    scan.points.push_back(p);
  }
  return scan;
}

/// Nanoseconds a point, the median of enough repetitions to fill 0.1 s.
double cluster_ns(segment::Pag& pag, const VirtualScan& scan) {
  pag(scan);
  std::vector<double> times;
  for (double spent = 0; spent < 1e5 || times.size() < 5;) {
    const double start = cpu_us();
    pag(scan);
    times.push_back(cpu_us() - start);
    spent += times.back();
  }
  return 1e3 * quantile(times, 0.5) / static_cast<double>(scan.points.size());
}

/// Linear: the time of a point at 1 M is at most twice that at 1 k, which caches account for.
void add_ladder(std::vector<BenchRow>& rows, const segment::PagOptions& options, bool street) {
  const auto* name = street ? "street" : "scattered";
  segment::Pag pag(options);
  double first = 0, last = 0;
  for (const int points : {1'000, 10'000, 100'000, 1'000'000}) {
    last = cluster_ns(pag, flat_points(points, street));
    if (first == 0) first = last;
    rows.push_back({fmt::format("pag, {}, {} points", name, points), last, "ns/point"});
  }
  rows.push_back({fmt::format("pag, {}, time of a point at 1 M / at 1 k", name), last / first, "",
                  at_most(2)});
}

}  // namespace

Result<std::vector<BenchRow>> bench_speed(std::uint64_t seed, const std::string& preset,
                                          const std::vector<std::string>& changes) {
  auto config = pipeline::preset(preset);
  if (!config) return tl::unexpected(config.error());
  for (const auto& assignment : changes) {
    if (auto done = set_config(*config, assignment); !done) return tl::unexpected(done.error());
  }
  std::vector<BenchRow> rows;
  auto scans = recorded("lu2018-2", seed);
  if (!scans) return tl::unexpected(scans.error());
  add_chain(rows, "lu2018-2", time_chain(*scans, *config));
  keep_one_layer(*scans);
  add_chain(rows, "lu2018-2, one layer", time_chain(std::move(*scans), *config));
  for (const bool street : {true, false}) add_ladder(rows, config->segment.pag, street);
  const auto tracker = bench_tracker_speed(config->track);
  rows.insert(rows.end(), tracker.begin(), tracker.end());
  return rows;
}

}  // namespace scanfuse::app
