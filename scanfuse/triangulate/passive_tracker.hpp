#pragma once

#include <optional>
#include <vector>

#include "scanfuse/core/diagnostics.hpp"
#include "scanfuse/triangulate/associate_tracks.hpp"
#include "scanfuse/triangulate/sensor_bias.hpp"

namespace scanfuse::triangulate {

struct PassiveStep {
  std::vector<PassiveTrack> tracks;            ///< by id, tentative ones too
  std::vector<std::int64_t> track_of_bearing;  ///< id, -1 for clutter
  double gap = 0;                              ///< of the association
};

/// Follows targets by bearings, scan after scan. Weights of the joint association, all against
/// "false alarms":
///
///   track with bearings    ln [r e^L / (1 - r + r e^L0)]   r: existence, L:
///   TrackColumn::log_ratio,
///                                                          L0: that of no bearing
///   new target             CostMethod of two or more bearings; intensity: targets not seen yet
///
/// One row a track keeps it to one column. Existence moves by L [Blackman1999, section 6.2] and
/// decays with `life_s`. Of sensors without any bearing in a scan nothing is believed: they did
/// not look. Where the scene names no volume or no number of targets they are taken from the first
/// scan that has bearings of two sensors. Scans come in order of time; a step back counts as none.
/// The same result on any number of threads.
class PassiveTracker {
 public:
  PassiveTracker(PassiveScene scene, const PassiveTrackOptions& options,
                 const AssociationOptions& association = {});
  /// Offsets to take off all bearings; no more are estimated.
  void set_biases(std::vector<SensorBias> biases);

  /// An error where a scan has more hypotheses than allowed (associate_scan.hpp).
  [[nodiscard]] Result<PassiveStep> step(const BearingScan& scan, int threads = 1);
  /// Estimated or given; none: empty.
  [[nodiscard]] std::vector<SensorBias> biases() const;
  [[nodiscard]] const Diagnostics& diagnostics() const { return diagnostics_; }

 private:
  [[nodiscard]] BearingScan corrected(BearingScan scan) const;
  [[nodiscard]] ScenePrior prior_of(const BearingScan& scan);
  void predict(Time stamp);
  void update(const TrackChoice& choice, std::span<const LineOfSight> lines, Time stamp);
  void learn_bias(const BearingScan& scan);
  void start(const TrackChoice& choice, std::span<const LineOfSight> lines, const ScenePrior& prior,
             Time stamp);
  void drop(Time stamp);

  PassiveScene scene_;
  PassiveTrackOptions options_;
  AssociationOptions association_;
  PointUpdate point_update_;
  std::vector<PassiveTrack> tracks_;
  std::optional<BiasFilter> bias_filter_;
  std::vector<SensorBias> biases_;
  Diagnostics diagnostics_;
  std::optional<Time> last_;
  std::optional<double> unseen_targets_;  ///< expected number of those without a track
  std::int64_t next_id_ = 1;
};

}  // namespace scanfuse::triangulate
