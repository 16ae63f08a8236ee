#pragma once

#include <Eigen/Geometry>

#include "scanfuse/geometry/angles.hpp"

namespace scanfuse {

/// A planar rigid transform, named `target_from_source`: p_target = pose * p_source.
struct Pose2 {
  double x_m = 0;
  double y_m = 0;
  double heading_rad = 0;

  [[nodiscard]] Eigen::Vector2d operator*(const Eigen::Vector2d& p) const {
    const double c = std::cos(heading_rad), s = std::sin(heading_rad);
    return {x_m + c * p.x() - s * p.y(), y_m + s * p.x() + c * p.y()};
  }
  [[nodiscard]] Pose2 operator*(const Pose2& other) const {
    const Eigen::Vector2d t = *this * Eigen::Vector2d(other.x_m, other.y_m);
    return {t.x(), t.y(), wrap_pi(heading_rad + other.heading_rad)};
  }
  [[nodiscard]] Pose2 inverse() const {
    const double c = std::cos(heading_rad), s = std::sin(heading_rad);
    return {-c * x_m - s * y_m, s * x_m - c * y_m, wrap_pi(-heading_rad)};
  }
};

/// A rigid transform in space, named `target_from_source`: p_target = pose * p_source.
struct Pose3 {
  Eigen::Quaterniond rotation = Eigen::Quaterniond::Identity();
  Eigen::Vector3d translation_m = Eigen::Vector3d::Zero();

  [[nodiscard]] static Pose3 from_planar(const Pose2& pose, double z_m = 0) {
    return {Eigen::Quaterniond(Eigen::AngleAxisd(pose.heading_rad, Eigen::Vector3d::UnitZ())),
            {pose.x_m, pose.y_m, z_m}};
  }
  [[nodiscard]] Eigen::Vector3d operator*(const Eigen::Vector3d& p) const {
    return rotation * p + translation_m;
  }
  [[nodiscard]] Pose3 operator*(const Pose3& other) const {
    return {(rotation * other.rotation).normalized(), *this * other.translation_m};
  }
  [[nodiscard]] Pose3 inverse() const {
    const Eigen::Quaterniond back = rotation.conjugate();
    return {back, -(back * translation_m)};
  }
  /// Rotation about z of the x axis, and the translation in the plane.
  [[nodiscard]] Pose2 planar() const {
    const Eigen::Vector3d x_axis = rotation * Eigen::Vector3d::UnitX();
    return {translation_m.x(), translation_m.y(), std::atan2(x_axis.y(), x_axis.x())};
  }
};

/// The shortest turn that takes the z axis to the direction of `towards`, which is not zero.
/// (Eigen's FromTwoVectors brings a singular value decomposition into every source: 5 s each.)
[[nodiscard]] inline Eigen::Quaterniond turn_z_to(const Eigen::Vector3d& towards) {
  const Eigen::Vector3d n = towards.normalized();
  const double aside2 = n.head<2>().squaredNorm();
  if (n.z() < 0 && aside2 < 1e-24) return {0, 1, 0, 0};           // straight back: about x
  const double w = n.z() < 0 ? aside2 / (1 - n.z()) : 1 + n.z();  // 1 + n.z, exact near -z too
  return Eigen::Quaterniond(w, -n.y(), n.x(), 0).normalized();
}

/// The pose a share `t` of the way from a to b: translation linear, rotation along the great arc.
[[nodiscard]] inline Pose3 interpolate(const Pose3& a, const Pose3& b, double t) {
  return {a.rotation.slerp(t, b.rotation),
          a.translation_m + t * (b.translation_m - a.translation_m)};
}

}  // namespace scanfuse
