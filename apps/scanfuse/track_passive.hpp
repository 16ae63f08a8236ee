#pragma once

#include <string>

#include "scanfuse/triangulate/passive_tracker.hpp"
#include "track_run.hpp"

namespace scanfuse::app {

/// `track` on bearings of passive sensors: tracks to the outputs, a summary or JSON to stdout.
[[nodiscard]] int run_track_passive(const TrackRequest& request, const CommonOptions& common);

/// What a scan of bearings gave, as every result is written.
[[nodiscard]] StepResult as_step(const BearingScan& scan, const triangulate::PassiveStep& found);

/// The settings it takes, for the command's help.
[[nodiscard]] std::string passive_track_help();

}  // namespace scanfuse::app
