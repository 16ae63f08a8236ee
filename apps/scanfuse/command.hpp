#pragma once

#include <CLI/CLI.hpp>
#include <atomic>
#include <string>
#include <string_view>
#include <vector>

#include "scanfuse/core/diagnostics.hpp"
#include "scanfuse/core/options.hpp"
#include "scanfuse/core/result.hpp"

namespace scanfuse::app {

/// Exit codes scripts rely on.
enum ExitCode {
  kDone = 0,
  kInternalFault = 1,
  kBadInput = 2,
  kDamagedInput = 3,
  kInterrupted = 130
};

/// What every command takes: --quiet, --seed, --threads, --json where a script would read it.
struct CommonOptions {
  bool quiet = false;
  std::uint64_t seed = 1;
  int threads = 0;
};

/// Each command adds itself to the tool: options, help with an example, and what runs. The callback
/// stores its exit code in `exit_code`. One file a command.
struct Tool {
  CLI::App* app = nullptr;
  CommonOptions* common = nullptr;
  int* exit_code = nullptr;
};
void add_info(Tool& tool);
void add_convert(Tool& tool);
void add_track(Tool& tool);
void add_simulate(Tool& tool);
void add_simulate_passive(CLI::App& simulate, const Tool& tool);
void add_simulate_turntable(CLI::App& simulate, const Tool& tool);
void add_associate(Tool& tool);
void add_evaluate(Tool& tool);
void add_bench(Tool& tool);
void add_config(Tool& tool);
void add_learn(Tool& tool);
void add_calibrate(Tool& tool);
void add_calibrate_camera(CLI::App& calibrate, const Tool& tool);
void add_assemble(Tool& tool);
void add_measure(Tool& tool);
void add_view(Tool& tool);
void add_live(Tool& tool);
void add_record(Tool& tool);

/// Prints "scanfuse: error: ..." on stderr and returns kBadInput.
int report_error(const Error& error);
/// Prints what was odd, one line each, on stderr; kDamagedInput when input was lost, else kDone.
int report_diagnostics(const Diagnostics& diagnostics, bool quiet);

/// Applies `--set section.name=value` or `--set name=value` to a command of one section.
template <class Options>
[[nodiscard]] Result<void> apply_settings(Options& options, std::string_view section,
                                          const std::vector<std::string>& sets) {
  const std::string prefix = std::string(section) + ".";
  for (std::string_view set : sets) {
    if (set.starts_with(prefix)) set.remove_prefix(prefix.size());
    const auto equals = set.find('=');
    if (equals == set.npos) {
      return fail(Error::Code::kMalformed, "--set {}: write {}.name=value", set, section);
    }
    auto done = set_option(options, set.substr(0, equals), set.substr(equals + 1));
    if (!done) return done;
  }
  return {};
}

/// Settings for a command's help, a line each.
[[nodiscard]] std::string settings_help(const std::vector<OptionView>& views);

/// An error when writing `output` would replace `input`.
[[nodiscard]] Result<void> refuse_to_replace(const std::string& input, const std::string& output);

/// Set by Ctrl-C; loops look at it between scans, finish what they wrote and return kInterrupted.
extern std::atomic<bool> interrupted;
/// For commands with such a loop: the first Ctrl-C (or SIGTERM) sets `interrupted`, the second ends
/// the tool. Other commands end at the first, as is usual.
void catch_interrupts();

/// A line on stderr that is redrawn while work goes on; silent when stderr is no terminal or
/// --quiet.
class Progress {
 public:
  Progress(std::string label, bool quiet);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;
  /// `total` 0: not known.
  void update(std::int64_t done, std::int64_t total = 0);

 private:
  std::string label_;
  bool shown_ = false;
  bool drawn_ = false;
  std::int64_t last_drawn_ms_ = 0;
};

}  // namespace scanfuse::app
