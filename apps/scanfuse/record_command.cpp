#include <chrono>
#include <nlohmann/json.hpp>

#include "live_request.hpp"
#include "scanfuse/io/mcap/recording_writer.hpp"

namespace scanfuse::app {
namespace {

using SteadyClock = std::chrono::steady_clock;

constexpr auto kCheckpoint = std::chrono::milliseconds(500);
constexpr drivers::Milliseconds kPatience{100};

struct RecordRequest {
  LiveRequest live;
  std::string out;
  bool json = false;
};

/// Writes what comes until it is time to stop.
Result<std::int64_t> record_all(const RecordRequest& request, pipeline::LiveStream& reader,
                                io::McapRecordingWriter& writer, bool quiet) {
  const auto start = SteadyClock::now();
  auto saved = start;
  std::int64_t scans = 0;
  Progress progress("recording", quiet);
  while (!interrupted) {
    auto event = reader.next_within(kPatience);
    const auto now = SteadyClock::now();
    if (event) {
      if (std::holds_alternative<Scan>(event->payload)) {
        event->topic.clear();  // the writer has a form for the topics of sensors
        ++scans;
      }
      if (auto done = writer.write(*event); !done) return tl::unexpected(done.error());
    }
    if (now - saved >= kCheckpoint) {
      if (auto done = writer.checkpoint(); !done) return tl::unexpected(done.error());
      saved = now;
    }
    progress.update(scans);
    if (request.live.seconds > 0 && to_seconds(now - start) >= request.live.seconds) break;
  }
  return scans;
}

int run_record(RecordRequest request, const CommonOptions& common) {
  catch_interrupts();
  request.live.waiting = std::max(request.live.waiting, 1000);
  auto input = open_live(request.live);
  if (!input) return report_error(input.error());
  pipeline::LiveStream& stream = *input->stream;
  auto writer = io::McapRecordingWriter::create(request.out);
  if (!writer) return report_error(writer.error());
  const auto scans = record_all(request, stream, *writer, common.quiet);
  if (!scans) return report_error(scans.error());
  if (auto done = writer->finish(); !done) return report_error(done.error());
  if (request.json) {
    const nlohmann::json told{
        {"output", request.out}, {"scans", *scans}, {"sensors", sensors_json(stream)}};
    fmt::print("{}\n", told.dump(2));
  } else if (!common.quiet) {
    print_sensors(stream);
  }
  return interrupted ? kInterrupted : kDone;
}

}  // namespace

void add_record(Tool& tool) {
  auto request = std::make_shared<RecordRequest>();
  auto* app = tool.app->add_subcommand("record", "Record live sensors");
  add_live_options(*app, request->live);
  app->add_option("-o,--output", request->out, "Recording to write: .mcap")->required();
  app->add_flag("--json", request->json, "One JSON object on stdout, at the end");
  app->footer(sensors_help() +
              "What came is on disk within a second, in OUT.part until the end: should the\n"
              "recording be killed, `scanfuse info OUT.part` reads what there is.\n"
              "Example:\n  scanfuse record sick://192.168.0.1:2112 -o drive.mcap --seconds 60\n");
  app->callback([&tool, request] { *tool.exit_code = run_record(*request, *tool.common); });
}

}  // namespace scanfuse::app
