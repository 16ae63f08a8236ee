#include "scanfuse/calibrate/cloud/assemble.hpp"

#include <algorithm>
#include <cmath>

#include "scanfuse/calibrate/cloud/axis_frame.hpp"

namespace scanfuse::calibrate {
namespace {

/// Room for a turn that was commanded a hair beyond the calibrated ones.
constexpr double kArcSlack_rad = 1e-4;

bool beyond_arc(const Rig& rig, double turntable_rad) {
  const auto [low, high] = std::minmax(rig.first_turntable_rad, rig.last_turntable_rad);
  if (low == high) return false;
  return turntable_rad < low - kArcSlack_rad || turntable_rad > high + kArcSlack_rad;
}

Pose3 cloud_from_lidar(const Rig& rig, CloudFrame frame, double turntable_rad) {
  return frame_from_camera(rig, frame) * rig.pose(turntable_rad);
}

}  // namespace

Result<AssembledCloud> assemble(std::span<const TurntablePosition> scans, const Rig& rig,
                                const AssembleOptions& options) {
  AssembledCloud made;
  made.cloud.frame = options.frame;
  const RangeRaster raster = range_raster(scans);
  made.range_noise_m = range_noise(raster.image);
  const auto mixed = find_mixed(raster.image, options.mixed);
  for (std::size_t p = 0; p < scans.size(); ++p) {
    const CloudProfile profile{scans[p].turntable_rad,
                               cloud_from_lidar(rig, options.frame, scans[p].turntable_rad)};
    made.beyond_arc += beyond_arc(rig, scans[p].turntable_rad) ? 1 : 0;
    for (std::size_t k = 0; k < scans[p].scan.size(); ++k) {
      const BeamReturn& beam = scans[p].scan[k];
      const int column = raster.columns[p][k];
      if (!std::isfinite(beam.range_m) || column < 0) continue;
      ++made.returns;
      const bool is_mixed = mixed[p * raster.image.beams + static_cast<std::size_t>(column)];
      made.mixed += is_mixed ? 1 : 0;
      if (is_mixed && !options.keep_mixed) continue;
      const double range = beam.range_m - rig.range_bias_m;
      const Eigen::Vector3d in_lidar(range * std::cos(beam.angle_rad),
                                     range * std::sin(beam.angle_rad), 0);
      made.cloud.points.push_back(
          {profile.cloud_from_lidar * in_lidar, beam.intensity, static_cast<int>(p), column});
    }
    made.cloud.profiles.push_back(profile);
  }
  if (made.returns > 0) return made;
  return fail(Error::Code::kMalformed, "none of the {} scans has a valid range", scans.size());
}

Cloud reassembled(const Cloud& cloud, const Rig& made_with, const Rig& rig) {
  Cloud moved = cloud;
  for (CloudProfile& profile : moved.profiles) {
    profile.cloud_from_lidar = cloud_from_lidar(rig, cloud.frame, profile.turntable_rad);
  }
  const double longer_m = made_with.range_bias_m - rig.range_bias_m;
  for (CloudPoint& point : moved.points) {
    if (point.profile < 0) continue;
    const auto p = static_cast<std::size_t>(point.profile);
    Eigen::Vector3d in_lidar = cloud.profiles[p].cloud_from_lidar.inverse() * point.position_m;
    in_lidar *= 1 + longer_m / std::max(in_lidar.norm(), 1e-6);
    point.position_m = moved.profiles[p].cloud_from_lidar * in_lidar;
  }
  return moved;
}

}  // namespace scanfuse::calibrate
