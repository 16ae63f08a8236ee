#include "command.hpp"

#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdio>
#include <filesystem>

namespace scanfuse::app {

std::string settings_help(const std::vector<OptionView>& views) {
  std::string text;
  for (const auto& view : views) {
    text += fmt::format("  {:<28} {} [{}; {}]\n", view.section + "." + view.name, view.doc,
                        view.fallback, view.range);
  }
  return text;
}

Result<void> refuse_to_replace(const std::string& input, const std::string& output) {
  std::error_code missing;
  if (!std::filesystem::equivalent(input, output, missing)) return {};
  return fail(Error::Code::kUnsupported, "{}: is the input; write to another file", output);
}

std::atomic<bool> interrupted{false};

extern "C" {
static void ask_to_stop(int signal) {
  interrupted = true;
  std::signal(signal, SIG_DFL);
}
}

void catch_interrupts() {
  std::signal(SIGINT, ask_to_stop);
  std::signal(SIGTERM, ask_to_stop);
}

int report_error(const Error& error) {
  fmt::print(stderr, "scanfuse: error: {}\n", error.message);
  return kBadInput;
}

int report_diagnostics(const Diagnostics& diagnostics, bool quiet) {
  for (const auto& [what, entry] : diagnostics.entries()) {
    if (quiet && !entry.damage) continue;
    fmt::print(stderr, "scanfuse: {}: {} ({}x{}{})\n", entry.damage ? "damage" : "note", what,
               entry.count, entry.first.empty() ? "" : ", first at ", entry.first);
  }
  return diagnostics.any_damage() ? kDamagedInput : kDone;
}

namespace {

std::int64_t now_ms() {
  using namespace std::chrono;
  return duration_cast<milliseconds>(steady_clock::now().time_since_epoch()).count();
}

}  // namespace

Progress::Progress(std::string label, bool quiet)
    : label_(std::move(label)), shown_(!quiet && isatty(STDERR_FILENO) != 0) {}

Progress::~Progress() {
  if (drawn_) fmt::print(stderr, "\r\033[K");
}

void Progress::update(std::int64_t done, std::int64_t total) {
  if (!shown_) return;
  const auto now = now_ms();
  if (now - last_drawn_ms_ < 100) return;
  last_drawn_ms_ = now;
  drawn_ = true;
  if (total > 0) {
    const auto filled = static_cast<std::size_t>(30 * done / total);
    fmt::print(stderr, "\r{} [{:<30}] {}/{}", label_, std::string(filled, '='), done, total);
  } else {
    fmt::print(stderr, "\r{} {}", label_, done);
  }
  std::fflush(stderr);
}

}  // namespace scanfuse::app
