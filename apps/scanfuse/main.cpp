#include <algorithm>
#include <csignal>
#include <cstdio>
#include <exception>

#include "command.hpp"
#include "scanfuse/core/options.hpp"

namespace {

/// What was typed but is not known, with the nearest name that is.
void report_unknown(const CLI::App& app, const std::string& word) {
  const CLI::App* command = nullptr;
  std::vector<std::string> commands, options;
  for (const CLI::App* sub : app.get_subcommands({})) {
    commands.push_back(sub->get_name());
    if (sub->parsed()) command = sub;
  }
  for (const CLI::App* of : {&app, command}) {
    if (of == nullptr) continue;
    for (const CLI::Option* option : of->get_options()) {
      for (const auto& name : option->get_lnames()) options.push_back("--" + name);
    }
  }
  const bool is_option = word.starts_with("-");
  const auto& known = is_option || command != nullptr ? options : commands;
  const std::string help = command != nullptr ? command->get_name() + " --help" : "--help";
  if (is_option || command == nullptr) {
    fmt::print(stderr, "scanfuse: error: unknown {} '{}'; did you mean '{}'? See scanfuse {}\n",
               is_option ? "option" : "command", word,
               scanfuse::nearest_name(word.substr(0, word.find('=')), known), help);
  } else {
    fmt::print(stderr, "scanfuse: error: '{}' is one argument too many; see scanfuse {}\n", word,
               help);
  }
}

/// CLI11 says what is missing or wrong; what is unknown we say ourselves.
int report_usage(const CLI::App& app, const CLI::ParseError& error) {
  const auto unknown = app.remaining(true);
  if (!unknown.empty()) {
    const auto option = std::ranges::find_if(unknown, [](auto& w) { return w.starts_with("-"); });
    report_unknown(app, option != unknown.end() ? *option : unknown.front());
  } else {
    const auto parsed = app.get_subcommands();
    fmt::print(stderr, "scanfuse: error: {}; see scanfuse {}--help\n", error.what(),
               parsed.empty() ? "" : parsed.front()->get_name() + " ");
  }
  return scanfuse::app::kBadInput;
}

int run(int argc, char** argv) {
  using namespace scanfuse::app;
  CLI::App app{"scanfuse turns raw scans and bearings into calibrated, fused tracks."};
  app.name("scanfuse");
  app.set_version_flag("--version", std::string("scanfuse ") + SCANFUSE_VERSION);
  app.require_subcommand(1);
  app.fallthrough();

  CommonOptions common;
  app.add_flag("--quiet", common.quiet, "No progress and no notes on stderr");
  app.add_option("--seed", common.seed, "Seed of everything random")->capture_default_str();
  app.add_option("--threads", common.threads, "Threads to use; 0: one per core")
      ->check(CLI::Range(0, 1024))
      ->capture_default_str();

  int exit_code = kDone;
  Tool tool{&app, &common, &exit_code};
  add_info(tool);
  add_convert(tool);
  add_track(tool);
  add_simulate(tool);
  add_associate(tool);
  add_evaluate(tool);
  add_bench(tool);
  add_config(tool);
  add_learn(tool);
  add_calibrate(tool);
  add_assemble(tool);
  add_measure(tool);
  add_view(tool);
  add_live(tool);
  add_record(tool);
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& success) {
    return app.exit(success);
  } catch (const CLI::ParseError& error) {
    return report_usage(app, error);
  }
  return exit_code;
}

}  // namespace

int main(int argc, char** argv) {
  std::signal(SIGPIPE, SIG_IGN);
  try {
    return run(argc, argv);
  } catch (const std::exception& fault) {
    std::fprintf(stderr, "scanfuse: internal fault: %s\n", fault.what());
    return scanfuse::app::kInternalFault;
  }
}
