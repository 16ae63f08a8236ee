#pragma once

#include <string>

#include "track_run.hpp"

namespace scanfuse::app {

/// `track` on bearings of passive sensors: tracks to the outputs, a summary or JSON to stdout.
[[nodiscard]] int run_track_passive(const TrackRequest& request, const CommonOptions& common);

/// The settings it takes, for the command's help.
[[nodiscard]] std::string passive_track_help();

}  // namespace scanfuse::app
