#include <cstdio>
#include <filesystem>
#include <memory>
#include <system_error>

#include "command.hpp"
#include "scanfuse/io/mcap/recording_writer.hpp"
#include "scanfuse/simulate/simulate.hpp"
#include "serve.hpp"

namespace scanfuse::app {
namespace {

namespace fs = std::filesystem;
using simulate::SimulatedFrame;
using simulate::SimulateOptions;
using simulate::Simulation;

/// A text file written beside its name and moved into place when whole; removed otherwise.
class SimulatedTable {
 public:
  explicit SimulatedTable(fs::path target)
      : target_(std::move(target)),
        part_(target_.string() + ".part"),
        file_(std::fopen(part_.c_str(), "wb")) {}
  SimulatedTable(const SimulatedTable&) = delete;
  SimulatedTable& operator=(const SimulatedTable&) = delete;
  ~SimulatedTable() {
    if (file_ == nullptr) return;
    std::fclose(file_);
    std::error_code ignored;
    fs::remove(part_, ignored);
  }

  [[nodiscard]] bool open() const { return file_ != nullptr; }
  template <class... Args>
  void line(fmt::format_string<Args...> text, Args&&... args) {
    const std::string row = fmt::format(text, std::forward<Args>(args)...) + "\n";
    sound_ = sound_ && std::fwrite(row.data(), 1, row.size(), file_) == row.size();
  }
  [[nodiscard]] Result<void> finish() {
    sound_ = std::fclose(std::exchange(file_, nullptr)) == 0 && sound_;
    std::error_code error;
    if (sound_) fs::rename(part_, target_, error);
    if (sound_ && !error) return {};
    return fail(Error::Code::kNotFound, "{}: cannot be written; is the disk full?",
                target_.string());
  }

 private:
  fs::path target_, part_;
  std::FILE* file_;
  bool sound_ = true;
};

/// Where simulated frames go.
class SimulatedOutput {
 public:
  virtual ~SimulatedOutput() = default;
  [[nodiscard]] virtual Result<void> write(const SimulatedFrame& frame) = 0;
  [[nodiscard]] virtual Result<void> finish() = 0;
};

/// OUT.csv (points), OUT.truth.csv and OUT.ego.csv, in the columns `scanfuse track` and `evaluate`
/// read.
class SimulatedCsv : public SimulatedOutput {
 public:
  explicit SimulatedCsv(const fs::path& out)
      : points_(out),
        truth_(fs::path(out).replace_extension(".truth.csv")),
        ego_(fs::path(out).replace_extension(".ego.csv")) {
    if (!open()) return;
    points_.line("frame,time_s,x_m,y_m,z_m,layer,intensity,sensor");
    truth_.line(
        "frame,time_s,object_id,class,x_m,y_m,heading_rad,vx_m_per_s,vy_m_per_s,length_m,width_m,"
        "visible_points,occluded");
    ego_.line("time_s,x_m,y_m,heading_rad,speed_m_per_s,yaw_rate_rad_per_s");
  }
  [[nodiscard]] bool open() const { return points_.open() && truth_.open() && ego_.open(); }

  Result<void> write(const SimulatedFrame& frame) override {
    const double time_s = to_seconds(frame.scan.stamp);
    for (const Return& r : frame.scan.returns) {
      points_.line("{},{:.6f},{:.4f},{:.4f},{:.4f},{},{:.2f},{}", frame.scan.frame, time_s, r.x_m,
                   r.y_m, r.z_m, r.layer, r.intensity, frame.scan.sensor);
    }
    for (const TruthObject& o : frame.truth.objects) {
      truth_.line("{},{:.6f},{},{},{:.4f},{:.4f},{:.5f},{:.4f},{:.4f},{:.3f},{:.3f},{},{:.4f}",
                  frame.truth.frame, time_s, o.id, to_string(o.object_class), o.position_m.x(),
                  o.position_m.y(), o.heading_rad.value_or(0), o.velocity_m_per_s->x(),
                  o.velocity_m_per_s->y(), o.length_m.value_or(0), o.width_m.value_or(0),
                  o.visible_points.value_or(0), o.occluded.value_or(0));
    }
    const Pose2 ego = frame.ego.pose.planar();
    ego_.line("{:.6f},{:.5f},{:.5f},{:.6f},{:.5f},{:.6f}", time_s, ego.x_m, ego.y_m,
              ego.heading_rad, frame.ego.speed_m_per_s.value_or(0),
              frame.ego.yaw_rate_rad_per_s.value_or(0));
    return {};
  }
  Result<void> finish() override {
    if (auto done = points_.finish(); !done) return done;
    if (auto done = truth_.finish(); !done) return done;
    return ego_.finish();
  }

 private:
  SimulatedTable points_, truth_, ego_;
};

/// One recording: scans, odometry, the sensor's mounting as a static transform, truth.
class SimulatedMcap : public SimulatedOutput {
 public:
  SimulatedMcap(io::McapRecordingWriter writer, const Pose3& ego_from_sensor)
      : writer_(std::move(writer)), ego_from_sensor_(ego_from_sensor) {}

  Result<void> write(const SimulatedFrame& frame) override {
    const Time stamp = frame.scan.stamp;
    if (!std::exchange(mounted_, true)) {
      const TransformSample mount{stamp, frame.ego.child_frame_id, frame.scan.frame_id,
                                  ego_from_sensor_, true};
      if (auto done = writer_.write({stamp, "", std::vector{mount}}); !done) return done;
    }
    if (auto done = writer_.write({stamp, "/odom", frame.ego}); !done) return done;
    if (auto done = writer_.write({stamp, frame.scan.sensor, frame.scan}); !done) return done;
    return writer_.write({stamp, "", frame.truth});
  }
  Result<void> finish() override { return writer_.finish(); }

