#pragma once

#include <limits>
#include <vector>

#include "scanfuse/calibrate/cloud/beam_grid.hpp"

namespace scanfuse::calibrate {

/// What became of a beam near a flat target.
enum class BeamState {
  kOn,      ///< its return lies on the target
  kMixed,   ///< partly on: between target and background, or removed for that
  kBeyond,  ///< on the background
  kNothing  ///< nothing came back, nor from further out
};

struct EdgeBeam {
  Eigen::Vector2d place_m = Eigen::Vector2d::Zero();  ///< where it meets the target's plane
  BeamState state = BeamState::kOn;
  bool backed = true;  ///< what it meets outside the target is a background, not nothing
  double intensity = std::numeric_limits<double>::quiet_NaN();  ///< NaN: nothing came back
  double behind_m = std::numeric_limits<double>::quiet_NaN();   ///< its return, behind the plane
};

/// A return further from the target's plane, along its ray, is not on the target.
[[nodiscard]] double on_tolerance_m(const PlaneFit& plane);

/// Every beam that meets the plane within `reach_m` of `around` (in the plane), in order of profile
/// and beam. Beams without a return inside the target are passed over.
[[nodiscard]] std::vector<EdgeBeam> edge_beams(const BeamGrid& grid, const PlaneFit& plane,
                                               const Eigen::Vector2d& around, double reach_m);

}  // namespace scanfuse::calibrate
