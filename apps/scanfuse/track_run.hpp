#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "command.hpp"
#include "scanfuse/evaluate/evaluate.hpp"
#include "scanfuse/evaluate/per_class.hpp"
#include "scanfuse/pipeline/config.hpp"
#include "scoring.hpp"

namespace scanfuse::app {

/// What `track` was asked to do.
struct TrackRequest {
  std::string input;
  std::vector<std::string> outputs;  ///< .mcap, .csv, .jsonl
  std::string detections;            ///< CSV to write, or empty
  std::string report;                ///< HTML to write, or empty
  std::string preset = "vehicle-pag";
  std::string config;
  std::vector<std::string> set;
  std::string frame;
  std::vector<std::string> topics;
  std::string sensor;  ///< device that speaks in a capture; empty: its ports tell
  bool standing = false;
  std::string ego_topic;
  std::string ego_file;
  std::vector<double> mount;  ///< x, y, yaw
  std::string sensors;        ///< TOML: the input is bearings of these passive sensors
  std::string calibration;    ///< of KITTI detections, or empty
  double frame_rate_hz = 10;  ///< of KITTI detections
  TruthRequest truth;         ///< none asked for: what the recording carries
  ScoringRequest scoring;
  bool paper_axes = false;
  bool json = false;
};

/// What came of it.
struct TrackOutcome {
  std::int64_t scans = 0;
  std::int64_t returns = 0;
  std::int64_t detections = 0;
  std::int64_t tracks = 0;  ///< that were ever confirmed
  double median_scan_s = 0;
  double p99_scan_s = 0;
  std::optional<Time> first;
  std::optional<Time> last;
  std::optional<evaluate::Evaluation> score;  ///< when there is truth
  std::map<ObjectClass, evaluate::ClassEvaluation> by_class;
  Diagnostics diagnostics;
  bool stopped = false;  ///< by Ctrl-C
};

/// The options of the preset, then the file, then --set and --frame.
[[nodiscard]] Result<pipeline::PerceptionOptions> resolve_options(const TrackRequest& request);

/// The scans of the recording with the poses asked for: of all sensors, whatever topics are named.
[[nodiscard]] Result<pipeline::ScanFeed> open_feed(const TrackRequest& request);

[[nodiscard]] Result<TrackOutcome> run_track(const TrackRequest& request,
                                             const CommonOptions& common);

/// The tracks of every scan, in memory; nothing is written.
[[nodiscard]] Result<std::vector<StepResult>> track_steps(const TrackRequest& request);

/// The same tracker on detections by any detector, from a table or KITTI boxes. With --ego they
/// stand in the frame of the sensor, else in one that does not move.
[[nodiscard]] Result<TrackOutcome> run_track_on_detections(const TrackRequest& request,
                                                           const CommonOptions& common);

}  // namespace scanfuse::app
