#include "scanfuse/calibrate/cloud/axis_frame.hpp"

namespace scanfuse::calibrate {

Pose3 axis_from_camera(const Rig& rig) {
  const Eigen::Vector3d n = rig.axis_direction;
  const Eigen::Vector3d centre = rig.camera_from_lidar.translation_m;
  const Eigen::Matrix3d lidar = rig.camera_from_lidar.rotation.toRotationMatrix();
  const auto across = [&](const Eigen::Vector3d& v) { return Eigen::Vector3d(v - n * n.dot(v)); };
  Eigen::Vector3d y = across(lidar.col(2));
  if (y.norm() < 0.1) y = across(lidar.col(1));
  y.normalize();
  Eigen::Matrix3d camera_from_axis;
  camera_from_axis << y.cross(n), y, n;
  const Eigen::Vector3d foot = rig.axis_point_m + n * n.dot(centre - rig.axis_point_m);
  return Pose3{Eigen::Quaterniond(camera_from_axis), foot}.inverse();
}

Pose3 frame_from_camera(const Rig& rig, CloudFrame frame) {
  return frame == CloudFrame::kAxis ? axis_from_camera(rig) : Pose3{};
}

}  // namespace scanfuse::calibrate
