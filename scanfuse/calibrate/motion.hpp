#pragma once

#include <span>
#include <vector>

#include "scanfuse/core/result.hpp"
#include "scanfuse/types/turntable.hpp"

/// The rig from lidar poses at known angles of the turntable: [Liu2023, sec. 2], and a closed form.
namespace scanfuse::calibrate {

struct TurnedPose {
  double turntable_rad = 0;
  Pose3 camera_from_lidar;
};

struct MotionFit {
  Rig rig;                           ///< no bias, scale 1, no covariance
  std::vector<double> rotation_rad;  ///< of each pose: how far its rotation is from the rig's
  std::vector<double> centre_m;      ///< and its centre
  double turn_ratio = 1;             ///< seen turn over commanded turn
  double rotation_median_rad = 0;
  double centre_median_m = 0;
};

/// Axis from relative rotations, log(R_i R_j') = n (psi_i - psi_j); rotation at angle 0 as the mean
/// of Rot(n, -psi_i) R_i; centres by the linear system O_i = G + Rot(n, psi_i) a, G across n. Poses
/// far from what most say have no weight. Has no degenerate mounting: radius 0, an axis along the
/// scan plane's normal and a turntable that turns the other way (n is then the other way around)
/// are all ordinary. An error where the angles do not differ.
[[nodiscard]] Result<MotionFit> rig_closed_form(std::span<const TurnedPose> poses);

/// The paper's functions of the turning angle as printed [Liu2023, eqs. 15-27]: axis as the normal
/// of the plane through the tips of the z axes (eq. 16, total least squares), circle through the
/// projected centres, unsigned angles (eqs. 19, 22), x axis from its mean part along the axis (eq.
/// 25). Where its two axes p_L and p_Z contradict each other, p_Z is taken and `contradiction` set.
struct PaperFit {
  Rig rig;
  bool contradiction = false;
};
[[nodiscard]] Result<PaperFit> rig_liu2023(std::span<const TurnedPose> poses);

}  // namespace scanfuse::calibrate
