#include <chrono>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <optional>

#include "associate_report.hpp"
#include "command.hpp"
#include "scanfuse/io/atomic_file.hpp"
#include "scanfuse/io/passive/passive.hpp"
#include "scanfuse/io/tables.hpp"
#include "scanfuse/triangulate/associate_scan.hpp"
#include "view_run.hpp"

namespace scanfuse::app {
namespace {

using triangulate::AssociationOptions;
using triangulate::ScanAssociation;

struct AssociateArguments {
  std::string bearings;
  std::string sensors;
  std::string out;
  std::string assignments;
  std::string cost = "evidence";
  std::string solver = "default";
  std::string report;
  std::string truth;
  std::vector<std::string> sets;
  double time_limit_s = 60;
  int best = 0;  ///< associations of each scan that are told of
  bool json = false;
  bool view = false;
};

/// "associate.alpha=0.3" or "candidates.gate_probability=0.999".
Result<void> change(AssociationOptions& options, std::string_view text) {
  const auto setting = split_setting(text);
  if (!setting) {
    return fail(Error::Code::kMalformed, "--set {}: write section.option=value", text);
  }
  const auto& [section, name, value] = *setting;
  if (section == "associate") return set_option(options, name, value);
  if (section == "candidates") return set_option(options.candidates, name, value);
  return fail(Error::Code::kNotFound, "--set {}: no section '{}'; there are associate, candidates",
              text, section);
}

Result<AssociationOptions> association_options(const AssociateArguments& arguments) {
  AssociationOptions options;
  options.time_limit_s = arguments.time_limit_s;
  const std::string solver = arguments.solver == "default" ? "price_and_branch" : arguments.solver;
  for (const auto& [name, value] : {std::pair{"cost", arguments.cost}, {"solver", solver}}) {
    if (auto done = set_option(options, name, value); !done) return tl::unexpected(done.error());
  }
  for (const std::string& set : arguments.sets) {
    if (auto done = change(options, set); !done) return tl::unexpected(done.error());
  }
  return options;
}

/// The files that grow scan after scan.
class AssociationOutput {
 public:
  [[nodiscard]] static Result<AssociationOutput> open(const AssociateArguments& arguments) {
    AssociationOutput output;
    if (auto done = output.start(output.fixes_, arguments.out, io::fix_header()); !done) {
      return tl::unexpected(done.error());
    }
    if (auto done =
            output.start(output.assignments_, arguments.assignments, io::assignment_header());
        !done) {
      return tl::unexpected(done.error());
    }
    return output;
  }

  Result<void> write(const BearingScan& scan, const ScanAssociation& found,
                     const PassiveScene& scene) {
    if (fixes_) {
      auto wrote = fixes_->write(io::fix_rows(scan, found.fixes, scene));
      if (!wrote) return wrote;
    }
    if (!assignments_) return {};
    return assignments_->write(
        io::assignment_rows(scan, found.target_of_bearing, found.probability_of_bearing, scene));
  }

  Result<void> finish() {
    for (auto* file : {&fixes_, &assignments_}) {
      if (!*file) continue;
      if (auto done = (*file)->commit(); !done) return done;
    }
    return {};
  }

 private:
  Result<void> start(std::optional<io::AtomicFile>& file, const std::string& path,
                     const std::string& header) {
    if (path.empty()) return {};
    auto created = io::AtomicFile::create(path);
    if (!created) return tl::unexpected(created.error());
    file.emplace(std::move(*created));
    return file->write(header);
  }

