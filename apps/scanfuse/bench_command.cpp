#include <nlohmann/json.hpp>
#include <thread>

#include "bench_rows.hpp"
#include "command.hpp"
#include "scanfuse/core/options.hpp"
#include "scanfuse/io/atomic_file.hpp"

namespace scanfuse::app {
namespace {

struct BenchRequest {
  std::string name;
  int seeds = 0;  ///< 0: the benchmark's own number
  std::uint64_t first_seed = 0;
  int threads = 0;
  std::string preset = "vehicle-pag";
  std::vector<std::string> changes;
  RealData real;
  std::string report;  ///< passive: measure curves and draw them here
  bool json = false;
  double seconds = 60;  ///< live: how long
};

/// The table of `bench passive`, or with --report its curves.
Result<std::vector<BenchRow>> run_bench_passive(const BenchRequest& request,
                                                const SeedRange& seeds) {
  if (request.report.empty()) return bench_passive(seeds, request.threads);
  auto file = io::AtomicFile::create(request.report);
  if (!file) return tl::unexpected(file.error());
  PassiveCurves curves = bench_passive_curves(seeds, request.threads);
  if (auto wrote = file->write(curves.page); !wrote) return tl::unexpected(wrote.error());
  if (auto done = file->commit(); !done) return tl::unexpected(done.error());
  return std::move(curves.rows);
}

/// Random scenes that constants were chosen or classes learned on; `last` 0: none.
struct TunedSeeds {
  std::uint64_t first = 1;
  std::uint64_t last = 0;
};

struct Benchmark {
  std::string name;
  std::string doc;
  SeedRange seeds;  ///< unless others are asked for
  TunedSeeds tuned;
  Result<std::vector<BenchRow>> (*run)(const BenchRequest&, const SeedRange&);
};

SeedRange seeds_of(const BenchRequest& request, SeedRange fallback) {
  if (request.seeds > 0) fallback.count = request.seeds;
  if (request.first_seed > 0) fallback.first = request.first_seed;
  return fallback;
}

const std::vector<Benchmark>& benchmarks() {
  using Request = const BenchRequest&;
  static const std::vector<Benchmark> all{
      {"segment", "ways to cut a scan into objects: share right against range, point IoU, time",
       SeedRange{}, TunedSeeds{1, 50},
       [](Request, const SeedRange& seeds) -> Result<std::vector<BenchRow>> {
         return bench_segment(seeds);
       }},
      {"track",
       "the scenarios of [Lu2018] and two bends by the whole chain; the tracker alone: set pieces, "
       "speed",
       SeedRange{101, 20}, TunedSeeds{1, 100},
       [](Request request, const SeedRange& seeds) {
         return bench_track(seeds, request.preset, request.changes, request.threads);
       }},
      {"detect", "cars, pedestrians, cyclists and clutter told apart, to 50 m, against truth",
       SeedRange{1001, 40}, TunedSeeds{1, 999},
       [](Request request, const SeedRange& seeds) {
         return bench_detect(seeds, request.changes, request.threads);
       }},
      {"passive",
       "bearings joined into targets: costs, misses and clutter, positions, cameras, the solver",
       SeedRange{1, 2000}, TunedSeeds{},
       [](Request request, const SeedRange& seeds) { return run_bench_passive(request, seeds); }},
      {"turntable",
       "a lidar on a turntable from corners, stripes and scans: the paper's method, closed form, "
       "joint refinement, the Cramer-Rao bound",
       SeedRange{5001, 40}, TunedSeeds{},
       [](Request request, const SeedRange& seeds) {
         return bench_turntable(seeds, request.threads);
       }},
      {"real", "recordings of real scenes against motion capture and labels, where --data has them",
       SeedRange{}, TunedSeeds{},
       [](Request request, const SeedRange&) { return bench_real(request.real, request.threads); }},
      {"speed",
       "time of one 4 x 440 scan through the chain and its stages; clustering to 1 M points",
       SeedRange{}, TunedSeeds{},
       [](Request request, const SeedRange& seeds) {
         return bench_speed(seeds.first, request.preset, request.changes);
       }},
      {"live", "three simulated sensors at full rate with faults: latency, stalls, memory, counts",
       SeedRange{}, TunedSeeds{},
       [](Request request, const SeedRange&) {
         return bench_live(request.seconds, request.preset);
       }},
  };
  return all;
}

/// Says of every row whether its seeds are among those that constants were chosen on.
void name_role(const Benchmark& bench, const SeedRange& seeds, std::vector<BenchRow>& rows) {
  if (bench.tuned.last == 0 || seeds.count < 1) return;
  const auto last = seeds.first + static_cast<std::uint64_t>(seeds.count) - 1;
  const bool tuned = seeds.first <= bench.tuned.last && last >= bench.tuned.first;
  for (auto& row : rows) {
    if (row.role.empty()) row.role = tuned ? kChoseConstants : kReportingOnly;
  }
}

/// What the seeds or recordings of the rows served for, in one line where all agree.
void print_roles(const Benchmark& bench, const SeedRange& seeds,
                 const std::vector<BenchRow>& rows) {
  if (bench.tuned.last == 0) return;
  fmt::print("\nseeds {} to {}: {} (constants were chosen on seeds {} to {})\n", seeds.first,
             seeds.first + static_cast<std::uint64_t>(seeds.count) - 1,
             rows.empty() ? "" : rows.front().role, bench.tuned.first, bench.tuned.last);
}

void print_table(const Benchmark& bench, const std::vector<BenchRow>& rows) {
  const bool by_recording = bench.name == "real";
  const auto number = [](const std::optional<double>& value) {
    return value ? fmt::format("{:.4g}", *value) : std::string();
  };
  const auto target = [&](const Target& t) {
    return number(t.low) + (t.low && t.high ? ".." : "") + number(t.high);
  };
  fmt::print("{:<62} {:>10} {:<8} {:>8} {:>8}\n", "", "value", "", "peer", "target");
  for (const auto& row : rows) {
    if (!row.skipped.empty()) {
      fmt::print("{:<62} skipped: {}\n", row.name, row.skipped);
      continue;
    }
    const auto* verdict = !row.target.any() ? "" : row.met() ? "met" : "MISSED";
    fmt::print("{:<62} {:>10.4g} {:<8} {:>8} {:>8} {:<6} {}{}{}\n", row.name, row.value, row.unit,
               number(row.peer), target(row.target), verdict, by_recording ? row.role : "",
               row.peer_name.empty() ? "" : "; peer: ", row.peer_name);
  }
}

template <class T>
nlohmann::json or_null(const std::optional<T>& value) {
  return value ? nlohmann::json(*value) : nlohmann::json(nullptr);
}

nlohmann::json as_json(const std::vector<BenchRow>& rows) {
  nlohmann::json list = nlohmann::json::array(), skipped = nlohmann::json::array();
  for (const auto& row : rows) {
    if (!row.skipped.empty()) {
      skipped.push_back({{"name", row.name}, {"why", row.skipped}});
      continue;
    }
    list.push_back({{"name", row.name},
                    {"value", std::isfinite(row.value) ? nlohmann::json(row.value) : nullptr},
                    {"unit", row.unit},
                    {"peer", or_null(row.peer)},
                    {"target", or_null(row.target.high ? row.target.high : row.target.low)},
                    {"target_lower", or_null(row.target.high ? row.target.low : std::nullopt)},
                    {"peer_name", row.peer_name},
                    {"role", row.role},
                    {"met", row.met()}});
  }
  return {{"rows", list},
          {"skipped", skipped},
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
    if (!request.report.empty() && bench.name != "passive") {
      return report_error({Error::Code::kUnsupported, "--report is of `bench passive` only"});
    }
    const SeedRange seeds = seeds_of(request, bench.seeds);
    auto rows = bench.run(request, seeds);
    if (!rows) return report_error(rows.error());
    name_role(bench, seeds, *rows);
    if (request.json) {
      fmt::print("{}\n", as_json(*rows).dump(2));
    } else {
      print_table(bench, *rows);
      print_roles(bench, seeds, *rows);
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
  app->add_option("--preset", request->preset, "Options to start from (track, speed, live)")
      ->capture_default_str();
  app->add_option("--set", request->changes,
                  "Change an option: section.option=value (track, detect, speed)")
      ->allow_extra_args(false);
  app->add_option("--data", request->real.folder,
                  "Folder of the recordings that `real` measures on: datmo/, road/kitti_seq0000/")
      ->envname("SCANFUSE_DATA");
  app->add_option("--full-scans", request->real.full_scans,
                  "real: the road sequence's .bin files, if not in road/kitti_seq0000/velodyne");
  app->add_option("--report", request->report,
                  "passive: measure its curves in place of its table, and draw them: .html");
  app->add_option("--seconds", request->seconds, "live: how long")
      ->check(CLI::Range(10.0, 1e6))
      ->capture_default_str();
  app->add_flag("--json", request->json, "One JSON object on stdout");
  app->footer(
      "--seed sets the first seed. Each benchmark's own seeds are none that served for tuning.\n"
      "Examples:\n  scanfuse bench track --seeds 20 --json\n"
      "  scanfuse bench real --data ~/recordings");
  app->callback([&tool, request] {
    if (tool.app->count("--seed") > 0) request->first_seed = tool.common->seed;
    request->threads = tool.common->threads;
    *tool.exit_code = run_bench(*request);
  });
}

}  // namespace scanfuse::app
