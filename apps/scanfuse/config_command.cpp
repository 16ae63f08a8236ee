#include <cstdio>

#include "command.hpp"
#include "scanfuse/io/toml.hpp"
#include "track_run.hpp"

namespace scanfuse::app {

void add_config(Tool& tool) {
  auto request = std::make_shared<TrackRequest>();
  auto* app = tool.app->add_subcommand("config", "Show the options, resolved, as TOML");
  app->add_flag("--show")->description("Print them (the default)");
  app->add_option("--preset", request->preset, "Options to start from")->capture_default_str();
  app->add_option("--config", request->config, "Options from a TOML file");
  app->add_option("--set", request->set, "Change an option: section.option=value")
      ->allow_extra_args(false);
  app->footer("Example:\n  scanfuse config --show --preset vehicle-pag-literal > literal.toml");
  app->callback([&tool, request] {
    const auto options = resolve_options(*request);
    if (!options) {
      *tool.exit_code = report_error(options.error());
      return;
    }
    fmt::print("{}", io::write_toml(pipeline::view_config(*options)));
  });
}

}  // namespace scanfuse::app