  std::optional<io::AtomicFile> fixes_, assignments_;
};

/// The rows of "best": weight, number of targets, and the bearings of each as [sensor,
/// measurement].
nlohmann::json ranking_json(const BearingScan& scan, const PassiveScene& scene,
                            const ScanAssociation& found,
                            const associate::PackingRanking& ranking) {
  nlohmann::json rows = nlohmann::json::array();
  for (const auto& packing : ranking.packings) {
    nlohmann::json tuples = nlohmann::json::array();
    for (const auto column : packing.chosen) {
      nlohmann::json tuple = nlohmann::json::array();
      for (const auto place : found.packing.column(static_cast<std::size_t>(column))) {
        const Bearing& b = scan.bearings[static_cast<std::size_t>(place)];
        tuple.push_back({scene.sensors[static_cast<std::size_t>(b.sensor)].name, b.measurement});
      }
      tuples.push_back(std::move(tuple));
    }
    rows.push_back({{"weight", packing.weight},
                    {"targets", packing.chosen.size()},
                    {"tuples", std::move(tuples)}});
  }
  return rows;
}

nlohmann::json as_json(const BearingScan& scan, const ScanAssociation& found, double seconds) {
  return {{"scan", scan.scan},
          {"targets", found.fixes.size()},
          {"primal", found.solution.primal},
          {"dual", found.dual},
          {"gap", found.gap()},
          {"proved", found.proved},
          {"columns", found.packing.columns()},
          {"components", found.solution.components.size()},
          {"seconds", seconds}};
}

struct Totals {
  std::int64_t scans = 0;
  std::size_t bearings = 0;
  std::size_t targets = 0;
  std::size_t clutter = 0;
  std::int64_t proved = 0;
  double worst_gap = 0;
};

void print_totals(const Totals& totals, const AssociateArguments& arguments) {
  fmt::print("{}\n", arguments.bearings);
  fmt::print("  {:<18} {}\n", "scans", totals.scans);
  fmt::print("  {:<18} {}\n", "bearings", totals.bearings);
  fmt::print("  {:<18} {}\n", "targets", totals.targets);
  fmt::print("  {:<18} {}\n", "left as clutter", totals.clutter);
  fmt::print("  {:<18} {} of {} scans, largest gap {:.3g}\n", "proved optimal", totals.proved,
             totals.scans, totals.worst_gap);
  for (const auto& path : {arguments.out, arguments.assignments, arguments.report}) {
    if (!path.empty()) fmt::print("  {:<18} {}\n", "wrote", path);
  }
}

/// What was guessed or cut, for the user to know.
void note_oddities(const BearingScan& scan, const ScanAssociation& found,
                   const AssociationOptions& options, Diagnostics& diagnostics) {
  const std::string where = fmt::format("scan {}", scan.scan);
  if (found.prior.volume_estimated) {
    diagnostics.note("volume_m not given, estimated from the bearings", where);
  }
  if (found.prior.targets_estimated) {
    diagnostics.note("expected_targets not given, estimated from the bearings", where);
  }
  if (found.gate_probability < options.candidates.gate_probability) {
    diagnostics.note("too many hypotheses, gate narrowed", where);
  }
  if (found.cut_bearings > 0) {
    diagnostics.note("too many hypotheses of many sensors, some left out; the gap tells", where);
  }
  if (found.solution.diagnostics.out_of_time) diagnostics.note("solver out of time", where);
}

/// What a run gathers besides the files that grow.
struct AssociationRun {
  nlohmann::json rows = nlohmann::json::array();
  Totals totals;
  Diagnostics diagnostics;
  std::optional<AssociationReport> report;
};

/// Associates one scan and hands the answer to all that want it.
Result<void> take_scan(const BearingScan& scan, const PassiveScene& scene,
                       const AssociateArguments& arguments, const AssociationOptions& options,
                       int threads, AssociationOutput& output, AssociationRun& run) {
  const auto start = std::chrono::steady_clock::now();
  const auto found = triangulate::associate_scan(scan, scene, options, threads);
  if (!found) return tl::unexpected(found.error());
  const double seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  note_oddities(scan, *found, options, run.diagnostics);
  if (auto wrote = output.write(scan, *found, scene); !wrote) return wrote;
  std::optional<associate::PackingRanking> ranking;
  if (arguments.best > 0) {
    auto ranked =
        associate::best_packings(found->packing, found->solution, {.count = arguments.best});
    if (!ranked) return tl::unexpected(ranked.error());
    ranking = std::move(*ranked);
  }
  if (arguments.json) {
    auto row = as_json(scan, *found, seconds);
    if (ranking) {
      row["best"] = ranking_json(scan, scene, *found, *ranking);
      row["best_exact"] = ranking->exact;
    }
    run.rows.push_back(std::move(row));
  }
  if (run.report) run.report->add(scan, *found, seconds, ranking ? &*ranking : nullptr);
  Totals& totals = run.totals;
  totals.bearings += scan.bearings.size();
  totals.targets += found->fixes.size();
  for (const auto target : found->target_of_bearing) totals.clutter += target < 0 ? 1 : 0;
  totals.proved += found->solution.proved ? 1 : 0;
  totals.worst_gap = std::max(totals.worst_gap, found->solution.gap());
  ++totals.scans;
  return {};
}

Result<PassiveTruth> read_passive_truth(const std::string& path, Diagnostics& diagnostics) {
  PassiveTruth truth;
  if (path.empty()) return truth;
  const auto frames = io::read_truth(path, &diagnostics);
  if (!frames) return tl::unexpected(frames.error());
  for (const TruthFrame& frame : *frames) {
    for (const TruthObject& object : frame.objects) {
      truth[frame.frame].emplace_back(object.position_m.x(), object.position_m.y(), object.z_m);
    }
  }
  return truth;
}

Result<void> refuse_replacing(const AssociateArguments& arguments) {
  for (const auto& out : {arguments.out, arguments.assignments, arguments.report}) {
    for (const auto& in : {arguments.bearings, arguments.sensors, arguments.truth}) {
      if (in.empty()) continue;
      if (auto fine = refuse_to_replace(in, out); !fine) return fine;
    }
  }
  return {};
}

int run_associate(const AssociateArguments& arguments, const CommonOptions& common) {
  catch_interrupts();
  const auto options = association_options(arguments);
  if (!options) return report_error(options.error());
  if (auto fine = refuse_replacing(arguments); !fine) return report_error(fine.error());
  const auto scene = io::read_sensors(arguments.sensors);
  if (!scene) return report_error(scene.error());
  AssociationRun run;
  const auto scans = io::read_bearings(arguments.bearings, *scene, &run.diagnostics);
  if (!scans) return report_error(scans.error());
  auto truth = read_passive_truth(arguments.truth, run.diagnostics);
  if (!truth) return report_error(truth.error());
  if (!arguments.report.empty()) {
    run.report.emplace(*scene, *options, std::move(*truth), scans->size(), common.threads);
  }
  auto output = AssociationOutput::open(arguments);
  if (!output) return report_error(output.error());
  Progress progress("associating", common.quiet);
  for (const BearingScan& scan : *scans) {
    if (interrupted) break;
    auto done = take_scan(scan, *scene, arguments, *options, common.threads, *output, run);
    if (!done) {
      if (auto kept = output->finish(); !kept) return report_error(kept.error());
      return report_error(done.error());
    }
    progress.update(run.totals.scans, std::ssize(*scans));
  }
  if (auto done = output->finish(); !done) return report_error(done.error());
  if (run.report) {
    auto wrote = io::write_whole(arguments.report, run.report->page(arguments.bearings));
    if (!wrote) return report_error(wrote.error());
  }
  if (arguments.json) {
    fmt::print("{}\n", nlohmann::json{{"scans", run.rows}}.dump(2));
  } else {
    print_totals(run.totals, arguments);
  }
  const int code = report_diagnostics(run.diagnostics, common.quiet);
  return interrupted ? kInterrupted : code;
}

int view_associated(const AssociateArguments& arguments, const CommonOptions& common) {
  const auto options = association_options(arguments);
  if (!options) return report_error(options.error());
  ViewRequest request;
  request.track.input = arguments.bearings;
  request.track.sensors = arguments.sensors;
  request.association = *options;
  return run_view(std::move(request), common);
}

std::string associate_help() {
  return "Settings (--set SECTION.NAME=VALUE):\n" +
         settings_help(view_options("associate", AssociationOptions{})) +
         settings_help(view_options("candidates", triangulate::CandidateOptions{})) +
         "Example:\n  scanfuse simulate passive --targets 20 -o bearings.csv --sensors-out "
         "sensors.toml\n  scanfuse associate bearings.csv --sensors sensors.toml -o fixes.csv\n";
}

}  // namespace

void add_associate(Tool& tool) {
  auto arguments = std::make_shared<AssociateArguments>();
  auto* app = tool.app->add_subcommand(
      "associate", "Find which bearings of passive sensors belong to one target, and where it is");
  app->add_option("bearings", arguments->bearings, "Bearings: a CSV table")->required();
  app->add_option("--sensors", arguments->sensors, "Where the sensors are: a TOML file")
      ->required();
  app->add_option("-o,--output", arguments->out, "Fixes to write: .csv");
  app->add_option("--assignments", arguments->assignments,
                  "One row a bearing to write: which target it went to, or none");
  app->add_option("--cost", arguments->cost,
                  "evidence, classic, renyi_literal, renyi, kl or leave_one_out")
      ->capture_default_str();
  app->add_option("--solver", arguments->solver, "default, lagrangian or greedy")
      ->capture_default_str();
  app->add_option("--time-limit-s", arguments->time_limit_s,
                  "Of a scan; then the best so far is given with its gap")
      ->check(CLI::Range(0.0, 1e6))
      ->capture_default_str();
  app->add_option("--best", arguments->best, "Tell the M best associations of each scan")
      ->check(CLI::Range(1, 1000));
  auto* report = app->add_option("--report", arguments->report, "A page to look at: .html");
  app->add_option("--truth", arguments->truth,
                  "Where targets really were, for the report: frame,time_s,object_id,class,x_m,...")
      ->needs(report);
  app->add_option("--set", arguments->sets, "Change a setting: section.name=value")
      ->allow_extra_args(false);
  app->add_flag("--json", arguments->json, "One JSON object on stdout");
  app->add_flag(
      "--view", arguments->view,
      "Then look at lines of sight and fixes in a browser, as `scanfuse view` shows them");
  app->footer(associate_help());
  app->callback([arguments, tool] {
    int& code = *tool.exit_code;
    code = run_associate(*arguments, *tool.common);
    if (!arguments->view || (code != kDone && code != kDamagedInput)) return;
    if (const int served = view_associated(*arguments, *tool.common); served != kDone)
      code = served;
  });
}

}  // namespace scanfuse::app
