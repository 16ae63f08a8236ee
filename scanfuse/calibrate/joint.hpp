#pragma once

#include <vector>

#include "scanfuse/calibrate/joint_state.hpp"

/// Joint refinement: all unknowns from all observations. The nonlinear minimum is Ceres'; around it
/// everything that a covariance, a jackknife or a noise estimate needs is linear and small.
namespace scanfuse::calibrate {

struct JointInput {
  const Camera& camera;
  const std::vector<Sample>& samples;
  const KeptCorners& corners;
};

/// One observation, linear in the changes: a . x + angle . correction = y + noise. Its variance is
/// that of one point, plus that of the line's effect times `share`.
struct JointRow {
  GlobalVector a = GlobalVector::Zero();
  double angle = 0;
  double y = 0;
  bool stripe = false;
  LineEffect effect = LineEffect::kNone;
  double share = 0;
};

struct JointSystem {
  std::vector<std::vector<JointRow>> samples;
  std::vector<double> correction_rad;                      ///< where the angles' corrections stand
  GlobalMatrix corner_information = GlobalMatrix::Zero();  ///< of unit variance
  GlobalVector corner_right = GlobalVector::Zero();
  double corner_squares = 0;
  int corner_rows = 0;
};

[[nodiscard]] JointSystem linearise(const JointInput& input, const JointState& state);

/// What one sample says of the global unknowns, its angle taken out.
struct SampleInformation {
  GlobalMatrix information = GlobalMatrix::Zero();
  GlobalVector right = GlobalVector::Zero();
  GlobalVector coupling = GlobalVector::Zero();
  double angle_information = 0;
  double angle_right = 0;
};
[[nodiscard]] SampleInformation inform(const std::vector<JointRow>& rows, double correction_rad,
                                       const JointNoise& noise);

struct JointSolution {
  GlobalVector change = GlobalVector::Zero();
  GlobalMatrix covariance = GlobalMatrix::Zero();  ///< 0 where not an unknown
  std::vector<double> angle_change_rad;
  std::vector<SampleInformation> parts;
  bool definite = true;  ///< false: some direction is not observed at all
};
[[nodiscard]] JointSolution solve(const JointSystem& system, const JointNoise& noise,
                                  const JointUnknowns& unknowns);

/// A row after the solution: its residual, and how much of its variance the fit took up.
struct RowFit {
  double residual = 0;
  double variance = 0;
  double leverage = 0;  ///< of 1
};
/// Rows of each sample, then the angle's prior as the last.
[[nodiscard]] std::vector<std::vector<RowFit>> fit_rows(const JointSystem& system,
                                                        const JointNoise& noise,
                                                        const JointSolution& solution);

/// Restricted maximum likelihood of the effects' variances, the turntable's being at least its
/// prior. Linear: at a minimum.
[[nodiscard]] JointNoise estimate_effects(const JointSystem& system, JointNoise noise,
                                          const JointUnknowns& unknowns);

struct JointRun {
  JointState state;
  int iterations = 0;
  bool converged = false;
};
/// The nonlinear minimum. `robust`: lines far off count less (Cauchy's loss on each line).
[[nodiscard]] JointRun minimise(const JointInput& input, const JointState& start,
                                const JointNoise& noise, const JointUnknowns& unknowns,
                                bool robust);

/// Covariance of the global unknowns from leaving out blocks of neighbouring positions in turn,
/// plus the corners' part, which all blocks share.
[[nodiscard]] GlobalMatrix jackknife(const JointSystem& system, const JointNoise& noise,
                                     const JointUnknowns& unknowns,
                                     const std::vector<double>& turntable_rad, int blocks);

}  // namespace scanfuse::calibrate
