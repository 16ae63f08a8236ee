#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <span>
#include <vector>

#include "scanfuse/evaluate/options.hpp"
#include "scanfuse/types/track.hpp"
#include "scanfuse/types/truth.hpp"

namespace scanfuse::evaluate {

/// One scan as the metrics see it: truth and confirmed tracks, both in the truth's frame.
struct ScoredFrame {
  Time stamp;
  std::int64_t frame = 0;
  std::vector<TruthObject> truth;
  std::vector<Track> tracks;
  std::vector<int> truth_index;                        ///< into Sequence::truth_ids, one each
  std::vector<int> track_index;                        ///< into Sequence::track_ids, one each
  Eigen::Vector2d viewer_m = Eigen::Vector2d::Zero();  ///< the ego vehicle, where the step tells it
  double viewer_heading_rad = 0;
  Eigen::MatrixXd distance_m;  ///< truth x tracks; infinity where a position is not finite
};

/// All scans in order of time, with ids numbered densely (ascending).
struct Sequence {
  std::vector<ScoredFrame> frames;
  std::vector<std::int64_t> truth_ids;
  std::vector<std::int64_t> track_ids;
};

/// Brings tracks and truth together.
///
/// A truth frame belongs to the step with its frame number; where the stamps of such pairs mostly
/// disagree (files that count differently), and else for a number no step has, to the step nearest
/// in time within half a scan period. Truth frames without a step count as scans without tracks.
/// Tracks are moved into the frame of the truth by StepResult::world_from_ego. Left out: tentative
/// tracks; truth objects with too few visible points or outside the region or the view, together
/// with the track nearest to each (within match_m, by optimal assignment); other tracks outside
/// them.
[[nodiscard]] Sequence make_sequence(std::span<const StepResult> steps,
                                     std::span<const TruthFrame> truth,
                                     const EvaluateOptions& options);

/// Brings what a step tells in its output frame into the frame of the truth.
[[nodiscard]] Pose2 truth_from_output(const StepResult& step, const TruthFrame& truth);

/// The track as seen in another frame: `to_from` is target_from_source. Position, heading, velocity
/// and covariances turn; velocity stays over ground.
[[nodiscard]] Track moved(const Track& track, const Pose2& to_from);

}  // namespace scanfuse::evaluate
