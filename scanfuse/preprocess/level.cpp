#include "scanfuse/preprocess/level.hpp"

#include <cmath>

namespace scanfuse::preprocess {

Scan level(Scan scan, const Pose3& ego_from_sensor) {
  const Eigen::Matrix3f rotation = ego_from_sensor.rotation.toRotationMatrix().cast<float>();
  if (rotation.isIdentity(0)) return scan;
  for (Return& r : scan.returns) {
    const Eigen::Vector3f p = rotation * Eigen::Vector3f(r.x_m, r.y_m, r.z_m);
    r.x_m = p.x();
    r.y_m = p.y();
    r.z_m = p.z();
  }
  if (scan.beams && rotation(2, 2) > 0.999999F) {
    scan.beams->first_azimuth_rad =
        wrap_pi(scan.beams->first_azimuth_rad + ego_from_sensor.planar().heading_rad);
  } else {
    scan.beams.reset();
  }
  return scan;
}

Scan deskew(Scan scan, const Eigen::Vector2d& velocity_ego_m_per_s, double yaw_rate_rad_per_s,
            const Pose3& ego_from_sensor) {
  const Pose3 sensor_from_ego = ego_from_sensor.inverse();
  for (Return& r : scan.returns) {
    const double t = r.time_offset_s;
    // Along an arc the mean direction over t is that of the middle; sin(h)/h shortens the chord.
    const double half = 0.5 * yaw_rate_rad_per_s * t;
    const double chord = std::abs(half) > 1e-9 ? std::sin(half) / half : 1;
    const Pose2 turn{0, 0, half};
    const Eigen::Vector2d moved = turn * Eigen::Vector2d(velocity_ego_m_per_s * (t * chord));
    const Pose3 start_from_now = Pose3::from_planar({moved.x(), moved.y(), 2 * half});
    const Eigen::Vector3d p =
        sensor_from_ego *
        (start_from_now * (ego_from_sensor * Eigen::Vector3d(r.x_m, r.y_m, r.z_m)));
    r.x_m = static_cast<float>(p.x());
    r.y_m = static_cast<float>(p.y());
    r.z_m = static_cast<float>(p.z());
  }
  return scan;
}

}  // namespace scanfuse::preprocess
