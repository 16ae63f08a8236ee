#include <csignal>
#include <cstdio>
#include <exception>

#include "command.hpp"

namespace {

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
  add_evaluate(tool);
  add_bench(tool);
  add_config(tool);
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& success) {
    return app.exit(success);
  } catch (const CLI::ParseError& error) {
    app.exit(error);
    return kBadInput;
  }
  return exit_code;
}

}  // namespace

int main(int argc, char** argv) {
  std::signal(SIGINT, [](int) { scanfuse::app::interrupted = true; });
  std::signal(SIGTERM, [](int) { scanfuse::app::interrupted = true; });
  std::signal(SIGPIPE, SIG_IGN);
  try {
    return run(argc, argv);
  } catch (const std::exception& fault) {
    std::fprintf(stderr, "scanfuse: internal fault: %s\n", fault.what());
    return scanfuse::app::kInternalFault;
  }
}
