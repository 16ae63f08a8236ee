#include <algorithm>
#include <chrono>
#include <nlohmann/json.hpp>

#include "live_request.hpp"
#include "live_run.hpp"
#include "scanfuse/io/csv/track_rows.hpp"
#include "scanfuse/io/result_writer.hpp"
#include "track_outputs.hpp"

namespace scanfuse::app {
namespace {

struct LiveCommand {
  LiveRequest live;
  TrackRequest track;
  bool json = false;
};

/// Where live tracks go: files, and stdout as JSON lines where there are none.
class LiveOutputs {
 public:
  [[nodiscard]] static Result<LiveOutputs> open(const std::vector<std::string>& paths) {
    LiveOutputs outputs;
    for (const auto& path : paths) {
      if (path == "-") continue;
      auto writer = io::open_result_writer(path);
      if (!writer) return tl::unexpected(writer.error());
      outputs.files_.push_back(std::move(*writer));
    }
    outputs.stdout_ = outputs.files_.size() < paths.size() || paths.empty();
    return outputs;
  }

  Result<void> write(const StepResult& step, const Scan& scan) {
    for (auto& file : files_) {
      if (auto done = file->write(step, scan); !done) return done;
    }
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

 private:
  std::vector<std::unique_ptr<io::ResultWriter>> files_;
  bool stdout_ = false;
};

void print_summary(const LiveCommand& command, const LiveOutcome& outcome,
                   const pipeline::LiveReader& reader) {
  if (command.json) {
    const nlohmann::json json{{"scans", outcome.scans},
                              {"confirmed_tracks", outcome.tracks},
                              {"latency_s", latency_json(outcome)},
                              {"sensors", sensors_json(reader)},
                              {"outputs", command.track.outputs},
                              {"diagnostics", diagnostics_json(outcome.diagnostics)}};
    fmt::print("{}\n", json.dump(2));
    return;
  }
  print_sensors(reader);
  fmt::print(stderr,
             "scanfuse: {} scans, {} confirmed tracks; from last byte to tracks: median {:.2f} "
             "ms, 99 % {:.2f} ms, longest {:.2f} ms\n",
             outcome.scans, outcome.tracks, 1e3 * outcome.latency_s(0.5),
             1e3 * outcome.latency_s(0.99), 1e3 * outcome.latency_s(1));
}

int run_live_command(const LiveCommand& command, const CommonOptions& common) {
  catch_interrupts();
  const auto options = resolve_options(command.track);
  if (!options) return report_error(options.error());
  if (command.json && (command.track.outputs.empty() ||
                       std::ranges::count(command.track.outputs, std::string("-")) > 0)) {
    return report_error({Error::Code::kUnsupported,
                         "--json says one object on stdout: give tracks a file with -o"});
  }
  auto outputs = LiveOutputs::open(command.track.outputs);
  if (!outputs) return report_error(outputs.error());
  auto reader = open_live(command.live);
  if (!reader) return report_error(reader.error());
  pipeline::LiveReader& live = **reader;
  pipeline::ScanFeed feed(std::move(*reader), {});
  auto outcome = run_live(
      feed, live, *options, command.live.seconds,
      [&](const StepResult& step, const Scan& scan) { return outputs->write(step, scan); });
  if (!outcome) return report_error(outcome.error());
  if (auto done = outputs->finish(command.track.outputs, *options); !done) {
    return report_error(done.error());
  }
  if (command.json || !common.quiet) print_summary(command, *outcome, live);
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
  app->add_flag("--json", command->json, "One JSON object on stdout, at the end");
  app->footer(sensors_help() +
              "Example:\n  scanfuse live sick://192.168.0.1:2112 vlp16://:2368 "
              "--mount 3.7,0,0 --mount 1.3,0,0 -o tracks.jsonl\n");
  app->callback([&tool, command] { *tool.exit_code = run_live_command(*command, *tool.common); });
}

}  // namespace scanfuse::app
