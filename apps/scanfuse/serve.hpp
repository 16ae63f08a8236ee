#pragma once

#include <optional>
#include <string>
#include <vector>

#include "command.hpp"
#include "scanfuse/simulate/simulate.hpp"

namespace scanfuse::app {

/// Simulated devices to serve: "sick:2112", "vlp16:127.0.0.1:2368", ...
struct ServeRequest {
  std::string scenario;
  std::vector<std::string> addresses;
  std::optional<std::string> sensor;  ///< how it measures; empty: as the device does
  simulate::SimulateOptions options;
};

/// Plays the scenario in real time, over and over, until Ctrl-C (or `options.frames` scans of each
/// device have been sent). All devices see the same world.
[[nodiscard]] Result<void> serve_scenario(const ServeRequest& request, const CommonOptions& common);

/// How a device of this scheme measures, by name of the preset.
[[nodiscard]] std::string preset_of_device(std::string_view scheme);

}  // namespace scanfuse::app
