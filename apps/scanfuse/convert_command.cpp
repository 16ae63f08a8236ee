#include <filesystem>
#include <functional>
#include <memory>

#include "command.hpp"
#include "scanfuse/io/csv/points_writer.hpp"
#include "scanfuse/io/mcap/recording_writer.hpp"
#include "scanfuse/io/recording.hpp"
#include "scanfuse/io/tables.hpp"

namespace scanfuse::app {
namespace {

struct ConvertOptions {
  std::string input, output, ego_out, truth_out, ego_topic;
  std::vector<std::string> topics;
  bool paper_axes = false;
};

/// Where events go; which writer is behind it depends on the output's name.
struct EventSink {
  std::function<Result<void>(const io::Event&)> write;
  std::function<Result<void>()> finish;
};

EventSink csv_sink(io::CsvPointsWriter made) {
  auto writer = std::make_shared<io::CsvPointsWriter>(std::move(made));
  return {[writer](const io::Event& event) -> Result<void> {
            const auto* scan = std::get_if<Scan>(&event.payload);
            return scan == nullptr ? Result<void>{} : writer->write(*scan);
          },
          [writer] { return writer->finish(); }};
}

EventSink mcap_sink(io::McapRecordingWriter made) {
  auto writer = std::make_shared<io::McapRecordingWriter>(std::move(made));
  return {[writer](const io::Event& event) { return writer->write(event); },
          [writer] { return writer->finish(); }};
}

Result<EventSink> open_sink(const std::filesystem::path& path) {
  const std::string extension = path.extension().string();
  if (extension == ".csv") {
    auto writer = io::CsvPointsWriter::create(path);
    if (!writer) return tl::unexpected(writer.error());
    return csv_sink(std::move(*writer));
  }
  if (extension == ".mcap") {
    auto writer = io::McapRecordingWriter::create(path);
    if (!writer) return tl::unexpected(writer.error());
    return mcap_sink(std::move(*writer));
  }
  return fail(Error::Code::kUnsupported,
              "{}: recordings are written as .mcap or .csv (points), not as '{}'", path.string(),
              extension);
}

/// The poses and truth that go to tables of their own.
struct SideTables {
  std::vector<PoseSample> poses;
  std::vector<TruthFrame> truth;
  std::string ego_topic;
  std::int64_t empty_scans = 0;

  void take(const io::Event& event, const ConvertOptions& options) {
    if (const auto* pose = std::get_if<PoseSample>(&event.payload);
        pose != nullptr && !options.ego_out.empty()) {
      if (ego_topic.empty()) ego_topic = event.topic;
      if (ego_topic == event.topic) poses.push_back(*pose);
    }
    if (const auto* frame = std::get_if<TruthFrame>(&event.payload);
        frame != nullptr && !options.truth_out.empty()) {
      truth.push_back(*frame);
    }
    if (const auto* scan = std::get_if<Scan>(&event.payload)) {
      empty_scans += scan->returns.empty() ? 1 : 0;
    }
  }

  Result<void> write(const ConvertOptions& options) const {
    if (!options.ego_out.empty()) {
      if (poses.empty()) {
        return fail(Error::Code::kNotFound, "{}: no poses{}{} for {}", options.input,
                    options.ego_topic.empty() ? "" : " on ", options.ego_topic, options.ego_out);
      }
      if (auto wrote = io::write_ego_csv(options.ego_out, poses); !wrote) return wrote;
    }
    if (!options.truth_out.empty()) {
      if (truth.empty()) {
        return fail(Error::Code::kNotFound, "{}: carries no truth for {}", options.input,
                    options.truth_out);
      }
      return io::write_truth_csv(options.truth_out, truth);
    }
    return {};
  }
};

Result<int> copy_events(const ConvertOptions& options, bool quiet) {
  io::OpenOptions open{options.topics, options.paper_axes};
  if (!open.topics.empty() && !options.ego_topic.empty()) open.topics.push_back(options.ego_topic);
  auto reader = io::open_recording(options.input, open);
  if (!reader) return tl::unexpected(reader.error());
  for (const auto& path : {options.output, options.ego_out, options.truth_out}) {
    if (auto fine = refuse_to_replace(options.input, path); !fine)
      return tl::unexpected(fine.error());
  }
  auto sink = open_sink(options.output);
  if (!sink) return tl::unexpected(sink.error());
  SideTables tables;
  tables.ego_topic = options.ego_topic;
  std::int64_t done = 0;
  {
    Progress progress("converting", quiet);
    while (!interrupted) {
      const auto event = (*reader)->next();
      if (!event) return tl::unexpected(event.error());
      if (!*event) break;
      if (auto wrote = sink->write(**event); !wrote) return tl::unexpected(wrote.error());
      tables.take(**event, options);
      progress.update(++done);
    }
  }
  if (done == 0 && !interrupted) {
    return fail(Error::Code::kNotFound, "{}: nothing to convert on the topics asked for",
                options.input);
  }
  if (auto finished = sink->finish(); !finished) return tl::unexpected(finished.error());
  if (auto wrote = tables.write(options); !wrote) return tl::unexpected(wrote.error());
  Diagnostics diagnostics = (*reader)->diagnostics();
  if (tables.empty_scans > 0 && options.output.ends_with(".csv")) {
    diagnostics.note("scans without returns leave no row", options.output, tables.empty_scans);
  }
  const int code = report_diagnostics(diagnostics, quiet);
  return interrupted ? static_cast<int>(kInterrupted) : code;
}

int run_convert(const ConvertOptions& options, bool quiet) {
  catch_interrupts();
  const auto code = copy_events(options, quiet);
  return code ? *code : report_error(code.error());
}

}  // namespace

void add_convert(Tool& tool) {
  auto options = std::make_shared<ConvertOptions>();
  CLI::App* command = tool.app->add_subcommand("convert", "Write a recording in another format");
  command->add_option("IN", options->input, "A recording: a file or a folder")->required();
  command->add_option("OUT", options->output, "The file to write: .mcap, or .csv with the points")
      ->required();
  command->add_option("--topic", options->topics, "Only this topic; may be given again")
      ->allow_extra_args(false);
  command->add_option("--ego-out", options->ego_out, "Also write the ego motion as CSV");
  command->add_option("--ego-topic", options->ego_topic, "Whose poses; else the first with any");
  command->add_option("--truth-out", options->truth_out, "Also write the truth it carries as CSV");
  command->add_flag("--paper-axes", options->paper_axes,
                    "CSV input has x to the right and y ahead");
  command->footer("Example: scanfuse convert drive.bag points.csv --ego-out ego.csv");
  command->callback(
      [tool, options] { *tool.exit_code = run_convert(*options, tool.common->quiet); });
}

}  // namespace scanfuse::app
