#include <unistd.h>

#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <thread>

#include "command.hpp"
#include "scanfuse/io/tables.hpp"
#include "scanfuse/serve/http_rules.hpp"
#include "scanfuse/serve/viewer.hpp"
#include "track_run.hpp"
#include "view_run.hpp"

namespace scanfuse::app {
namespace {

/// A browser, where there is a display and a way to open one; never waits for it.
void open_browser(const std::string& address) {
  const char* display = std::getenv("DISPLAY");
  const char* wayland = std::getenv("WAYLAND_DISPLAY");
  if ((display == nullptr || *display == '\0') && (wayland == nullptr || *wayland == '\0')) return;
  const pid_t child = fork();
  if (child != 0) return;
  if (freopen("/dev/null", "w", stderr) == nullptr) _exit(1);
  execlp("xdg-open", "xdg-open", address.c_str(), static_cast<char*>(nullptr));
  _exit(1);
}

std::string address_of(const ViewRequest& request, int port) {
  const bool any = request.server.address == "0.0.0.0" || request.server.address == "::";
  const std::string host = request.server.address == "127.0.0.1" ? "localhost"
                           : any                                 ? "HOST"
                                                                 : request.server.address;
  const bool v6 = host.find(':') != host.npos;
  const std::string query = request.server.token.empty() ? "" : "?token=" + request.server.token;
  return fmt::format("http://{}{}{}:{}/{}", v6 ? "[" : "", host, v6 ? "]" : "", port, query);
}

/// A recording or sensors; what belongs to recordings only is not for sensors.
void check_inputs(const CLI::App& app, bool has_input) {
  const bool is_live = app.count("--live") > 0;
  if (!has_input && !is_live) throw CLI::RequiredError("input or --live");
  for (const char* recorded : {"--topic", "--ego-topic", "--ego", "--mount", "--truth", "--sensors",
                               "--labels", "--again", "--rig"}) {
    if (is_live && app.count(recorded) > 0) throw CLI::ExcludesError("--live", recorded);
  }
}

/// Those that begin with "ros2:" are topics.
void take_topics(LiveRequest& live) {
  constexpr std::string_view kScheme = "ros2:";
  std::vector<std::string> sensors;
  for (auto& text : live.sensors) {
    const bool is_topic = text.starts_with(kScheme);
    if (is_topic) text.erase(0, kScheme.size());
    (is_topic ? live.topics : sensors).push_back(std::move(text));
  }
  live.sensors = std::move(sensors);
  live.ros2 = !live.topics.empty();
}

}  // namespace

int run_view(ViewRequest request, const CommonOptions& common) {
  catch_interrupts();
  if (!serve::is_loopback_address(request.server.address) && request.server.token.empty()) {
    request.server.token = serve::random_token();
  }
  auto view = open_view(request, common);
  if (!view) return report_error(view.error());
  const std::string address = address_of(request, view->viewer.port());
  if (request.json) {
    fmt::print("{{\"address\":\"{}\",\"port\":{}}}\n", address, view->viewer.port());
  } else {
    fmt::print("{}\n", address);
  }
  std::fflush(stdout);
  if (!common.quiet) {
    fmt::print(stderr, "scanfuse: open it in a browser; Ctrl-C ends\n");
    if (!request.stay_closed) open_browser(address);
  }
  bool told = false;
  while (!interrupted) {
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
    const auto status = view->bench->status();
    if (status.done && status.frames == 0) {
      return report_error({Error::Code::kNotFound,
                           status.problem.empty()
                               ? request.track.input + ": no scan in it that scanfuse can read; "
                                                       "`scanfuse info` lists what is there"
                               : status.problem});
    }
    if (status.done && !told) {
      told = true;
      if (!status.problem.empty()) report_error({Error::Code::kMalformed, status.problem});
      report_diagnostics(view->bench->diagnostics(), common.quiet);
    }
  }
  return kDone;
}

void add_view(Tool& tool) {
  auto request = std::make_shared<ViewRequest>();
  request->track.scoring.options.min_visible_points = 1;
  auto* app = tool.app->add_subcommand("view", "Look at a recording and its tracks in a browser");
  auto* input = app->add_option("input", request->track.input,
                                "Recording (file or folder), points in CSV, tracks (MCAP) of ours");
  app->add_option("--live", request->live.sensors,
                  "Sensors that are running in place of a recording, as "
                  "sick://192.168.0.1:2112, or topics of ROS 2, as ros2:/scan; may be repeated")
      ->allow_extra_args(false)
      ->excludes(input);
  app->add_option("--rig", request->rig,
                  "Calibrated turntable (rig.toml): the input is a session of its scans");
  app->add_option(
         "--preset", request->track.preset,
         fmt::format("Options to start from: {}", fmt::join(pipeline::preset_names(), ", ")))
      ->capture_default_str();
  app->add_option("--config", request->track.config, "Options from a TOML file");
  app->add_option("--set", request->track.set, "Change an option: section.option=value")
      ->allow_extra_args(false);
  app->add_option("--topic", request->track.topics, "Only this scan topic; may be repeated")
      ->allow_extra_args(false);
  app->add_option("--ego-topic", request->track.ego_topic,
                  "Topic of the ego pose: Odometry, PoseStamped, PoseWithCovarianceStamped");
  app->add_option("--ego", request->track.ego_file, "Ego motion beside the recording, as CSV");
  app->add_flag("--standing", request->track.standing,
                "The sensor stands: look for no ego motion in the scans where nothing tells it");
  app->add_option("--mount", request->track.mount, "Sensor in the ego frame: X_M,Y_M,YAW_RAD")
      ->delimiter(',')
      ->expected(3);
  app->add_flag("--paper-axes", request->track.paper_axes,
                "CSV points have x lateral, y forward, as in [Lu2018]");
  app->add_option("--truth", request->track.truth.path,
                  "Show and compare with this truth: a table, KITTI labels, a recording");
  add_truth_options(*app, request->track.truth);
  app->add_option("--sensors", request->track.sensors,
                  "Where the passive sensors are: a TOML file; the input is their bearings")
      ->check(CLI::ExistingFile);
  app->add_flag("--again", request->again,
                "Track again, though the recording carries tracks of ours");
  app->add_option("--labels", request->labels,
                  "Where labels are saved, a truth CSV; read first where it exists");
  app->add_option("--port", request->server.port, "Port to serve on; without it 8765 or after")
      ->check(CLI::Range(0, 65535));
  app->add_option("--listen", request->server.address,
                  "Address to listen on; outside loopback a token is needed, which is printed")
      ->capture_default_str();
  app->add_option("--token", request->server.token, "The token, instead of a random one");
  app->add_option("--allow-origin", request->server.allowed_origins,
                  "Let pages of this origin connect (https://app.foxglove.dev); may be repeated")
      ->allow_extra_args(false);
  app->add_option("--max-clients", request->server.max_clients, "Websockets at a time")
      ->check(CLI::Range(1, 1000))
      ->capture_default_str();
  app->add_flag("--json", request->json, "The address as a JSON object on stdout");
  app->add_flag("--no-browser", request->stay_closed, "Print the address only");
  app->footer(
      "Examples:\n"
      "  scanfuse view drive.mcap\n"
      "  scanfuse view lap.bag --ego-topic /ego_pose --mount -0.12,0,0 --preset vehicle-model\n"
      "  scanfuse view bearings.csv --sensors sensors.toml\n"
      "  scanfuse view session/scan --rig rig.toml\n"
      "  scanfuse view tracks.mcap --labels truth.csv\n"
      "  scanfuse view --live sick://192.168.0.1:2112 --preset road-users\n"
      "  scanfuse view --live ros2:/scan\n"
      "  scanfuse view drive.mcap --listen 0.0.0.0 --port 8080\n"
      "Foxglove and Lichtblick connect to the same port: ws://localhost:8765.\n");
  app->callback([&tool, app, input, request] {
    check_inputs(*app, input->count() > 0);
    take_topics(request->live);
    request->live.standing = request->track.standing;
    request->server.next_free_port = app->count("--port") == 0;
    request->has_preset = app->count("--preset") > 0;
    *tool.exit_code = run_view(*request, *tool.common);
  });
}

}  // namespace scanfuse::app
