#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "scanfuse/geometry/pose.hpp"
#include "scanfuse/report/svg_plot.hpp"
#include "scanfuse/report/table.hpp"
#include "scanfuse/types/clusters.hpp"
#include "scanfuse/types/scan.hpp"
#include "scanfuse/types/track.hpp"
#include "scanfuse/types/truth.hpp"
#include "scanfuse/types/virtual_scan.hpp"

namespace scanfuse::report {

/// What the page says besides the data. Rows are (name, value); all texts are escaped.
struct TrackReportHeader {
  std::string input;          ///< name of the recording
  std::string configuration;  ///< preset and digest, or all of it; shown as it is
  std::vector<std::pair<std::string, std::string>> summary;      ///< timing, counts
  std::vector<std::pair<std::string, std::string>> metrics;      ///< against truth; may be empty
  std::vector<std::pair<std::string, std::string>> diagnostics;  ///< what was odd; may be empty
  std::vector<ReportTable> tables;                               ///< against truth, in more detail
  std::vector<Chart> charts;                                     ///< beside them
};

struct TrackReportOptions {
  std::size_t max_bytes = 8'000'000;        ///< of data in the page; frames are thinned above it
  std::size_t max_points_per_frame = 2000;  ///< returns are thinned above it
};

/// A track at one frame, in the world frame.
struct ReportedTrack {
  std::int64_t id = 0;
  ObjectClass object_class = ObjectClass::kUnknown;
  TrackStatus status = TrackStatus::kTentative;
  Box2 box;
  Eigen::Vector2d velocity_m_per_s = Eigen::Vector2d::Zero();
  Eigen::Matrix2d covariance_m2 = Eigen::Matrix2d::Zero();  ///< of the position
  bool measured = false;
  Eigen::Vector2d measured_m = Eigen::Vector2d::Zero();  ///< centre of the detection folded in
  bool left_end_hidden = false;                          ///< of that detection
  bool right_end_hidden = false;
};

/// A frame as the page shows it.
struct ReportedFrame {
  std::int64_t frame = 0;
  Time stamp;
  Pose2 world_from_ego;
  Eigen::Vector2d sensor_m = Eigen::Vector2d::Zero();  ///< in the world frame
  std::vector<std::int16_t> points_cm;                 ///< x, y of each return in the ego frame
  std::vector<std::uint8_t> point_group;               ///< 0: noise, else 1 + cluster mod 255
  std::vector<ReportedTrack> tracks;
};

/// Sums over all frames of one track, also of those that the page leaves out.
struct TrackLife {
  ObjectClass object_class = ObjectClass::kUnknown;
  bool confirmed = false;
  std::int64_t first_frame = 0;
  std::int64_t last_frame = 0;
  std::int64_t frames = 0;
  std::int64_t measured = 0;
  Eigen::Array2d square_difference_m2 =
      Eigen::Array2d::Zero();  ///< estimate - measured: lateral, forward
};

/// Collects a run of the tracker and writes it as one HTML page that needs no other file and no
/// network: a top view that plays, the curves of [Lu2018, figs. 8-10, 12, 14], a table beside
/// [Lu2018, table 2], a timeline, the summary. Colours tell the class and are told apart by
/// colour-blind people [Okabe2008]. Memory stays within a small multiple of `max_bytes`:
/// once it is reached every second frame is dropped, again and again, and the page says so.
class TrackReport {
 public:
  explicit TrackReport(TrackReportOptions options = {}) : options_(options) {}

  /// `flat` (levelled sensor frame) and its `clusters` colour the returns; without them the
  /// returns of `scan` are shown in one colour.
  void add(const StepResult& step, const Scan& scan, const VirtualScan* flat = nullptr,
           const Clusters* clusters = nullptr);
  /// Before or after its step; belongs to the step of its frame number.
  void add(const TruthFrame& truth);

  [[nodiscard]] std::string html(const TrackReportHeader& header) const;

  [[nodiscard]] const std::vector<ReportedFrame>& frames() const { return frames_; }
  [[nodiscard]] const std::map<std::int64_t, TrackLife>& lives() const { return lives_; }
  [[nodiscard]] const std::map<std::int64_t, TruthFrame>& truth() const { return truth_; }
  [[nodiscard]] std::int64_t frames_seen() const { return frames_seen_; }
  [[nodiscard]] std::int64_t frame_stride() const { return stride_; }
  [[nodiscard]] bool points_thinned() const { return points_thinned_; }

 private:
  void add_points(ReportedFrame& frame, const StepResult& step, const Scan& scan,
                  const VirtualScan* flat, const Clusters* clusters);
  void account(const ReportedFrame& frame);
  void thin();

  TrackReportOptions options_;
  std::vector<ReportedFrame> frames_;
  std::map<std::int64_t, TrackLife> lives_;
  std::map<std::int64_t, TruthFrame> truth_;  ///< by frame number
  std::int64_t frames_seen_ = 0;
  std::int64_t stride_ = 1;
  std::size_t bytes_ = 0;
  bool points_thinned_ = false;
};

}  // namespace scanfuse::report
