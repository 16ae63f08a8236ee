#include <gtest/gtest.h>

#include <vector>

#include "scanfuse/core/parallel.hpp"
#include "scanfuse/pipeline/perception.hpp"
#include "scanfuse/simulate/simulate.hpp"

// One simulation and one chain a thread, side by side: nothing is shared that changes.
namespace scanfuse::pipeline {
namespace {

/// What the tracks of one short run are, number by number.
std::vector<double> run_of_seed(std::uint64_t seed) {
  simulate::SimulateOptions options;
  options.frames = 12;
  auto simulation =
      simulate::Simulation::create(seed % 2 == 0 ? "lu2018-2" : "lu2018-3", seed, options);
  Perception perception;
  PosedScan posed;
  posed.ego_from_sensor = simulation->ego_from_sensor();
  std::vector<double> numbers;
  while (auto frame = simulation->next()) {
    posed.scan = std::move(frame->scan);
    posed.world_from_ego = frame->ego.pose;
    for (const Track& track : perception.step(posed).tracks) {
      const auto& mean = track.state.mean;
      numbers.insert(numbers.end(), {static_cast<double>(track.id), mean[0], mean[1], mean[2],
                                     mean[3], track.box.length_m, track.box.heading_rad});
    }
  }
  return numbers;
}

std::vector<std::vector<double>> runs_on_threads(int threads) {
  std::vector<std::vector<double>> runs(6);
  parallel_for(runs.size(), threads, [&](std::size_t i) { runs[i] = run_of_seed(i + 1); });
  return runs;
}

TEST(ParallelRuns, GiveTheSameTracksOnAnyNumberOfThreads) {
  const auto alone = runs_on_threads(1);
  for (const auto& run : alone) EXPECT_FALSE(run.empty());
  EXPECT_EQ(runs_on_threads(3), alone);
  EXPECT_EQ(runs_on_threads(6), alone);
}

}  // namespace
}  // namespace scanfuse::pipeline
