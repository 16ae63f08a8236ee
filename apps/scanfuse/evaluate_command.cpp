#include <cstdio>
#include <memory>
#include <vector>

#include "command.hpp"
#include "scanfuse/evaluate/evaluate.hpp"
#include "scanfuse/io/recording.hpp"
#include "scanfuse/io/tables.hpp"

namespace scanfuse::app {
namespace {

struct EvaluateArguments {
  std::string tracks;
  std::string truth;
  std::string truth_frame;
  std::string similarity = "centre";
  std::vector<double> region;
  double view_deg = 180;
  bool skip_unlisted = false;
  bool json = false;
  evaluate::EvaluateOptions options;
};

/// A table, or the truth that stands in a recording.
Result<std::vector<TruthFrame>> truth_from(const std::string& path, Diagnostics& diagnostics) {
  if (io::table_kind(path) != io::TableKind::kNone) return io::read_truth(path, &diagnostics);
  auto reader = io::open_recording(path);
  if (!reader) return tl::unexpected(reader.error());
  std::vector<TruthFrame> frames;
  while (true) {
    auto event = (*reader)->next();
    if (!event) return tl::unexpected(event.error());
    if (!*event) break;
    if (auto* frame = std::get_if<TruthFrame>(&(*event)->payload)) {
      frames.push_back(std::move(*frame));
    }
  }
  diagnostics.merge((*reader)->diagnostics());
  if (frames.empty()) {
    return fail(Error::Code::kNotFound,
                "{}: holds no truth; give a truth table or a recording "
                "written by `scanfuse simulate`",
                path);
  }
  return frames;
}

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

Result<void> use_region(EvaluateArguments& arguments) {
  const auto& r = arguments.region;
  if (r.empty()) return {};
  if (!(r[0] < r[1] && r[2] < r[3])) {
    return fail(Error::Code::kOutOfRange,
                "--region {},{},{},{} is empty; give X0,X1,Y0,Y1 with "
                "X0 < X1 and Y0 < Y1",
                r[0], r[1], r[2], r[3]);
  }
  auto& o = arguments.options;
  o.region_x0_m = r[0];
  o.region_x1_m = r[1];
  o.region_y0_m = r[2];
  o.region_y1_m = r[3];
  return {};
}

int run_evaluate(EvaluateArguments arguments, const CommonOptions& common) {
  if (auto region = use_region(arguments); !region) return report_error(region.error());
  arguments.options.view_half_angle_rad = radians(arguments.view_deg);
  if (arguments.skip_unlisted) {
    arguments.options.unlisted_frames = evaluate::UnlistedFrames::kSkip;
  }
  if (arguments.similarity == "bev_iou") {
    arguments.options.similarity = evaluate::SimilarityBy::kBevIou;
  }
  Diagnostics diagnostics;
  auto steps = io::read_tracks(arguments.tracks, &diagnostics);
  if (!steps) return report_error(steps.error());
  if (io::table_kind(arguments.tracks) != io::TableKind::kNone) forget_velocity_covariance(*steps);
  auto truth = truth_from(arguments.truth, diagnostics);
  if (!truth) return report_error(truth.error());
  for (auto& frame : *truth) {
    if (!arguments.truth_frame.empty()) frame.coordinate_frame = arguments.truth_frame;
  }
  const auto result = evaluate::evaluate(*steps, *truth, arguments.options);
  fmt::print("{}\n", arguments.json ? to_json(result) : to_text(result));
  return report_diagnostics(diagnostics, common.quiet);
}

void add_evaluate_options(CLI::App& command, EvaluateArguments& a) {
  command.add_option("TRACKS", a.tracks, "Tracks by `scanfuse track`: .csv, .jsonl or .mcap")
      ->required();
  command.add_option("--truth", a.truth, "Truth table (CSV), or a recording that carries truth")
      ->required();
  command
      .add_option("--truth-frame", a.truth_frame,
                  "Frame of the truth's coordinates: world (default for tables) or ego")
      ->check(CLI::IsMember({"world", "ego"}));
  command
      .add_option("--match-m", a.options.match_m,
                  "A track farther than this from an object is never its match")
      ->check(CLI::Range(1e-3, 100.0))
      ->capture_default_str();
  command
      .add_option("--similarity-m", a.options.similarity_m,
                  "Distance at which similarity is 0; CLEAR and identity ask for 0.5")
      ->check(CLI::Range(1e-3, 100.0))
      ->capture_default_str();
  command
      .add_option("--similarity", a.similarity,
                  "centre: by distance of centres; bev_iou: by overlap of boxes from above")
      ->check(CLI::IsMember({"centre", "bev_iou"}))
      ->capture_default_str();
  command.add_option("--gospa-c-m", a.options.gospa_c_m, "Cut-off distance of GOSPA and OSPA")
      ->check(CLI::Range(1e-3, 1000.0))
      ->capture_default_str();
  command
      .add_option("--min-visible-points", a.options.min_visible_points,
                  "Ignore truth objects with fewer returns, and what tracks them")
      ->check(CLI::Range(0, 1000000))
      ->capture_default_str();
  command.add_option("--region", a.region, "X0,X1,Y0,Y1: only what is inside counts, truth frame")
      ->delimiter(',')
      ->expected(4);
  command
      .add_option("--view-deg", a.view_deg,
                  "Only what lies within so many degrees left or right of the ego's nose counts")
      ->check(CLI::Range(0.0, 180.0))
      ->capture_default_str();
  command.add_option("--view-m", a.options.view_range_m, "Only what is nearer to the ego counts")
      ->check(CLI::Range(0.0, 1e9));
  command.add_flag("--skip-unlisted", a.skip_unlisted,
                   "Leave out scans that no truth frame belongs to; else they are empty road");
  command.add_flag("--json", a.json, "One JSON object on stdout");
}

}  // namespace

void add_evaluate(Tool& tool) {
  auto* command = tool.app->add_subcommand("evaluate", "Score tracks against truth");
  command->footer(
      "Example:\n"
      "  scanfuse simulate lu2018-2 -o run.mcap\n"
      "  scanfuse track run.mcap -o tracks.mcap\n"
      "  scanfuse evaluate tracks.mcap --truth run.mcap --gospa-c-m 3 --json\n"
      "What the numbers mean: docs/metrics.md. Exit codes: 0 done, 2 bad input, 3 part of it "
      "damaged.");
  auto arguments = std::make_shared<EvaluateArguments>();
  add_evaluate_options(*command, *arguments);
  command->callback(
      [arguments, tool] { *tool.exit_code = run_evaluate(*arguments, *tool.common); });
}

}  // namespace scanfuse::app
