#pragma once

#include <string>

#include "scanfuse/calibrate/joint.hpp"
#include "scanfuse/calibrate/prepare.hpp"

/// The joint method around the minimum: noise, outliers, which systematic errors are there.
namespace scanfuse::calibrate {

struct Refined {
  JointState state;
  std::vector<Sample> samples;                                ///< those that were used
  std::vector<std::pair<std::size_t, std::string>> left_out;  ///< position and reason
  KeptCorners corners;
  int corners_left_out = 0;
  JointNoise noise;
  JointUnknowns unknowns;
  JointSystem system;      ///< at the minimum
  JointSolution solution;  ///< of it
  double chi2_per_dof = 0;
  double line_chi2_per_dof = 0;
  int iterations = 0;
  bool converged = false;
};

[[nodiscard]] Result<Refined> refine(const TurntableFeatures& features, const Prepared& prepared,
                                     const TurntableOptions& options);

/// Every corner with its place on the board.
[[nodiscard]] KeptCorners all_corners(const TurntableFeatures& features);

/// Marks each return by the square it lies on and fits its lines anew.
void mark_squares(const std::array<BoardSpec, 2>& specs, const JointState& state,
                  std::vector<Sample>& samples);

}  // namespace scanfuse::calibrate
