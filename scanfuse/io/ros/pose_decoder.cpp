#include <array>
#include <cmath>

#include "scanfuse/io/ros/message_decoders.hpp"

namespace scanfuse::io::ros {

namespace {

Eigen::Vector3d read_vector(WireReader& reader) {
  const double x = reader.read<double>(), y = reader.read<double>(), z = reader.read<double>();
  return {x, y, z};
}

Eigen::Quaterniond read_quaternion(WireReader& reader) {
  std::array<double, 4> q{};
  for (auto& part : q) part = reader.read<double>();
  return {q[3], q[0], q[1], q[2]};
}

/// A pose as the message has it: position, then orientation. Its numbers may be anything.
Pose3 read_raw_pose(WireReader& reader) {
  const auto translation = read_vector(reader);
  return {read_quaternion(reader), translation};
}

bool is_usable(const Pose3& pose) {
  const double size = pose.rotation.norm();
  return pose.translation_m.allFinite() && std::isfinite(size);
}

/// Makes the quaternion a rotation; an unset one means "not rotated".
void settle_rotation(Pose3& pose, Diagnostics& diagnostics) {
  if (pose.rotation.norm() < 1e-6) {
    diagnostics.note("pose without orientation taken as unrotated");
    pose.rotation = Eigen::Quaterniond::Identity();
  }
  // Left alone where it is a unit quaternion already: what was written is read back bit for bit.
  if (std::abs(pose.rotation.squaredNorm() - 1) > 1e-12) pose.rotation.normalize();
}

Pose3 read_pose(WireReader& reader, Diagnostics& diagnostics) {
  Pose3 pose = read_raw_pose(reader);
  if (!is_usable(pose)) reader.refuse("the pose is not finite");
  if (reader.ok()) settle_rotation(pose, diagnostics);
  return pose;
}

std::optional<double> if_finite(double value) {
  return std::isfinite(value) ? std::optional(value) : std::nullopt;
}

/// One edge; nothing if its numbers are no pose.
std::optional<TransformSample> read_transform(WireReader& reader, Diagnostics& diagnostics) {
  auto header = read_header(reader);
  TransformSample edge;
  edge.stamp = header.stamp;
  edge.parent = std::move(header.frame_id);
  edge.child = reader.read_string();
  edge.parent_from_child = read_raw_pose(reader);
  if (!reader.ok()) return std::nullopt;
  if (!is_usable(edge.parent_from_child)) {
    diagnostics.damage("transform that is not finite skipped", edge.parent + " <- " + edge.child);
    return std::nullopt;
  }
  settle_rotation(edge.parent_from_child, diagnostics);
  return edge;
}

}  // namespace

DecodedMessage decode_odometry(WireReader& reader) {
  DecodedMessage decoded;
  auto sample = read_stamped<PoseSample>(reader);
  sample.child_frame_id = reader.read_string();
  sample.pose = read_pose(reader, decoded.diagnostics);
  reader.skip<double>(36);
  const auto linear = read_vector(reader);
  const auto angular = read_vector(reader);
  reader.skip<double>(36);
  // The twist stands in the child's frame: x is forward.
  sample.speed_m_per_s = if_finite(std::copysign(std::hypot(linear.x(), linear.y()), linear.x()));
  sample.yaw_rate_rad_per_s = if_finite(angular.z());
  decoded.payload = std::move(sample);
  return decoded;
}

DecodedMessage decode_pose(WireReader& reader, bool with_covariance) {
  DecodedMessage decoded;
  auto sample = read_stamped<PoseSample>(reader);
  sample.pose = read_pose(reader, decoded.diagnostics);
  if (with_covariance) reader.skip<double>(36);
  decoded.payload = std::move(sample);
  return decoded;
}

DecodedMessage decode_transform(WireReader& reader) {
  DecodedMessage decoded;
  std::vector<TransformSample> edges;
  if (auto edge = read_transform(reader, decoded.diagnostics)) edges.push_back(std::move(*edge));
  decoded.payload = std::move(edges);
  return decoded;
}

DecodedMessage decode_transforms(WireReader& reader) {
  DecodedMessage decoded;
  std::vector<TransformSample> edges;
  const auto count = reader.read_count(56 + 16);
  for (std::uint32_t i = 0; i < count && reader.ok(); ++i) {
    if (auto edge = read_transform(reader, decoded.diagnostics)) edges.push_back(std::move(*edge));
  }
  decoded.payload = std::move(edges);
  return decoded;
}

DecodedMessage decode_imu(WireReader& reader) {
  DecodedMessage decoded;
  auto sample = read_stamped<ImuSample>(reader);
  const auto orientation = read_quaternion(reader);
  const auto known = reader.read<double>();  // -1 in front of a covariance: no such data
  reader.skip<double>(8);
  sample.angular_velocity_rad_per_s = read_vector(reader);
  reader.skip<double>(9);
  sample.acceleration_m_per_s2 = read_vector(reader);
  reader.skip<double>(9);
  if (!sample.angular_velocity_rad_per_s.allFinite() || !sample.acceleration_m_per_s2.allFinite()) {
    reader.refuse("rates or accelerations are not finite");
  }
  const double size = orientation.norm();
  if (known != -1 && std::isfinite(size) && size > 1e-6) {
    sample.orientation = std::abs(size - 1) > 1e-12 ? orientation.normalized() : orientation;
  }
  decoded.payload = std::move(sample);
  return decoded;
}

}  // namespace scanfuse::io::ros
