#include "scanfuse/calibrate/joint.hpp"
#include "scanfuse/calibrate/prepare.hpp"
#include "scanfuse/calibrate/refine.hpp"

namespace scanfuse::calibrate {
namespace {

JointNoise variances_of(const TurntableNoiseModel& noise) {
  const auto square = [](double x) { return x * x; };
  JointNoise out;
  out.corner_px2 = square(noise.corner_px);
  out.stripe_px2 = square(noise.stripe_px);
  out.range_m2 = square(noise.range_m);
  out.turntable_rad2 = square(noise.turntable_rad);
  out.effect = {square(noise.stripe_offset_px), square(noise.stripe_tilt_rad),
                square(noise.lidar_offset_m),   square(noise.lidar_tilt_rad),
                square(noise.lidar_bow_m),      0};
  return out;
}

}  // namespace

Result<RigCovariance> turntable_bound(const TurntableFeatures& features, const Rig& truth,
                                      const std::array<Pose3, 2>& camera_from_board,
                                      const TurntableNoiseModel& noise,
                                      const TurntableOptions& with) {
  auto prepared = prepare(features, with);
  if (!prepared) return tl::unexpected(prepared.error());
  JointState state;
  state.rig = truth;
  state.camera_from_board = camera_from_board;
  state.correction_rad.assign(prepared->samples.size(), 0);
  mark_squares(features.boards, state, prepared->samples);
  const JointUnknowns unknowns{with.range_bias == Systematic::kOn,
                               with.square_bias == Systematic::kOn,
                               with.angle_scale == Systematic::kOn};
  const KeptCorners corners = all_corners(features);
  const auto system = linearise({features.camera, prepared->samples, corners}, state);
  return solve(system, variances_of(noise), unknowns)
      .covariance.topLeftCorner<Rig::kParameters, Rig::kParameters>();
}

}  // namespace scanfuse::calibrate
