#include "scanfuse/pipeline/scan_ego.hpp"

namespace scanfuse::pipeline {
namespace {

/// At the ego's origin, of a sensor that moves with it: vx, vy, yaw rate in the ego's axes.
PoseBuffer::Twist at_ego(const Eigen::Vector3d& sensor, const Pose2& ego_from_level) {
  const double w = sensor.z();
  return {sensor.x() + w * ego_from_level.y_m, sensor.y() - w * ego_from_level.x_m, w};
}

Eigen::Vector3d at_sensor(const PoseBuffer::Twist& ego, const Pose2& ego_from_level) {
  const double w = ego.yaw_rate_rad_per_s;
  return {ego.speed_m_per_s - w * ego_from_level.y_m, ego.lateral_m_per_s + w * ego_from_level.x_m,
          w};
}

}  // namespace

ScanEgo::Stream& ScanEgo::stream_of(const Scan& scan, const Pose3& ego_from_sensor,
                                    bool mount_is_known) {
  const auto [found, is_new] = streams_.try_emplace(mount_is_known ? "" : scan.frame_id);
  Stream& stream = found->second;
  if (is_new) {
    stream.leader = scan.sensor;
    // The levelled sensor frame: the ego's axes, the sensor's place.
    stream.ego_from_level = {ego_from_sensor.translation_m.x(), ego_from_sensor.translation_m.y(),
                             0};
  }
  return stream;
}

ScanEgo::Placement ScanEgo::place(Stream& stream, const Scan& scan, const Pose3& ego_from_sensor) {
  auto& odometry = stream.odometry;
  const Pose2 way = scan.sensor == stream.leader ? odometry(flatten_(scan, ego_from_sensor))
                                                 : odometry.expected(scan.stamp);
  const Pose2& mount = stream.ego_from_level;
  return {stream.world_from_start * Pose3::from_planar(mount * way * mount.inverse()),
          at_ego(odometry.twist(), mount)};
}

std::optional<ScanEgo::Placement> ScanEgo::operator()(const Scan& scan,
                                                      const Pose3& ego_from_sensor,
                                                      bool mount_is_known) {
  Stream& stream = stream_of(scan, ego_from_sensor, mount_is_known);
  Placement placed = place(stream, scan, ego_from_sensor);
  if (!stream.odometry.moves()) return std::nullopt;
  return placed;
}

std::optional<ScanEgo::Placement> ScanEgo::go_on(const Scan& scan, const Pose3& ego_from_sensor,
                                                 const Placement& start) {
  const bool is_first = streams_.empty();
  Stream& stream = stream_of(scan, ego_from_sensor, true);
  if (is_first) {
    stream.world_from_start = start.world_from_ego;
    stream.odometry.start_moving(at_sensor(start.twist, stream.ego_from_level));
  }
  Placement placed = place(stream, scan, ego_from_sensor);
  if (!stream.odometry.is_found()) return std::nullopt;
  return placed;
}

}  // namespace scanfuse::pipeline
