#pragma once

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "command.hpp"
#include "live_request.hpp"
#include "scanfuse/serve/viewer.hpp"
#include "scanfuse/triangulate/associate_scan.hpp"
#include "scanfuse/types/turntable.hpp"
#include "track_run.hpp"

namespace scanfuse::app {

/// A calibrated turntable and what its lidar saw.
struct RigScene {
  std::string session;
  std::vector<TurntablePosition> positions;
  Rig rig;
  Camera camera;                                    ///< focal lengths 0: not known
  std::vector<std::pair<BoardSpec, Pose3>> boards;  ///< with camera_from_board
};

/// What `view` was asked to do.
struct ViewRequest {
  TrackRequest track;             ///< input, options, truth
  LiveRequest live;               ///< in place of an input
  std::string rig;                ///< file; then the input is a session of scans
  std::optional<RigScene> scene;  ///< the same, calibrated just now
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

/// The scans of a session and the rig that they were taken with, to be looked at.
[[nodiscard]] Result<RigScene> read_rig_scene(const std::string& session,
                                              const std::string& rig_path);

/// A frame for each position: the cloud as far as it has been scanned, and the rig.
[[nodiscard]] Result<std::unique_ptr<serve::Workbench>> open_rig_bench(const RigScene& scene);

/// Serves until Ctrl-C; prints the address on stdout.
[[nodiscard]] int run_view(ViewRequest request, const CommonOptions& common);

/// Starts to read, to track and to serve.
[[nodiscard]] Result<OpenView> open_view(const ViewRequest& request, const CommonOptions& common);

}  // namespace scanfuse::app
