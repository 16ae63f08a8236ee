#include <nlohmann/json.hpp>
#include <thread>

#include "bench_rows.hpp"
#include "command.hpp"
#include "scanfuse/core/options.hpp"

namespace scanfuse::app {
namespace {

struct BenchRequest {
  std::string name;
  int seeds = 0;  ///< 0: the benchmark's own number
  std::uint64_t first_seed = 0;
  int threads = 0;
  std::string preset = "vehicle-pag";
  std::vector<std::string> changes;
  bool json = false;
};

struct Benchmark {
  std::string name;
  std::string doc;
  Result<std::vector<BenchRow>> (*run)(const BenchRequest&);
};

SeedRange seeds_of(const BenchRequest& request, SeedRange fallback) {
  if (request.seeds > 0) fallback.count = request.seeds;
  if (request.first_seed > 0) fallback.first = request.first_seed;
  return fallback;
}

const std::vector<Benchmark>& benchmarks() {
  static const std::vector<Benchmark> all{
      {"segment", "ways to cut a scan into objects: share right against range, point IoU, time",
       [](const BenchRequest& request) -> Result<std::vector<BenchRow>> {
         return bench_segment(seeds_of(request, {}));
       }},
      {"track",
       "the scenarios of [Lu2018] and two bends by the whole chain; the tracker alone: set pieces, "
       "speed",
       [](const BenchRequest& request) {
         return bench_track(seeds_of(request, {101, 20}), request.preset, request.changes,
                            request.threads);
       }},
      {"detect", "cars, pedestrians, cyclists and clutter told apart, to 50 m, against truth",
       [](const BenchRequest& request) {
         return bench_detect(seeds_of(request, {1001, 40}), request.changes, request.threads);
       }},
      {"passive",
       "bearings joined into targets: costs, misses and clutter, positions, cameras, the solver",
       [](const BenchRequest& request) -> Result<std::vector<BenchRow>> {
         return bench_passive(seeds_of(request, {1, 2000}), request.threads);
       }},
      {"speed",
       "time of one 4 x 440 scan through the chain and its stages; clustering to 1 M points",
       [](const BenchRequest& request) {
         return bench_speed(seeds_of(request, {}).first, request.preset, request.changes);
       }},
  };
  return all;
}

void print_table(const std::vector<BenchRow>& rows) {
  const auto number = [](const std::optional<double>& value) {
    return value ? fmt::format("{:.4g}", *value) : std::string();
  };
  const auto target = [&](const Target& t) {
    return number(t.low) + (t.low && t.high ? ".." : "") + number(t.high);
  };
  fmt::print("{:<62} {:>10} {:<8} {:>8} {:>8}\n", "", "value", "", "peer", "target");
  for (const auto& row : rows) {
    const auto* verdict = !row.target.any() ? "" : row.met() ? "met" : "MISSED";
    fmt::print("{:<62} {:>10.4g} {:<8} {:>8} {:>8} {}\n", row.name, row.value, row.unit,
               number(row.peer), target(row.target), verdict);
  }
}

template <class T>
nlohmann::json or_null(const std::optional<T>& value) {
  return value ? nlohmann::json(*value) : nlohmann::json(nullptr);
}

nlohmann::json as_json(const std::vector<BenchRow>& rows) {
  nlohmann::json list = nlohmann::json::array();
  for (const auto& row : rows) {
    list.push_back({{"name", row.name},
                    {"value", std::isfinite(row.value) ? nlohmann::json(row.value) : nullptr},
                    {"unit", row.unit},
                    {"peer", or_null(row.peer)},
                    {"target", or_null(row.target.high ? row.target.high : row.target.low)},
                    {"target_lower", or_null(row.target.high ? row.target.low : std::nullopt)},
                    {"met", row.met()}});
  }
  return {{"rows", list},
          {"machine", {{"cores", std::thread::hardware_concurrency()}, {"compiler", __VERSION__}}},
          {"commit", SCANFUSE_COMMIT}};
}

int run_bench(const BenchRequest& request) {
  if (request.name.empty()) {
    for (const auto& bench : benchmarks()) fmt::print("{:<10} {}\n", bench.name, bench.doc);
    return kDone;
  }
  std::vector<std::string> names;
  for (const auto& bench : benchmarks()) {
    names.push_back(bench.name);
    if (bench.name != request.name) continue;
    const auto rows = bench.run(request);
    if (!rows) return report_error(rows.error());
    if (request.json) {
      fmt::print("{}\n", as_json(*rows).dump(2));
    } else {
      print_table(*rows);
    }
    return kDone;
  }
  return report_error({Error::Code::kNotFound,
                       fmt::format("unknown benchmark '{}'; did you mean '{}'? `scanfuse bench` "
                                   "lists them",
                                   request.name, nearest_name(request.name, names))});
}

}  // namespace

void add_bench(Tool& tool) {
  auto request = std::make_shared<BenchRequest>();
  auto* app = tool.app->add_subcommand("bench", "Measure accuracy and speed against targets");
  app->add_option("name", request->name, "Which benchmark; none: list them");
  app->add_option("--seeds", request->seeds, "Random runs; 0: the benchmark's own number")
      ->check(CLI::Range(0, 100000));
  app->add_option("--preset", request->preset, "Options to start from (track, speed)")
      ->capture_default_str();
  app->add_option("--set", request->changes,
                  "Change an option: section.option=value (track, detect, speed)")
      ->allow_extra_args(false);
  app->add_flag("--json", request->json, "One JSON object on stdout");
  app->footer(
      "--seed sets the first seed. Each benchmark's own seeds are none that served for tuning.\n"
      "Example:\n  scanfuse bench track --seeds 20 --json");
  app->callback([&tool, request] {
    if (tool.app->count("--seed") > 0) request->first_seed = tool.common->seed;
    request->threads = tool.common->threads;
    *tool.exit_code = run_bench(*request);
  });
}

}  // namespace scanfuse::app
