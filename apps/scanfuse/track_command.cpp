#include <nlohmann/json.hpp>

#include "command.hpp"
#include "scanfuse/io/tables.hpp"
#include "track_outputs.hpp"
#include "track_passive.hpp"
#include "track_run.hpp"
#include "view_run.hpp"

namespace scanfuse::app {
namespace {

nlohmann::json as_json(const TrackRequest& request, const TrackOutcome& outcome) {
  nlohmann::json json{
      {"input", request.input},
      {"scans", outcome.scans},
      {"returns", outcome.returns},
      {"detections", outcome.detections},
      {"confirmed_tracks", outcome.tracks},
      {"seconds_per_scan", {{"median", outcome.median_scan_s}, {"p99", outcome.p99_scan_s}}},
      {"interrupted", outcome.stopped},
      {"outputs", request.outputs},
      {"diagnostics", diagnostics_json(outcome.diagnostics)}};
  if (outcome.score) json["evaluation"] = nlohmann::json::parse(to_json(*outcome.score));
  return json;
}

void print_summary(const TrackRequest& request, const TrackOutcome& outcome) {
  fmt::print("{}\n", request.input);
  for (const auto& [name, value] : summary_rows(outcome)) fmt::print("  {:<18} {}\n", name, value);
  if (outcome.score) {
    const auto& score = *outcome.score;
    fmt::print("  against truth      MOTA {:.3f}, {} identity switches, position RMSE {:.2f} m\n",
               score.clear.mota.value_or(0), score.clear.identity_switches,
               score.rmse.position_m.value_or(0));
  }
  auto written = request.outputs;
  for (const auto& path : {request.detections, request.report}) {
    if (!path.empty()) written.push_back(path);
  }
  for (const auto& path : written) fmt::print("  wrote              {}\n", path);
}

int run(const TrackRequest& request, const CommonOptions& common) {
  catch_interrupts();
  if (!request.sensors.empty()) return run_track_passive(request, common);
  if (io::table_kind(request.input) == io::TableKind::kBearings) {
    return report_error({Error::Code::kUnsupported,
                         request.input + ": bearings; say where the sensors are: --sensors TOML"});
  }
  const auto outcome = io::holds_detections(request.input)
                           ? run_track_on_detections(request, common)
                           : run_track(request, common);
  if (!outcome) return report_error(outcome.error());
  if (request.json) {
    fmt::print(
        "{}\n",
        as_json(request, *outcome).dump(2, ' ', false, nlohmann::json::error_handler_t::replace));
  } else {
    print_summary(request, *outcome);
  }
  const int code = report_diagnostics(outcome->diagnostics, common.quiet);
  return outcome->stopped ? kInterrupted : code;
}

}  // namespace

void add_track(Tool& tool) {
  auto request = std::make_shared<TrackRequest>();
  request->scoring.options.min_visible_points = 1;
  auto* app = tool.app->add_subcommand("track", "Detect and track objects in a recording");
  app->add_option("input", request->input,
                  "Recording (file or folder), points, detections or bearings in CSV, KITTI "
                  "detections")
      ->required();
  app->add_option("-o,--output", request->outputs, "Where tracks go: .mcap, .csv or .jsonl")
      ->allow_extra_args(false);
  app->add_option("--detections", request->detections, "Write the detections too, as CSV");
  app->add_option("--report", request->report, "Write a page to look at, as HTML");
  app->add_option(
         "--preset", request->preset,
         fmt::format("Options to start from: {}", fmt::join(pipeline::preset_names(), ", ")))
      ->capture_default_str();
  app->add_option("--config", request->config, "Options from a TOML file");
  app->add_option("--set", request->set, "Change an option: section.option=value")
      ->allow_extra_args(false);
  app->add_option("--frame", request->frame, "Frame of the results: world or ego");
  app->add_option("--topic", request->topics, "Only this scan topic; may be repeated")
      ->allow_extra_args(false);
  app->add_option("--sensor", request->sensor,
                  "Device that speaks in a capture (.pcap), if its ports do not tell: sick, ...");
  app->add_option("--ego-topic", request->ego_topic,
                  "Topic of the ego pose: Odometry, PoseStamped, PoseWithCovarianceStamped");
  app->add_option("--ego", request->ego_file, "Ego motion beside the recording, as CSV");
  app->add_flag("--standing", request->standing,
                "The sensor stands: look for no ego motion in the scans where nothing tells it");
  app->add_option("--mount", request->mount, "Sensor in the ego frame: X_M,Y_M,YAW_RAD")
      ->delimiter(',')
      ->expected(3);
  app->add_option("--sensors", request->sensors,
                  "Where the passive sensors are: a TOML file; the input is their bearings")
      ->check(CLI::ExistingFile);
  app->add_option("--calib", request->calibration,
                  "KITTI detections: their calibration file; else looked for beside them");
  app->add_option("--frame-rate", request->frame_rate_hz,
                  "KITTI detections: frames per second, since they tell no time")
      ->check(CLI::Range(0.1, 1e4))
      ->capture_default_str();
  app->add_flag("--paper-axes", request->paper_axes,
                "CSV points have x lateral, y forward, as in [Lu2018]");
  app->add_option("--truth", request->truth.path,
                  "Compare with this truth: a table, KITTI labels, a recording; else with what the "
                  "input carries");
  add_truth_options(*app, request->truth);
  add_scoring_options(*app, request->scoring);
  app->add_flag("--json", request->json, "One JSON object on stdout");
  app->footer(
      "Examples:\n"
      "  scanfuse track drive.mcap -o tracks.mcap --report report.html\n"
      "  scanfuse track lap.bag --ego-topic /ego_pose --mount -0.12,0,0 -o tracks.csv\n"
      "  scanfuse track detections.csv -o tracks.csv\n"
      "  scanfuse track 0000.txt --calib calib/0000.txt --frame-rate 10 -o tracks.csv\n"
      "  scanfuse track bearings.csv --sensors sensors.toml -o tracks.csv\n" +
      passive_track_help());
  auto look = std::make_shared<bool>(false);
  app->add_flag("--view", *look, "Then look at it in a browser, as `scanfuse view` does");
  app->callback([&tool, request, look] {
    int& code = *tool.exit_code;
    code = run(*request, *tool.common);
    if (!*look || (code != kDone && code != kDamagedInput)) return;
    ViewRequest view;
    view.track = *request;
    view.again = true;
    if (const int served = run_view(view, *tool.common); served != kDone) code = served;
  });
}

}  // namespace scanfuse::app