 private:
  io::McapRecordingWriter writer_;
  Pose3 ego_from_sensor_;
  bool mounted_ = false;
};

Result<std::unique_ptr<SimulatedOutput>> open_simulated_output(const fs::path& path,
                                                               const Pose3& ego_from_sensor) {
  if (path.extension() == ".mcap") {
    auto writer = io::McapRecordingWriter::create(path);
    if (!writer) return tl::unexpected(writer.error());
    return std::make_unique<SimulatedMcap>(std::move(*writer), ego_from_sensor);
  }
  if (path.extension() == ".csv") {
    auto csv = std::make_unique<SimulatedCsv>(path);
    if (csv->open()) return csv;
    return fail(Error::Code::kNotFound, "{}: cannot be created; does its folder exist?",
                path.string());
  }
  return fail(Error::Code::kUnsupported, "{}: write to a file ending in .mcap or .csv",
              path.string());
}

struct SimulateCommand {
  std::string scenario;
  std::string out;
  std::string sensor = "lux";
  std::vector<std::string> sets;
  std::vector<std::string> serve;
  bool sensor_named = false;
  SimulateOptions options;
};

Result<SimulateOptions> simulate_options(const SimulateCommand& command) {
  SimulateOptions options = command.options;
  if (auto done = set_option(options, "sensor", command.sensor); !done) {
    return tl::unexpected(done.error());
  }
  if (auto done = apply_settings(options, "simulate", command.sets); !done) {
    return tl::unexpected(done.error());
  }
  return options;
}

int run_serve(const SimulateCommand& command, const SimulateOptions& options,
              const CommonOptions& common) {
  ServeRequest request{command.scenario, command.serve, {}, options};
  if (command.sensor_named) request.sensor = command.sensor;
  if (auto done = serve_scenario(request, common); !done) return report_error(done.error());
  return interrupted ? kInterrupted : kDone;
}

int run_simulate(const SimulateCommand& command, const CommonOptions& common) {
  catch_interrupts();
  const auto options = simulate_options(command);
  if (!options) return report_error(options.error());
  if (!command.serve.empty()) return run_serve(command, *options, common);
  auto simulation = Simulation::create(command.scenario, common.seed, *options);
  if (!simulation) return report_error(simulation.error());
  auto output = open_simulated_output(command.out, simulation->ego_from_sensor());
  if (!output) return report_error(output.error());

  Progress progress("simulating", common.quiet);
  std::int64_t done = 0;
  while (!interrupted) {
    const auto frame = simulation->next();
    if (!frame) break;
    if (auto written = (*output)->write(*frame); !written) return report_error(written.error());
    progress.update(++done, simulation->frames());
  }
  if (auto finished = (*output)->finish(); !finished) return report_error(finished.error());
  return interrupted ? kInterrupted : kDone;
}

std::string simulate_help() {
  std::string text = "Scenarios:\n";
  for (const auto& [name, doc] : simulate::scenarios())
    text += fmt::format("  {:<12} {}\n", name, doc);
  text += "Settings (--set simulate.NAME=VALUE):\n";
  for (const auto& view : view_options("simulate", SimulateOptions{})) {
    text += fmt::format("  {:<14} {} [{}; {}]\n", view.name, view.doc, view.fallback, view.range);
  }
  return text +
         "Examples:\n  scanfuse simulate lu2018-2 -o lu2018-2.mcap --seed 7\n"
         "  scanfuse simulate lu2018-2 --serve sick:2112 --serve ibeo:12002\n";
}

}  // namespace

void add_simulate(Tool& tool) {
  auto command = std::make_shared<SimulateCommand>();
  auto* app = tool.app->add_subcommand("simulate", "Make a recording with truth from a scenario");
  app->add_option("scenario", command->scenario, "Name of the scenario");
  app->add_option("-o,--output", command->out,
                  "Recording to write: .mcap, or .csv with .truth.csv and .ego.csv beside it");
  app->add_option(
         "--sensor", command->sensor,
         "Lidar: lux, sick-lms111, sick-lms291, hokuyo-utm30, rplidar-a2, vlp16, hdl32, hdl64")
      ->capture_default_str();
  app->add_option("--serve", command->serve,
                  "Play devices instead, in real time: sick:2112, vlp16:2368, ...; may be repeated")
      ->allow_extra_args(false);
  app->add_option("--frames", command->options.frames,
                  "Scans to make; 0: as long as the scenario is")
      ->check(CLI::Range(0, 1000000))
      ->capture_default_str();
  app->add_option("--set", command->sets, "Change a setting: simulate.NAME=VALUE");
  app->footer(simulate_help());
  add_simulate_passive(*app, tool);
  add_simulate_turntable(*app, tool);
  app->callback([command, tool, app] {
    if (app->got_subcommand("passive") || app->got_subcommand("turntable")) return;
    if (command->scenario.empty()) throw CLI::RequiredError("scenario");
    command->sensor_named = app->count("--sensor") > 0;
    if (command->out.empty() && command->serve.empty()) throw CLI::RequiredError("--output");
    *tool.exit_code = run_simulate(*command, *tool.common);
  });
}

}  // namespace scanfuse::app
