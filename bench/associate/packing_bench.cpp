#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <cstdio>
#include <functional>
#include <string>
#include <vector>

#include "associate/packing_scenes.hpp"
#include "associate/triangulated_scenes.hpp"
#include "scanfuse/associate/packing.hpp"
#include "scanfuse/associate/packing_posterior.hpp"

#ifdef SCANFUSE_HAVE_CBC
#include <coin/Cbc_C_Interface.h>
#endif

// Solvers of multi-sensor assignment by kind of scene. Reported beside the time of one scene (mean
// over the scenes of the seeds 1 to `scenes`): how many columns, how large a share of the scenes is
// certified, the mean relative gap, and the weight by that of the default solver.
namespace scanfuse::associate {
namespace {

using Draw = std::function<Packing(RandomStream& random)>;
using Solve = std::function<Result<PackingSolution>(const Packing& packing)>;

std::vector<Packing> packings(int count, const Draw& draw) {
  std::vector<Packing> result;
  for (int seed = 1; seed <= count; ++seed) {
    RandomStream random(static_cast<std::uint64_t>(seed));
    result.push_back(draw(random));
  }
  return result;
}

Draw box(int targets, int sensors, double noise_rad) {
  return [=](RandomStream& random) {
    auto scene = scenes::box(targets, sensors, random);
    scene.noise_rad = noise_rad;
    scene.false_alarms = 10;
    return scenes::packing_of(scene, random);
  };
}

void run(benchmark::State& state, const std::vector<Packing>& scenes, const Solve& solve) {
  double gap = 0, certified = 0, weight = 0, best = 0, columns = 0;
  for (const auto& packing : scenes) {
    const auto solution = solve(packing);
    gap += solution->gap();
    certified += solution->proved ? 1 : 0;
    weight += solution->primal;
    best += PriceAndBranch{}(packing)->primal;
    columns += static_cast<double>(packing.columns());
  }
  for (auto _ : state) {
    for (const auto& packing : scenes) benchmark::DoNotOptimize(solve(packing));
  }
  const auto count = static_cast<double>(scenes.size());
  state.counters["columns"] = columns / count;
  state.counters["certified"] = certified / count;
  state.counters["gap"] = gap / count;
  state.counters["weight"] = weight / best;
  state.counters["per_scene"] = benchmark::Counter(
      count, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

#ifdef SCANFUSE_HAVE_CBC

/// CBC on the whole integer programme, as it comes.
Result<PackingSolution> by_cbc(const Packing& packing) {
  std::vector<CoinBigIndex> starts(packing.starts.begin(), packing.starts.end());
  const std::vector<double> ones(packing.members.size(), 1.0), low(packing.columns(), 0.0),
      high(packing.columns(), 1.0), row_low(packing.rows(), -1e30), row_high(packing.rows(), 1.0);
  Cbc_Model* model = Cbc_newModel();
  Cbc_loadProblem(model, static_cast<int>(packing.columns()), static_cast<int>(packing.rows()),
                  starts.data(), packing.members.data(), ones.data(), low.data(), high.data(),
                  packing.weights.data(), row_low.data(), row_high.data());
  Cbc_setObjSense(model, -1);
  for (int j = 0; j < static_cast<int>(packing.columns()); ++j) Cbc_setInteger(model, j);
  Cbc_setParameter(model, "log", "0");
  Cbc_setParameter(model, "seconds", "120");
  Cbc_solve(model);
  PackingSolution solution;
  solution.primal = Cbc_getObjValue(model);
  solution.dual = Cbc_getBestPossibleObjValue(model);
  solution.proved = Cbc_isProvenOptimal(model) != 0;
  Cbc_deleteModel(model);
  return solution;
}

#endif

void add(const std::string& name, int scenes, const Draw& draw, const Solve& solve) {
  benchmark::RegisterBenchmark(name.c_str(), [=](benchmark::State& state) {
    run(state, packings(scenes, draw), solve);
  })->Unit(benchmark::kMillisecond);
}

struct Kind {
  std::string name;
  int scenes;
  Draw draw;
};

std::vector<Kind> kinds() {
  const auto line = [](double spacing_km) {
    return [=](RandomStream& random) {
      return scenes::packing_of(scenes::line(20, spacing_km, random), random);
    };
  };
  const auto grid = [](double spacing_km) {
    return [=](RandomStream& random) {
      return scenes::packing_of(scenes::grid(20, spacing_km, random), random);
    };
  };
  // What `scanfuse bench passive` solves.
  const auto triangulated = [](const simulate::PassiveOptions& options) {
    return [=](RandomStream& random) { return scenes::triangulated(options, random.below(1000)); };
  };
  simulate::PassiveOptions row, square;
  square.target_layout = simulate::TargetLayout::kGrid;
  return {{"triangulated_line_20x20x20", 50, triangulated(row)},
          {"triangulated_grid_20x20x20", 50, triangulated(square)},
          {"triangulated_1000x5/noise_mrad:1", 1, triangulated(scenes::crowd(1000, 5, 1e-3, 10))},
          {"triangulated_2000x5/noise_mrad:0.5", 1, triangulated(scenes::crowd(2000, 5, 5e-4, 10))},
          {"line_20x20x20/spacing_m:1000", 50, line(1)},
          {"line_20x20x20/spacing_m:500", 50, line(0.5)},
          {"grid_20x20x20/spacing_m:1000", 50, grid(1)},
          {"grid_20x20x20/spacing_m:500", 50, grid(0.5)},
          {"box_1000x5/noise_mrad:1", 3, box(1000, 5, 1e-3)},
          {"box_1000x5/noise_mrad:1.5", 3, box(1000, 5, 1.5e-3)},
          {"box_2000x5/noise_mrad:0.5", 3, box(2000, 5, 0.5e-3)},
          {"box_2000x5/noise_mrad:0.8", 3, box(2000, 5, 0.8e-3)},
          {"box_5000x4/noise_mrad:0.2", 2, box(5000, 4, 2e-4)},
          {"box_5000x4/noise_mrad:0.4", 2, box(5000, 4, 4e-4)}};
}

[[maybe_unused]] const bool registered = [] {
  for (const auto& kind : kinds()) {
    add("Associate_PriceAndBranch/" + kind.name, kind.scenes, kind.draw, PriceAndBranch{});
    add("Associate_GreedyPacking/" + kind.name, kind.scenes, kind.draw, GreedyPacking{});
    const bool small = kind.name.find("20x20x20") != std::string::npos;
    if (small || kind.name.ends_with("1000x5/noise_mrad:1")) {
      add("Associate_LagrangianPacking/" + kind.name, small ? 50 : 1, kind.draw,
          LagrangianPacking{});
#ifdef SCANFUSE_HAVE_CBC
      add("Associate_Cbc/" + kind.name, small ? 10 : 1, kind.draw, by_cbc);
#endif
    }
  }
  return true;
}();

}  // namespace
}  // namespace scanfuse::associate
