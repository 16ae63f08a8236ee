#pragma once

#include <memory>
#include <optional>
#include <string>

#include "command.hpp"
#include "live_request.hpp"
#include "scanfuse/serve/viewer.hpp"
#include "scanfuse/triangulate/associate_scan.hpp"
#include "track_run.hpp"

namespace scanfuse::app {

/// What `view` was asked to do.
struct ViewRequest {
  TrackRequest track;                                          ///< input, options, truth
  LiveRequest live;                                            ///< in place of an input
  std::optional<triangulate::AssociationOptions> association;  ///< of scans of bearings by itself
  bool has_preset = false;
  bool again = false;        ///< track, though tracks are stored
  std::string labels;        ///< file, or empty
  bool stay_closed = false;  ///< no browser is opened
  bool json = false;
  serve::ServerOptions server;
};

/// Everything that serves a page, in the order in which it is taken down.
struct OpenView {
  std::unique_ptr<serve::Workbench> bench;
  std::unique_ptr<serve::Labels> labels;
  serve::Viewer viewer;
};

/// Bearings of passive sensors, tracked as `track --sensors` does, or associated scan by scan.
[[nodiscard]] Result<std::unique_ptr<serve::Workbench>> open_passive_bench(
    const ViewRequest& request, int threads);

/// Sensors that are running, tracked as `live` does.
[[nodiscard]] Result<std::unique_ptr<serve::Workbench>> open_live_bench(const TrackRequest& request,
                                                                        const LiveRequest& live);

/// Serves until Ctrl-C; prints the address on stdout.
[[nodiscard]] int run_view(ViewRequest request, const CommonOptions& common);

/// Starts to read, to track and to serve.
[[nodiscard]] Result<OpenView> open_view(const ViewRequest& request, const CommonOptions& common);

}  // namespace scanfuse::app
