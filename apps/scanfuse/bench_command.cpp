#include <nlohmann/json.hpp>
#include <thread>

#include "bench_rows.hpp"
#include "command.hpp"
#include "scanfuse/core/options.hpp"

namespace scanfuse::app {
namespace {

struct Benchmark {
  std::string name;
  std::string doc;
  std::function<Result<std::vector<BenchRow>>(const BenchOptions&)> run;
};

const std::vector<Benchmark>& benchmarks() {
  static const std::vector<Benchmark> all{
      {"track", "the three scenarios of [Lu2018] against truth", bench_track},
  };
  return all;
}

std::string verdict(const BenchRow& row) {
  if (!row.met) return "";
  return *row.met ? "met" : "MISSED";
}

void print_table(const std::vector<BenchRow>& rows) {
  fmt::print("{:<62} {:>12} {:<8} {:>10} {:>10}\n", "", "value", "", "peer", "target");
  for (const auto& row : rows) {
    fmt::print("{:<62} {:>12.4g} {:<8} {:>10} {:>10} {}\n", row.name, row.value, row.unit,
               row.peer ? fmt::format("{:.4g}", *row.peer) : "",
               row.target ? fmt::format("{:.4g}", *row.target) : "", verdict(row));
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
                    {"target", or_null(row.target)},
                    {"met", or_null(row.met)}});
  }
  return {{"rows", list},
          {"machine", {{"cores", std::thread::hardware_concurrency()}, {"compiler", __VERSION__}}},
          {"commit", SCANFUSE_COMMIT}};
}

int run_bench(const std::string& name, const BenchOptions& options, bool json) {
  if (name.empty()) {
    for (const auto& bench : benchmarks()) fmt::print("{:<10} {}\n", bench.name, bench.doc);
    return kDone;
  }
  std::vector<std::string> names;
  for (const auto& bench : benchmarks()) {
    names.push_back(bench.name);
    if (bench.name != name) continue;
    const auto rows = bench.run(options);
    if (!rows) return report_error(rows.error());
    if (json) {
      fmt::print("{}\n", as_json(*rows).dump(2));
    } else {
      print_table(*rows);
    }
    return kDone;
  }
  return report_error({Error::Code::kNotFound,
                       fmt::format("unknown benchmark '{}'; did you mean '{}'? `scanfuse bench` "
                                   "lists them",
                                   name, nearest_name(name, names))});
}

}  // namespace

void add_bench(Tool& tool) {
  struct Arguments {
    std::string name;
    BenchOptions options;
    bool json = false;
  };
  auto arguments = std::make_shared<Arguments>();
  auto* app = tool.app->add_subcommand("bench", "Measure accuracy and speed against targets");
  app->add_option("name", arguments->name, "Which benchmark; none: list them");
  app->add_option("--seeds", arguments->options.seeds, "Runs of each scenario")
      ->check(CLI::Range(1, 100000))
      ->capture_default_str();
  app->add_option("--preset", arguments->options.preset, "Options to start from")
      ->capture_default_str();
  app->add_option("--set", arguments->options.set, "Change an option: section.option=value");
  app->add_flag("--json", arguments->json, "One JSON object on stdout");
  app->footer("Example:\n  scanfuse bench track --seeds 20 --json");
  app->callback([&tool, arguments] {
    arguments->options.first_seed = tool.common->seed;
    arguments->options.threads = tool.common->threads;
    *tool.exit_code = run_bench(arguments->name, arguments->options, arguments->json);
  });
}

}  // namespace scanfuse::app
