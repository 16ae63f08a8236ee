#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "scanfuse/core/diagnostics.hpp"
#include "scanfuse/io/result_writer.hpp"

namespace scanfuse::io {

struct McapResultOptions {
  std::string frame = "world";  ///< the output frame of the tracks: "world" or "ego"
};

/// Results as MCAP for people (Foxglove, our viewer) and scripts; docs/mcap.md lists the topics.
[[nodiscard]] Result<std::unique_ptr<ResultWriter>> open_mcap_result_writer(
    const std::filesystem::path& path, const McapResultOptions& options = {});

/// Reads back the steps that such a file holds, in order of time: tracks, detections, poses. Damage
/// is counted in `diagnostics`. A file without /scanfuse/tracks is an error.
[[nodiscard]] Result<std::vector<StepResult>> read_tracks_mcap(const std::filesystem::path& path,
                                                               Diagnostics* diagnostics = nullptr);

}  // namespace scanfuse::io
