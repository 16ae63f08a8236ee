#include <memory>
#include <vector>

#include "command.hpp"
#include "scanfuse/evaluate/evaluate.hpp"
#include "scanfuse/io/tables.hpp"
#include "scoring.hpp"

namespace scanfuse::app {
namespace {

struct EvaluateArguments {
  std::string tracks;
  TruthRequest truth;
  ScoringRequest scoring;
  bool json = false;
};

/// Track tables carry the variances of position only; what is not there is zero, not a guess.
void forget_velocity_covariance(std::vector<StepResult>& steps) {
  for (auto& step : steps) {
    for (auto& track : step.tracks) {
      for (const int i : {1, 3}) {
        track.state.covariance.row(i).setZero();
        track.state.covariance.col(i).setZero();
      }
    }
  }
}

int run_evaluate(const EvaluateArguments& arguments, const CommonOptions& common) {
  const auto options = resolve_scoring(arguments.scoring, arguments.truth);
  if (!options) return report_error(options.error());
  Diagnostics diagnostics;
  auto steps = io::read_tracks(arguments.tracks, &diagnostics);
  if (!steps) return report_error(steps.error());
  if (io::table_kind(arguments.tracks) != io::TableKind::kNone) forget_velocity_covariance(*steps);
  const auto truth = read_truth(arguments.truth, *steps, diagnostics);
  if (!truth) return report_error(truth.error());
  const auto result = evaluate::evaluate(*steps, *truth, *options);
  fmt::print("{}\n", arguments.json ? to_json(result) : to_text(result));
  return report_diagnostics(diagnostics, common.quiet);
}

}  // namespace

void add_evaluate(Tool& tool) {
  auto* command = tool.app->add_subcommand("evaluate", "Score tracks against truth");
  command->footer(
      "Examples:\n"
      "  scanfuse simulate lu2018-2 -o run.mcap\n"
      "  scanfuse track run.mcap -o tracks.mcap\n"
      "  scanfuse evaluate tracks.mcap --truth run.mcap --gospa-c-m 3 --json\n"
      "  scanfuse evaluate lap.csv --truth lap.bag --truth-topic /target_pose --match-m 0.3\n"
      "What the numbers mean: docs/metrics.md. Exit codes: 0 done, 2 bad input, 3 part of it "
      "damaged.");
  auto arguments = std::make_shared<EvaluateArguments>();
  command
      ->add_option("TRACKS", arguments->tracks, "Tracks by `scanfuse track`: .csv, .jsonl or .mcap")
      ->required();
  command
      ->add_option("--truth", arguments->truth.path,
                   "Truth table (CSV), KITTI labels, or a recording that carries truth")
      ->required();
  add_truth_options(*command, arguments->truth);
  add_scoring_options(*command, arguments->scoring);
  command->add_flag("--json", arguments->json, "One JSON object on stdout");
  command->callback(
      [arguments, tool] { *tool.exit_code = run_evaluate(*arguments, *tool.common); });
}

}  // namespace scanfuse::app
