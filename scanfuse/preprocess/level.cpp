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

}  // namespace scanfuse::preprocess
