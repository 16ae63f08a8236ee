#include "scanfuse/preprocess/deskew.hpp"

namespace scanfuse::preprocess {

void deskew(VirtualScan& scan, const EgoTwist& twist, const Eigen::Vector2d& sensor_m) {
  if (twist.is_still()) return;
  const auto vx = static_cast<float>(twist.velocity_m_per_s.x());
  const auto vy = static_cast<float>(twist.velocity_m_per_s.y());
  const auto rate = static_cast<float>(twist.yaw_rate_rad_per_s);
  const auto mx = static_cast<float>(sensor_m.x());
  const auto my = static_cast<float>(sensor_m.y());
  for (PlanarPoint& p : scan.points) {
    const float t = p.time_offset_s;
    const float turn = rate * t, half = turn / 2;
    const float sine = turn * (1 - turn * turn / 6), versine = turn * half;
    // The ego's way along an arc points along the middle of the turn.
    const float gone_x = t * (vx - half * vy), gone_y = t * (vy + half * vx);
    const float ego_x = p.x_m + mx, ego_y = p.y_m + my;
    p.x_m += gone_x - sine * ego_y - versine * ego_x;
    p.y_m += gone_y + sine * ego_x - versine * ego_y;
  }
}

}  // namespace scanfuse::preprocess
