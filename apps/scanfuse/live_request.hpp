#pragma once

#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "command.hpp"
#include "scanfuse/pipeline/live_reader.hpp"

namespace scanfuse::app {

/// The live sensors that a command was told of.
struct LiveRequest {
  std::vector<std::string> sensors;  ///< URLs
  std::vector<std::string> mounts;   ///< "X_M,Y_M,YAW_RAD", one a sensor in their order
  double seconds = 0;                ///< stops after so long; 0: at Ctrl-C
  int waiting = 2;                   ///< scans of one sensor that may wait
};

void add_live_options(CLI::App& app, LiveRequest& request);

/// Starts reading all sensors.
[[nodiscard]] Result<std::unique_ptr<pipeline::LiveReader>> open_live(const LiveRequest& request);

/// How each sensor did, as `--json` tells it.
[[nodiscard]] nlohmann::json sensors_json(const pipeline::LiveReader& reader);
/// The same for people, on stderr.
void print_sensors(const pipeline::LiveReader& reader);

/// Known devices and the forms of their URLs, for a command's help.
[[nodiscard]] std::string sensors_help();

}  // namespace scanfuse::app
