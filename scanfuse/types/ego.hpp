#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "scanfuse/core/time.hpp"
#include "scanfuse/geometry/pose.hpp"

namespace scanfuse {

/// A pose as a topic tells it: odometry, motion capture, localisation. Also any other object's
/// pose.
struct PoseSample {
  Time stamp;
  std::string frame_id;        ///< parent frame, may be empty
  std::string child_frame_id;  ///< may be empty
  Pose3 pose;                  ///< parent_from_child
  std::optional<double> speed_m_per_s;
  std::optional<double> yaw_rate_rad_per_s;
};

/// One edge of the tf tree.
struct TransformSample {
  Time stamp;
  std::string parent;
  std::string child;
  Pose3 parent_from_child;
  bool is_static = false;
};

struct ImuSample {
  Time stamp;
  std::string frame_id;
  std::optional<Eigen::Quaterniond> orientation;
  Eigen::Vector3d angular_velocity_rad_per_s = Eigen::Vector3d::Zero();
  Eigen::Vector3d acceleration_m_per_s2 = Eigen::Vector3d::Zero();
};

}  // namespace scanfuse
