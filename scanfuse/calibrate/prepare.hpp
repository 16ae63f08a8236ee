#pragma once

#include "scanfuse/calibrate/joint_state.hpp"
#include "scanfuse/calibrate/motion.hpp"
#include "scanfuse/calibrate/turntable.hpp"

/// From features to what can be fitted: boards, usable positions, a first rig.
namespace scanfuse::calibrate {

struct Prepared {
  std::array<BoardPose, 2> boards;
  std::vector<Sample> samples;       ///< usable, as they came
  std::vector<std::string> reasons;  ///< of each position; empty where it is usable
  MotionFit motion;                  ///< closed form over the samples' poses
  bool ascending = true;
  bool decided = true;
};

/// Both orders of the boards are tried where the options leave it open. An error where fewer than
/// three positions are usable, or where angles and motion contradict each other.
[[nodiscard]] Result<Prepared> prepare(const TurntableFeatures& features,
                                       const TurntableOptions& options);

[[nodiscard]] std::vector<TurnedPose> poses_of(const std::vector<Sample>& samples);

}  // namespace scanfuse::calibrate
