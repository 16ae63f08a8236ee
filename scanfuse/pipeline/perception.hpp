#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <tuple>
#include <vector>

#include "scanfuse/classify/recognizer.hpp"
#include "scanfuse/core/options.hpp"
#include "scanfuse/pipeline/scaled.hpp"
#include "scanfuse/pipeline/scan_feed.hpp"
#include "scanfuse/preprocess/deskew.hpp"
#include "scanfuse/preprocess/spatio_temporal.hpp"
#include "scanfuse/preprocess/virtual_scan_builder.hpp"
#include "scanfuse/segment/segmenter.hpp"
#include "scanfuse/shape/outline.hpp"
#include "scanfuse/track/tracker.hpp"
#include "scanfuse/types/track.hpp"

namespace scanfuse::pipeline {

/// In which frame results are given.
enum class OutputFrame { kWorld, kEgo };

constexpr auto choices(OutputFrame) {
  return std::array{std::pair{"world", OutputFrame::kWorld}, std::pair{"ego", OutputFrame::kEgo}};
}

struct PipelineOptions {
  OutputFrame frame = OutputFrame::kWorld;
  bool deskew = true;
  double scale = 1;

  static constexpr auto fields() {
    using O = PipelineOptions;
    return std::tuple{
        Field{"frame", &O::frame, "frame of the results: world (odometry) or ego at the scan"},
        Field{"deskew", &O::deskew, "correct each beam for the ego motion since the scan's stamp"},
        Field{"scale", &O::scale, 0.001, 100.0,
              "size of the scene against a real road: 0.1 for models of 1:10; options of all other "
              "sections then stand in metres of the real road, results in those of the scene"},
    };
  }
};

/// Everything the chain can be told; the configuration file has one section for each part.
struct PerceptionOptions {
  PipelineOptions pipeline;
  preprocess::PreprocessOptions preprocess;
  segment::SegmentOptions segment;
  shape::ShapeOptions shape;
  classify::RecognizerOptions classify;
  track::TrackerOptions track;
};

/// The arrows of the chain, for those who measure them.
enum class Stage { kPreprocess, kDeskew, kSegment, kShape, kClassify, kTrack };

constexpr auto choices(Stage) {
  using enum Stage;
  return std::array{std::pair{"preprocess", kPreprocess}, std::pair{"de-skew", kDeskew},
                    std::pair{"segment", kSegment},       std::pair{"shape", kShape},
                    std::pair{"classify", kClassify},     std::pair{"track", kTrack}};
}

/// The whole chain: one scan in, detections and tracks out. Every arrow of docs/architecture.md is
/// one line of `step`. Keeps its buffers: once they have grown, a step allocates nothing
/// (tests/allocation). One object per stream and thread. A sensor in a frame whose place on the ego
/// is not known is tracked for itself: what others see cannot be brought into it.
class Perception {
 public:
  explicit Perception(const PerceptionOptions& options = {});

  /// Valid until the next call. Scans of several sensors may be mixed, in order of time. Every
  /// number given is finite: a scan at an unusable pose (not finite, or past 1e7 m) counts as
  /// empty, and is noted in `diagnostics`.
  const StepResult& step(const PosedScan& posed) {
    return step(posed, [](Stage) {});
  }
  /// The same, calling `after(stage)` when a stage is done.
  template <class After>
  const StepResult& step(const PosedScan& posed, After&& after);

  /// What the last step saw on its way, in the levelled sensor frame: for reports.
  [[nodiscard]] const VirtualScan& virtual_scan() const { return virtual_scan_; }
  [[nodiscard]] const Clusters& clusters() const { return *clusters_; }
  /// One a cluster. Valid until the next step.
  [[nodiscard]] std::span<const Outline> outlines() const { return outlines_; }
  /// Of which outline each detection is.
  [[nodiscard]] std::span<const std::uint32_t> sources() const { return recognize_.sources(); }
  [[nodiscard]] Diagnostics diagnostics() const;

 private:
  template <class After>
  void run(const PosedScan& posed, After& after);
  /// Results and virtual scan back to the size of the scene.
  void give_in_scene(const PosedScan& posed);
  [[nodiscard]] static bool is_placed(const PosedScan& posed);
  PosedScan left_empty(const PosedScan& posed);
  void straighten(const PosedScan& posed);
  /// Asks the tracker where vehicles will be, in the levelled sensor frame.
  void expect(const PosedScan& posed);
  track::Tracker& tracker_of(const PosedScan& posed);
  int number_of(const std::string& sensor);
  void give_in_world(const PosedScan& posed, std::span<const Detection> detections);
  void give_in_ego();

  PerceptionOptions options_;
  Diagnostics diagnostics_;
  preprocess::SpatioTemporalFilter filter_;
  preprocess::VirtualScanBuilder flatten_;
  segment::Segmenter segment_;
  shape::OutlineExtractor outline_;
  classify::Recognizer recognize_;
  std::map<std::string, track::Tracker, std::less<>> trackers_;  ///< by frame; "": the ego's
  std::vector<std::string> sensors_;
  std::shared_ptr<std::int64_t> track_ids_ = std::make_shared<std::int64_t>(0);
  StepResult result_;
  VirtualScan virtual_scan_;
  std::vector<Expected> expected_;
  const Clusters* clusters_ = nullptr;
  std::span<const Outline> outlines_;
};

template <class After>
const StepResult& Perception::step(const PosedScan& posed, After&& after) {
  if (!is_placed(posed)) return step(left_empty(posed), after);
  if (options_.pipeline.scale == 1) {
    run(posed, after);
  } else {
    run(scaled(posed, 1 / options_.pipeline.scale), after);
    give_in_scene(posed);
  }
  return result_;
}

template <class After>
void Perception::run(const PosedScan& posed, After& after) {
  const Scan& clean = filter_(posed.scan, posed.world_from_ego * posed.ego_from_sensor);
  virtual_scan_ = flatten_(clean, posed.ego_from_sensor);
  after(Stage::kPreprocess);
  if (options_.pipeline.deskew) straighten(posed);
  after(Stage::kDeskew);
  clusters_ = &segment_(virtual_scan_);
  after(Stage::kSegment);
  expect(posed);
  outlines_ = outline_(virtual_scan_, *clusters_, expected_);
  clusters_ = &outline_.clusters();
  after(Stage::kShape);
  const auto detections = recognize_(outlines_);
  after(Stage::kClassify);
  give_in_world(posed, detections);
  result_.tracks =
      tracker_of(posed).step(posed.scan.stamp, result_.detections, number_of(posed.scan.sensor));
  if (options_.pipeline.frame == OutputFrame::kEgo) give_in_ego();
  after(Stage::kTrack);
}

/// The detection seen from another frame: `target_from_source` is planar.
[[nodiscard]] Detection moved(const Detection& detection, const Pose2& target_from_source);

/// The track in another frame that stands still over ground for the moment: positions, headings and
/// velocities are turned, velocities stay over ground.
[[nodiscard]] Track moved(const Track& track, const Pose2& target_from_source);

}  // namespace scanfuse::pipeline
