#include <algorithm>
#include <map>
#include <memory>

#include "command.hpp"
#include "json_text.hpp"
#include "scanfuse/io/recording.hpp"
#include "scanfuse/io/text/numbers.hpp"

namespace scanfuse::app {
namespace {

struct InfoOptions {
  std::string input;
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
  auto reader = io::open_recording(options.input);
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

void print_json(const RecordingSummary& summary) {
  const auto& info = summary.info;
  fmt::print(
      "{{\"path\":{},\"format\":{},\"compression\":{},\"start_s\":{},\"end_s\":{},"
      "\"duration_s\":{},\"topics\":[",
      json_text(info.path.string()), json_text(info.format), json_text(info.compression),
      info.start ? io::print_seconds(*info.start) : "null",
      info.end ? io::print_seconds(*info.end) : "null", json_number(duration_s(info)));
  for (std::size_t k = 0; k < info.topics.size(); ++k) {
    const auto& topic = info.topics[k];
    fmt::print(
        "{}{{\"name\":{},\"type\":{},\"encoding\":{},\"messages\":{},\"rate_hz\":{},"
        "\"decoded\":{},\"is_scan\":{}}}",
        k == 0 ? "" : ",", json_text(topic.name), json_text(topic.type), json_text(topic.encoding),
        topic.messages, json_number(rate_hz(info, topic)), topic.decoded, topic.is_scan);
  }
  fmt::print("],\"diagnostics\":[");
  bool first = true;
  for (const auto& [what, entry] : summary.diagnostics.entries()) {
    fmt::print("{}{{\"what\":{},\"count\":{},\"first\":{},\"damage\":{}}}", first ? "" : ",",
               json_text(what), entry.count, json_text(entry.first), entry.damage);
    first = false;
  }
  fmt::print("]}}\n");
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
  command->add_flag("--json", options->json, "One JSON object on stdout");
  command->add_flag("--check", options->check, "Read all of it, also where it has an index");
  command->footer("Example: scanfuse info drive.bag --json");
  command->callback([tool, options] { *tool.exit_code = run_info(*options, tool.common->quiet); });
}

}  // namespace scanfuse::app
