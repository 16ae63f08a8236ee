#include <benchmark/benchmark.h>

#include "scanfuse/pipeline/config.hpp"
#include "scanfuse/simulate/simulate.hpp"

namespace scanfuse {
namespace {

/// The second scenario of [Lu2018] in memory, with the poses and twists that odometry tells.
std::vector<pipeline::PosedScan> scenario_2() {
  auto simulation = simulate::Simulation::create("lu2018-2", 1000);
  pipeline::PoseBuffer ego;
  std::vector<pipeline::PosedScan> scans;
  while (auto frame = simulation->next()) {
    ego.add(frame->ego.stamp, frame->ego.pose);
    scans.push_back(
        {std::move(frame->scan), frame->ego.pose, simulation->ego_from_sensor(), {}, {}, {}});
  }
  for (auto& posed : scans) posed.twist = ego.twist_at(posed.scan.stamp);
  return scans;
}

/// One scan of 4 x 440 beams through the whole chain; the scenario comes again and again.
void chain(benchmark::State& state, const char* preset) {
  auto scans = scenario_2();
  const Duration length = scans.back().scan.stamp - scans.front().scan.stamp +
                          (scans[1].scan.stamp - scans[0].scan.stamp);
  pipeline::Perception perception(*pipeline::preset(preset));
  std::int64_t points = 0;
  std::size_t next = 0;
  for (auto _ : state) {
    auto& posed = scans[next];
    benchmark::DoNotOptimize(perception.step(posed).tracks.data());
    points += static_cast<std::int64_t>(posed.scan.returns.size());
    posed.scan.stamp += length;
    next = next + 1 < scans.size() ? next + 1 : 0;
  }
  state.SetItemsProcessed(points);
}
BENCHMARK_CAPTURE(chain, pag, "vehicle-pag")
    ->Name("Pipeline_Chain/vehicle-pag/beams:1760")
    ->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(chain, literal, "vehicle-pag-literal")
    ->Name("Pipeline_Chain/vehicle-pag-literal/beams:1760")
    ->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace scanfuse
