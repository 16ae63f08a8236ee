#include <benchmark/benchmark.h>

#include <cmath>
#include <vector>

#include "scanfuse/core/random.hpp"
#include "scanfuse/track/tracker.hpp"

namespace scanfuse::track {
namespace {

/// Cars on a square lattice 8 m apart, each on a course of its own, never colliding for long.
std::vector<std::vector<Detection>> scenes(int objects, int frames) {
  RandomStream random(1);
  const int side = static_cast<int>(std::ceil(std::sqrt(objects)));
  std::vector<Eigen::Vector2d> at(objects), velocity(objects);
  for (int i = 0; i < objects; ++i) {
    at[i] = Eigen::Vector2d(8.0 * (i % side), 8.0 * (i / side));
    velocity[i] = {random.normal(10, 0.3), random.normal(0, 0.1)};
  }
  std::vector<std::vector<Detection>> result(frames);
  for (auto& detections : result) {
    for (int i = 0; i < objects; ++i) {
      at[i] += velocity[i] * 0.08;
      Detection d;
      d.box = {at[i] + Eigen::Vector2d(random.normal(0, 0.1), random.normal(0, 0.1)), 0, 4.4, 1.8};
      d.covariance = Eigen::Vector3d(0.01, 0.01, 0.003).asDiagonal();
      d.var_length_m2 = d.var_width_m2 = 0.01;
      d.length_seen = d.width_seen = true;
      d.faces_seen = 2;
      detections.push_back(d);
    }
  }
  return result;
}

void Track_Step(benchmark::State& state) {
  constexpr int kFrames = 60, kWarmUp = 10;
  const auto frames = scenes(static_cast<int>(state.range(0)), kFrames);
  std::int64_t steps = 0;
  std::size_t tracks = 0;
  while (state.KeepRunningBatch(kFrames - kWarmUp)) {
    state.PauseTiming();
    Tracker tracker(state.range(1) ? literal_options() : TrackerOptions{});
    for (int k = 0; k < kWarmUp; ++k) tracker.step(time_from_seconds(0.08 * k), frames[k]);
    state.ResumeTiming();
    for (int k = kWarmUp; k < kFrames; ++k) {
      tracks = tracker.step(time_from_seconds(0.08 * k), frames[k]).size();
      ++steps;
    }
  }
  state.counters["tracks"] = static_cast<double>(tracks);
  state.counters["frames/s"] =
      benchmark::Counter(static_cast<double>(steps), benchmark::Counter::kIsRate);
}
BENCHMARK(Track_Step)
    ->ArgNames({"objects", "literal"})
    ->Args({10, 0})
    ->Args({10, 1})
    ->Args({100, 0})
    ->Args({500, 0})
    ->Args({2000, 0})
    ->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace scanfuse::track
