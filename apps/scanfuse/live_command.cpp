#include <algorithm>
#include <chrono>
#include <nlohmann/json.hpp>

#include "live_request.hpp"
#include "live_run.hpp"
#include "scanfuse/io/csv/track_rows.hpp"
#include "scanfuse/io/result_writer.hpp"
#include "scanfuse/pipeline/ros2_results.hpp"
#include "track_outputs.hpp"

namespace scanfuse::app {
namespace {

struct LiveCommand {
  LiveRequest live;
  std::string ros2_name = "scanfuse";
  TrackRequest track;
  bool json = false;
};

/// Where live tracks go: files, ROS 2, and stdout as JSON lines where there is neither.
class LiveOutputs {
 public:
  [[nodiscard]] static Result<LiveOutputs> open(const std::vector<std::string>& paths,
                                                std::optional<pipeline::Ros2Results> ros2) {
    LiveOutputs outputs;
    outputs.ros2_ = std::move(ros2);
    for (const auto& path : paths) {
      if (path == "-") continue;
      auto writer = io::open_result_writer(path);
      if (!writer) return tl::unexpected(writer.error());
      outputs.files_.push_back(std::move(*writer));
    }
    outputs.stdout_ = outputs.files_.size() < paths.size() || (paths.empty() && !outputs.ros2_);
    return outputs;
  }

  Result<void> write(const StepResult& step, const pipeline::PosedScan& posed) {
    for (auto& file : files_) {
      if (auto done = file->write(step, posed.scan); !done) return done;
    }
    if (ros2_) ros2_->write(step, posed);
    if (!stdout_) return {};
    const std::string rows = io::track_json_rows(step);
    if (std::fwrite(rows.data(), 1, rows.size(), stdout) != rows.size() ||
        std::fflush(stdout) != 0) {
      return fail(Error::Code::kNotFound, "stdout: nobody reads it any more");
    }
    return {};
  }
  Result<void> finish(const std::vector<std::string>& paths,
                      const pipeline::PerceptionOptions& options) {
    for (auto& file : files_) {
      if (auto done = file->finish(); !done) return done;
    }
    std::vector<std::string> results;
    std::ranges::copy_if(paths, std::back_inserter(results), [](auto& p) { return p != "-"; });
    return write_configurations(results, pipeline::view_config(options));
  }

  [[nodiscard]] Diagnostics diagnostics() const {
    return ros2_ ? ros2_->diagnostics() : Diagnostics{};
  }

 private:
  std::vector<std::unique_ptr<io::ResultWriter>> files_;
  std::optional<pipeline::Ros2Results> ros2_;
  bool stdout_ = false;
};

void print_summary(const LiveCommand& command, const LiveOutcome& outcome,
                   const pipeline::LiveStream& stream) {
  if (command.json) {
    const nlohmann::json json{{"scans", outcome.scans},
                              {"confirmed_tracks", outcome.tracks},
                              {"latency_s", latency_json(outcome)},
                              {"sensors", sensors_json(stream)},
                              {"outputs", command.track.outputs},
                              {"diagnostics", diagnostics_json(outcome.diagnostics)}};
    fmt::print("{}\n", json.dump(2));
    return;
  }
  print_sensors(stream);
  fmt::print(stderr,
             "scanfuse: {} scans, {} confirmed tracks; from last byte to tracks: median {:.2f} "
             "ms, 99 % {:.2f} ms, longest {:.2f} ms\n",
             outcome.scans, outcome.tracks, 1e3 * outcome.latency_s(0.5),
             1e3 * outcome.latency_s(0.99), 1e3 * outcome.latency_s(1));
}

Result<LiveOutputs> open_outputs(const LiveCommand& command, const LiveInput& input) {
  std::optional<pipeline::Ros2Results> ros2;
  if (input.bus) {
    const bool with_scans = command.live.topics.empty();
    auto opened = pipeline::Ros2Results::open(input.bus, {command.ros2_name, with_scans});
    if (!opened) return tl::unexpected(opened.error());
    ros2 = std::move(*opened);
  }
  return LiveOutputs::open(command.track.outputs, std::move(ros2));
}

/// Nothing has come for a while: which sensor is it that says nothing?
void say_who_is_silent(const pipeline::LiveStream& stream) {
  for (const auto& [name, status] : stream.status()) {
    if (status.scans > 0 || name.starts_with("/tf")) continue;
    fmt::print(stderr, "scanfuse: waiting for {}{}{}\n", name,
               status.last_error.empty() ? "" : ": ", status.last_error);
  }
}

int run_live_command(const LiveCommand& command, const CommonOptions& common) {
  catch_interrupts();
  const auto options = resolve_options(command.track);
  if (!options) return report_error(options.error());
  const auto& paths = command.track.outputs;
  const bool rows_on_stdout =
      (paths.empty() && !command.live.ros2) || std::ranges::count(paths, std::string("-")) > 0;
  if (command.json && rows_on_stdout) {
    return report_error({Error::Code::kUnsupported,
                         "--json says one object on stdout: give tracks a file with -o"});
  }
  auto input = open_live(command.live);
  if (!input) return report_error(input.error());
  auto outputs = open_outputs(command, *input);
  if (!outputs) return report_error(outputs.error());
  pipeline::LiveStream& stream = *input->stream;
  pipeline::ScanFeed feed(std::move(input->stream), input->feed);
  const TakeStep take = [&](const StepResult& step, const pipeline::PosedScan& posed) {
    return outputs->write(step, posed);
  };
  const std::function<void()> waiting = [&] {
    if (!common.quiet) say_who_is_silent(stream);
  };
  auto outcome = run_live(feed, stream, *options, command.live.seconds, take, waiting);
  if (!outcome) return report_error(outcome.error());
  outcome->diagnostics.merge(outputs->diagnostics());
  if (auto done = outputs->finish(paths, *options); !done) return report_error(done.error());
  if (command.json || !common.quiet) print_summary(command, *outcome, stream);
  return interrupted ? kInterrupted : kDone;
}

}  // namespace

void add_live(Tool& tool) {
  auto command = std::make_shared<LiveCommand>();
  auto* app = tool.app->add_subcommand("live", "Track what live sensors see");
  add_live_options(*app, command->live);
  app->add_option("-o,--output", command->track.outputs,
                  "Where tracks go: .mcap, .csv, .jsonl, or - for JSON lines on stdout")
      ->allow_extra_args(false);
  app->add_option(
         "--preset", command->track.preset,
         fmt::format("Options to start from: {}", fmt::join(pipeline::preset_names(), ", ")))
      ->capture_default_str();
  app->add_option("--config", command->track.config, "Options from a TOML file");
  app->add_option("--set", command->track.set, "Change an option: section.option=value")
      ->allow_extra_args(false);
  app->add_option("--ros2-name", command->ros2_name,
                  "With --ros2 the topics are /NAME/tracks, /NAME/markers, /NAME/SENSOR/scan")
      ->capture_default_str();
  app->add_flag("--json", command->json, "One JSON object on stdout, at the end");
  app->footer(sensors_help() +
              "Example:\n  scanfuse live sick://192.168.0.1:2112 vlp16://:2368 "
              "--mount 3.7,0,0 --mount 1.3,0,0 -o tracks.jsonl\n"
              "  scanfuse live --ros2 --topic /scan\n");
  app->callback([&tool, command] { *tool.exit_code = run_live_command(*command, *tool.common); });
}

}  // namespace scanfuse::app
