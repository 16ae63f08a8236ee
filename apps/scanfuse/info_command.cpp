#include <algorithm>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>

#include "command.hpp"
#include "scanfuse/io/recording.hpp"
#include "scanfuse/io/text/numbers.hpp"
#include "scanfuse/pipeline/capture_reader.hpp"

namespace scanfuse::app {
namespace {

struct InfoOptions {
  std::string input;
  std::string sensor;
  bool json = false;
  bool check = false;
};

/// What `info` tells: the reader's own account, completed by reading where it has no index.
struct RecordingSummary {
  io::RecordingInfo info;
  Diagnostics diagnostics;
  bool stopped = false;  ///< by Ctrl-C: counts are of what was read
};

bool needs_reading(const io::RecordingInfo& info) {
  const bool uncounted = std::any_of(info.topics.begin(), info.topics.end(),
                                     [](const io::TopicInfo& topic) { return !topic.counted; });
  return uncounted || !info.start || !info.end;
}

Result<RecordingSummary> summarise(const InfoOptions& options, bool quiet) {
  auto reader = pipeline::open_any_recording(options.input, {}, {options.sensor, {}});
  if (!reader) return tl::unexpected(reader.error());
  RecordingSummary summary;
  if (options.check || needs_reading((*reader)->info())) {
    std::map<std::string, std::int64_t> seen;
    std::optional<Time> start, end;
    Progress progress("reading", quiet);
    std::int64_t done = 0;
    while (!interrupted) {
      auto event = (*reader)->next();
      if (!event) return tl::unexpected(event.error());
      if (!*event) break;
      ++seen[(*event)->topic];
      start = std::min(start.value_or((*event)->log_time), (*event)->log_time);
      end = std::max(end.value_or((*event)->log_time), (*event)->log_time);
      progress.update(++done);
    }
    summary.info = (*reader)->info();
    if (!summary.info.start) summary.info.start = start;
    if (!summary.info.end) summary.info.end = end;
    for (io::TopicInfo& topic : summary.info.topics) {
      if (topic.messages == 0) topic.messages = seen[topic.name];
    }
    summary.stopped = interrupted;
  } else {
    summary.info = (*reader)->info();
  }
  summary.diagnostics = (*reader)->diagnostics();
  return summary;
}

double duration_s(const io::RecordingInfo& info) {
  return info.start && info.end ? to_seconds(*info.end) - to_seconds(*info.start) : 0;
}

/// Messages a second between the first and the last of the recording; 0 where that says nothing.
double rate_hz(const io::RecordingInfo& info, const io::TopicInfo& topic) {
  const double duration = duration_s(info);
  return duration > 0 && topic.messages > 1 ? static_cast<double>(topic.messages - 1) / duration
                                            : 0;
}

using Json = nlohmann::ordered_json;

Json seconds_or_null(const std::optional<Time>& time) {
  return time ? Json(to_seconds(*time)) : Json(nullptr);
}

Json as_json(const RecordingSummary& summary) {
  const auto& info = summary.info;
  Json topics = Json::array();
  for (const io::TopicInfo& topic : info.topics) {
    topics.push_back({{"name", topic.name},
                      {"type", topic.type},
                      {"encoding", topic.encoding},
                      {"messages", topic.messages},
                      {"rate_hz", rate_hz(info, topic)},
                      {"decoded", topic.decoded},
                      {"is_scan", topic.is_scan}});
  }
  Json diagnostics = Json::array();
  for (const auto& [what, entry] : summary.diagnostics.entries()) {
    diagnostics.push_back(
        {{"what", what}, {"count", entry.count}, {"first", entry.first}, {"damage", entry.damage}});
  }
  return {{"path", info.path.string()},
          {"format", info.format},
          {"compression", info.compression},
          {"start_s", seconds_or_null(info.start)},
          {"end_s", seconds_or_null(info.end)},
          {"duration_s", duration_s(info)},
          {"topics", topics},
          {"diagnostics", diagnostics}};
}

void print_json(const RecordingSummary& summary) {
  fmt::print("{}\n", as_json(summary).dump(-1, ' ', false, Json::error_handler_t::replace));
}

void print_table(const RecordingSummary& summary) {
  const auto& info = summary.info;
  fmt::print("recording  {}\nformat     {}{}\n", info.path.string(), info.format,
             info.compression.empty() || info.compression == "none"
                 ? ""
                 : fmt::format(" ({})", info.compression));
  if (info.start && info.end) {
    fmt::print("start      {} s\nend        {} s\nduration   {:.3f} s\n",
               io::print_seconds(*info.start), io::print_seconds(*info.end), duration_s(info));
  }
  std::size_t name_width = 5, type_width = 4;
  for (const auto& topic : info.topics) {
    name_width = std::max(name_width, topic.name.size());
    type_width = std::max(type_width, topic.type.size());
  }
  fmt::print("\n{:<{}}  {:<{}}  {:>9}  {:>9}\n", "topic", name_width, "type", type_width,
             "messages", "per s");
  for (const auto& topic : info.topics) {
    const double rate = rate_hz(info, topic);
    fmt::print("{:<{}}  {:<{}}  {:>9}  {:>9}{}\n", topic.name, name_width, topic.type, type_width,
               topic.messages, rate > 0 ? fmt::format("{:.2f}", rate) : "-",
               topic.is_scan   ? "  scan"
               : topic.decoded ? ""
                               : "  (not decoded)");
  }
}

int run_info(const InfoOptions& options, bool quiet) {
  catch_interrupts();
  const auto summary = summarise(options, quiet);
  if (!summary) return report_error(summary.error());
  options.json ? print_json(*summary) : print_table(*summary);
  const int code = report_diagnostics(summary->diagnostics, quiet);
  return summary->stopped ? static_cast<int>(kInterrupted) : code;
}

}  // namespace

void add_info(Tool& tool) {
  auto options = std::make_shared<InfoOptions>();
  CLI::App* command = tool.app->add_subcommand("info", "List what a recording holds");
  command->add_option("RECORDING", options->input, "A recording: a file or a folder")->required();
  command->add_option(
      "--sensor", options->sensor,
      "Device that speaks in a capture (.pcap), if its ports do not tell: sick, ...");
  command->add_flag("--json", options->json, "One JSON object on stdout");
  command->add_flag("--check", options->check, "Read all of it, also where it has an index");
  command->footer("Example: scanfuse info drive.bag --json");
  command->callback([tool, options] { *tool.exit_code = run_info(*options, tool.common->quiet); });
}

}  // namespace scanfuse::app
