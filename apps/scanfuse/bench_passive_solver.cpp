#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <tuple>

#include "bench_passive_runs.hpp"
#include "process_memory.hpp"

namespace scanfuse::app {
namespace {

using simulate::PassiveOptions;
using triangulate::CostMethod;

constexpr double kPatience_s = 1.7;  ///< of a solver that is to be done in two seconds

/// Greedy choice on the same hypotheses: its weight by the best one's, and its time.
struct GreedyPeer {
  double share = 0;
  double seconds = 0;
};

GreedyPeer greedy_on(const std::vector<associate::Packing>& packings) {
  double greedy = 0, best = 0;
  std::vector<double> seconds;
  for (const auto& packing : packings) {
    const auto start = std::chrono::steady_clock::now();
    const auto chosen = associate::GreedyPacking{}(packing);
    seconds.push_back(
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
    const auto solved = associate::PriceAndBranch{}(packing);
    if (!chosen || !solved) continue;
    greedy += chosen->primal;
    best += solved->primal;
  }
  return {best > 0 ? greedy / best : 1, median_of(seconds)};
}

void add_growth_row(std::vector<BenchRow>& rows, int sensors, int targets, std::uint64_t seed) {
  PassiveOptions options = passive_crowd(0.9, 0.001);
  options.sensors = sensors;
  options.targets = targets;
  const auto outcome = run_passive(options, {seed, 1}, 1, CostMethod::kEvidence);
  const auto name =
      fmt::format("{} targets x {} sensors, 1 mrad, 5 false alarms", targets, sensors);
  rows.push_back({name + ": whole scan", median_of(outcome.seconds), "s"});
  rows.push_back({name + ": hypotheses", median_of(outcome.columns), ""});
  rows.push_back({name + ": gap", outcome.worst_gap, "", sensors > 2 ? at_most(1e-9) : Target{}});
  rows.push_back({name + ": F1", outcome.score.f1(), ""});
}

}  // namespace

void add_passive_cameras(std::vector<BenchRow>& rows, std::uint64_t seed, int threads) {
  const std::tuple<int, int, double, double> sizes[] = {
      {200, 10, 0.3, 0.96}, {1000, 2, 0.3, 0.93}, {2000, 1, 0.3, 0.91}, {5000, 1, 0.1, 0}};
  for (const auto& [points, scenes, noise_px, f1] : sizes) {
    PassiveOptions options = passive_crowd(0.9, noise_px / 2500);  // pixels of a lens of 2500
    options.false_alarms = 0;
    options.targets = points;
    options.sensors = 4;
    options.sensor_layout = simulate::SensorLayout::kCameras;
    const auto outcome = run_passive(options, {seed, scenes}, threads, CostMethod::kEvidence);
    const auto name = fmt::format("4 cameras, {} points, {:g} px", points, noise_px);
    rows.push_back({name + ": F1", outcome.score.f1(), "", f1 > 0 ? at_least(f1) : Target{}});
    rows.push_back({name + ": gap", outcome.worst_gap, "", at_most(1e-3)});
    rows.push_back({name + ": solver, median", median_of(outcome.solver_seconds), "s"});
    rows.push_back({name + ": whole scan, median", median_of(outcome.seconds), "s"});
    if (points < 5000) continue;
    const auto stopped = run_passive(options, {seed, scenes}, threads, CostMethod::kEvidence,
                                     {.time_limit_s = kPatience_s});
    rows.push_back(
        {name + ", stopped early: solver", median_of(stopped.solver_seconds), "s", at_most(2)});
    rows.push_back({name + ", stopped early: gap", stopped.worst_gap, "", at_most(1e-3)});
    rows.push_back({name + ", stopped early: F1", stopped.score.f1(), ""});
  }
}

void add_passive_solver(std::vector<BenchRow>& rows, std::uint64_t seed) {
  PassiveOptions line;
  PassiveOptions grid = line;
  grid.target_layout = simulate::TargetLayout::kGrid;
  PassiveOptions thousand = passive_crowd(0.9, 0.001);
  thousand.targets = 1000;
  thousand.sensors = 5;
  thousand.false_alarms = 10;
  PassiveOptions more = thousand;
  more.targets = 2000;
  more.noise_rad = 0.0005;
  const std::tuple<const char*, PassiveOptions, int, double, double> scenes[] = {
      {"20 x 20 x 20 line", line, 50, 0.001, 0},
      {"20 x 20 x 20 grid", grid, 50, 0.005, 0},
      {"1000 targets x 5 sensors, 1 mrad", thousand, 1, 2, 5},
      {"2000 targets x 5 sensors, 0.5 mrad", more, 1, 10, 10}};
  for (const auto& [name, options, count, limit_s, whole_s] : scenes) {
    const auto outcome =
        run_passive(options, {seed, count}, 1, CostMethod::kEvidence, {.keep_packings = true});
    const auto greedy = greedy_on(outcome.packings);
    rows.push_back({fmt::format("{}: not certified", name), static_cast<double>(outcome.unproved),
                    "scenes", at_most(0)});
    rows.push_back({fmt::format("{}: solver, median", name),
                    median_of(outcome.solver_seconds) * 1e3, "ms", at_most(limit_s * 1e3),
                    greedy.seconds * 1e3, "greedy"});
    rows.push_back({fmt::format("{}: whole scan, median", name), median_of(outcome.seconds) * 1e3,
                    "ms", whole_s > 0 ? at_most(whole_s * 1e3) : Target{}});
    rows.push_back({fmt::format("{}: weight by the bound", name), 1 - outcome.worst_gap, "",
                    at_least(0.999), greedy.share, "greedy"});
  }
  rows.push_back({"peak memory so far", peak_memory_mb(), "MB", at_most(2048)});
}

void add_many_sensors(std::vector<BenchRow>& rows, std::uint64_t seed) {
  for (const int sensors : {8, 12, 16, 20}) add_growth_row(rows, sensors, 100, seed);
  for (const int sensors : {2, 32, 64}) add_growth_row(rows, sensors, 20, seed);
}

}  // namespace scanfuse::app
