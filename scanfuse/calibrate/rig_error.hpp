#pragma once

#include <Eigen/Core>

#include "scanfuse/types/turntable.hpp"

/// How small changes of a Rig, in the order of its covariance, move what it is used for.
namespace scanfuse::calibrate {

using RigVector = Eigen::Matrix<double, Rig::kParameters, 1>;

/// The rig changed by `delta`: axis direction normalised(n + B a), axis through p + B g (kept as
/// its point nearest to the camera), rotation exp(w) R, translation, bias and scale by addition.
[[nodiscard]] Rig changed(const Rig& rig, const RigVector& delta);

/// The change that turns `from` into `to`, to first order.
[[nodiscard]] RigVector difference(const Rig& from, const Rig& to);

/// d(rotation vector, translation) / d(delta) of the pose at an angle of the turntable; rotation in
/// the camera frame, left: exp(w) R.
[[nodiscard]] Eigen::Matrix<double, 6, Rig::kParameters> pose_jacobian(const Rig& rig,
                                                                       double turntable_rad);
[[nodiscard]] Eigen::Matrix<double, 6, 6> pose_covariance(const Rig& rig, double turntable_rad);

/// A return in the camera frame [Liu2023, eq. 28], its range corrected by the rig's bias.
[[nodiscard]] Eigen::Vector3d point_camera(const Rig& rig, double turntable_rad,
                                           double beam_angle_rad, double range_m);

/// d point_camera / d(delta).
[[nodiscard]] Eigen::Matrix<double, 3, Rig::kParameters> point_jacobian(const Rig& rig,
                                                                        double turntable_rad,
                                                                        double beam_angle_rad,
                                                                        double range_m);

/// Of a measured point: what the calibration leaves uncertain, and what this one return adds.
/// Errors of the calibration are shared by all points; those of the return are its own.
struct PointNoise {
  double range_m = 0;
  double turntable_rad = 0;
};
[[nodiscard]] Eigen::Matrix3d point_covariance(const Rig& rig, double turntable_rad,
                                               double beam_angle_rad, double range_m,
                                               const PointNoise& own = {});

}  // namespace scanfuse::calibrate
