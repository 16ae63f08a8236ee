#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "scanfuse/core/diagnostics.hpp"
#include "scanfuse/track/hidden.hpp"
#include "scanfuse/track/lost.hpp"
#include "scanfuse/track/options.hpp"
#include "scanfuse/track/steps.hpp"
#include "scanfuse/track/target.hpp"
#include "scanfuse/types/detection.hpp"
#include "scanfuse/types/expected.hpp"

namespace scanfuse::track {

/// Detections in, tracks out, one scan after the other.
///
/// Detections stand in a frame that does not move (odometry, world); so do the tracks. What is odd
/// in the input is counted in `diagnostics`, never fatal:
/// - an equal stamp (another sensor): nothing moves, and targets it does not see count no miss;
/// - a stamp before the last one, by up to `max_gap_s`: the scan is left out;
/// - a larger step back, or a pause of more than `max_gap_s`: all tracks are dropped;
/// - a detection with a number that is not finite, or absurdly large: left out.
class Tracker {
 public:
  /// Trackers that share `ids` never give two tracks one identity.
  explicit Tracker(TrackerOptions options = {},
                   std::shared_ptr<std::int64_t> ids = std::make_shared<std::int64_t>(0))
      : options_(std::move(options)), ids_(std::move(ids)) {}

  /// Folds in one scan's detections. `sensor` tells several sensors apart: a target is missed by
  /// scans of the one that saw it last, not by those of others, which may look elsewhere. The
  /// tracks, in the order in which they were born or found again, valid until the next call;
  /// `Track::detection` is an index into `detections`.
  const std::vector<Track>& step(Time stamp, std::span<const Detection> detections, int sensor = 0);

  [[nodiscard]] const TrackerOptions& options() const { return options_; }
  [[nodiscard]] const Diagnostics& diagnostics() const { return diagnostics_; }

  /// Where the vehicles tracked will be at `stamp`: confirmed ones, and those hit at least twice.
  /// In the tracking frame, in the order of their tracks. Nothing after a jump of the clock.
  void expect(Time stamp, std::vector<Expected>& expected) const;

 private:
  /// Seconds since the last scan; nothing when this one comes too late to be used.
  std::optional<double> advance_clock(Time stamp);
  /// Keeps the usable ones, and where they stood.
  void select_usable(std::span<const Detection> detections);
  void fold_in(Time stamp, double dt_s, bool same_instant, int sensor);
  void give_up(Time stamp, double dt_s);
  void give_birth(Time stamp, double dt_s, int sensor, std::span<const int> track_of_detection);
  void report();

  TrackerOptions options_;
  Diagnostics diagnostics_;
  std::vector<Target> targets_;
  Workspace workspace_;
  LostTargets lost_;
  Shadows shadows_;
  associate::Associator associate_;
  std::vector<Detection> usable_;
  std::vector<int> source_;  ///< place of each usable detection in the caller's span
  std::vector<Track> tracks_;
  std::optional<Time> last_;
  std::shared_ptr<std::int64_t> ids_;  ///< the last one given
};

}  // namespace scanfuse::track
