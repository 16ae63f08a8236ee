#include "scanfuse/io/ros/encode.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "scanfuse/geometry/angles.hpp"
#include "scanfuse/io/ros/definitions.hpp"
#include "scanfuse/io/ros/wire_writer.hpp"

namespace scanfuse::io::ros {

namespace {

EncodedMessage finished(const char* type, CdrWriter& writer) {
  return {type, definition_of(type), writer.take()};
}

void write_header(CdrWriter& writer, Time stamp, const std::string& frame_id) {
  writer.write_time(stamp);
  writer.write_string(frame_id);
}

void write_vector(CdrWriter& writer, const Eigen::Vector3d& v) {
  for (int i = 0; i < 3; ++i) writer.write(v[i]);
}

void write_quaternion(CdrWriter& writer, const Eigen::Quaterniond& q) {
  for (const double part : {q.x(), q.y(), q.z(), q.w()}) writer.write(part);
}

void write_zeros(CdrWriter& writer, int count) {
  for (int i = 0; i < count; ++i) writer.write(0.0);
}

constexpr double kUnknownRate = std::numeric_limits<double>::quiet_NaN();

/// Seconds between beams; negative where the sweep runs from the last column to the first.
/// Nothing if the times do not grow evenly from one end.
std::optional<double> even_time_step(const Scan& scan) {
  const auto by_beam = [](const Return& a, const Return& b) { return a.beam < b.beam; };
  const auto [low, high] = std::minmax_element(scan.returns.begin(), scan.returns.end(), by_beam);
  if (low == scan.returns.end()) return 0.0;
  double step = 0;
  if (low->beam != high->beam) {
    step = (double{high->time_offset_s} - low->time_offset_s) / (high->beam - low->beam);
  } else if (low->beam > 0) {
    step = double{low->time_offset_s} / low->beam;
  }
  const int origin = step < 0 ? scan.beams->columns - 1 : 0;
  for (const auto& point : scan.returns) {
    if (std::abs(step * (point.beam - origin) - point.time_offset_s) > 1e-6) return std::nullopt;
  }
  return step;
}

bool stands_on_its_beam(const Return& point, const BeamPattern& beams) {
  if (point.beam < 0 || point.beam >= beams.columns) return false;
  if (point.z_m != 0 || point.layer != 0 || point.echo != 0) return false;
  const double range = std::hypot(point.x_m, point.y_m);
  const auto low = static_cast<float>(beams.min_range_m);
  const auto high = static_cast<float>(beams.max_range_m);
  if (!(range > 0 && range >= low * (1 + 1e-6) && range < high * (1 - 1e-6))) return false;
  const double azimuth = beams.first_azimuth_rad + point.beam * beams.step_rad;
  return std::abs(wrap_pi(std::atan2(point.y_m, point.x_m) - azimuth)) < 1e-4;
}

EncodedMessage encode_laser_scan(const Scan& scan) {
  const BeamPattern& beams = *scan.beams;
  const double time_step = even_time_step(scan).value_or(0);
  const bool backwards = time_step < 0;
  const double last_azimuth = beams.first_azimuth_rad + beams.step_rad * (beams.columns - 1);
  CdrWriter writer;
  write_header(writer, scan.stamp, scan.frame_id);
  writer.write(static_cast<float>(backwards ? last_azimuth : beams.first_azimuth_rad));
  writer.write(static_cast<float>(backwards ? beams.first_azimuth_rad : last_azimuth));
  writer.write(static_cast<float>(backwards ? -beams.step_rad : beams.step_rad));
  writer.write(static_cast<float>(std::abs(time_step)));
  writer.write(0.0F);  // scan_time: not known
  writer.write(static_cast<float>(beams.min_range_m));
  writer.write(static_cast<float>(beams.max_range_m));
  const auto columns = static_cast<std::size_t>(beams.columns);
  std::vector<float> ranges(columns, std::numeric_limits<float>::infinity());
  std::vector<float> intensities(columns, 0.0F);
  for (const auto& point : scan.returns) {
    const auto place =
        static_cast<std::size_t>(backwards ? beams.columns - 1 - point.beam : point.beam);
    ranges[place] = std::hypot(point.x_m, point.y_m);
    intensities[place] = point.intensity;
  }
  for (const auto* values : {&ranges, &intensities}) {
    writer.write(static_cast<std::uint32_t>(values->size()));
    for (const float value : *values) writer.write(value);
  }
  return finished("sensor_msgs/msg/LaserScan", writer);
}

struct CloudField {
  const char* name;
  std::uint32_t offset;
  std::uint8_t datatype;
};
constexpr std::uint8_t kUint8 = 2, kInt16 = 3, kInt32 = 5, kFloat32 = 7;
constexpr CloudField kCloudFields[] = {
    {"x", 0, kFloat32},  {"y", 4, kFloat32},   {"z", 8, kFloat32},    {"intensity", 12, kFloat32},
    {"t", 16, kFloat32}, {"beam", 20, kInt32}, {"layer", 24, kInt16}, {"echo", 26, kUint8}};
constexpr std::uint32_t kCloudPointBytes = 28;

void write_cloud_point(CdrWriter& writer, const Return& point) {
  for (const float value :
       {point.x_m, point.y_m, point.z_m, point.intensity, point.time_offset_s}) {
    writer.write(value);
  }
  writer.write(point.beam);
  writer.write(point.layer);
  writer.write(point.echo);
  writer.write(std::uint8_t{0});
}

/// A point that is no echo, of the last beam of the last layer: it carries how many there are.
Return last_beam(const BeamPattern& beams) {
  constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
  Return point{kNan, kNan, kNan};
  point.beam = beams.columns - 1;
  point.layer = static_cast<std::int16_t>(std::clamp(beams.layers - 1, 0, 32767));
  return point;
}

EncodedMessage encode_point_cloud(const Scan& scan) {
  const bool patterned = scan.beams && scan.beams->columns > 0;
  const auto count = static_cast<std::uint32_t>(scan.returns.size() + (patterned ? 1 : 0));
  CdrWriter writer;
  write_header(writer, scan.stamp, scan.frame_id);
  writer.write(std::uint32_t{1});
  writer.write(count);
  writer.write(static_cast<std::uint32_t>(std::size(kCloudFields)));
  for (const auto& field : kCloudFields) {
    writer.write_string(field.name);
    writer.write(field.offset);
    writer.write(field.datatype);
    writer.write(std::uint32_t{1});
  }
  writer.write(std::uint8_t{0});
  writer.write(kCloudPointBytes);
  writer.write(count * kCloudPointBytes);
  writer.write(count * kCloudPointBytes);
  // Every point is 28 bytes and the data start on a multiple of 4, so writing field by field leaves
  // no gaps but the one spare byte.
  for (const auto& point : scan.returns) write_cloud_point(writer, point);
  if (patterned) write_cloud_point(writer, last_beam(*scan.beams));
  writer.write(static_cast<std::uint8_t>(patterned ? 0 : 1));  // is_dense
  return finished("sensor_msgs/msg/PointCloud2", writer);
}

}  // namespace

bool fits_laser_scan(const Scan& scan) {
  if (!scan.beams || scan.beams->layers != 1 || scan.beams->columns < 1) return false;
  if (!(scan.beams->step_rad > 0) || scan.beams->columns > 1'000'000) return false;
  std::vector<bool> seen(static_cast<std::size_t>(scan.beams->columns), false);
  for (const auto& point : scan.returns) {
    if (!stands_on_its_beam(point, *scan.beams)) return false;
    if (seen[static_cast<std::size_t>(point.beam)]) return false;
    seen[static_cast<std::size_t>(point.beam)] = true;
  }
  return even_time_step(scan).has_value();
}

EncodedMessage encode_cdr(const Scan& scan) {
  return fits_laser_scan(scan) ? encode_laser_scan(scan) : encode_point_cloud(scan);
}

EncodedMessage encode_cdr(const PoseSample& pose) {
  CdrWriter writer;
  write_header(writer, pose.stamp, pose.frame_id);
  writer.write_string(pose.child_frame_id);
  write_vector(writer, pose.pose.translation_m);
  write_quaternion(writer, pose.pose.rotation);
  write_zeros(writer, 36);
  write_vector(writer, {pose.speed_m_per_s.value_or(kUnknownRate), 0, 0});
  write_vector(writer, {0, 0, pose.yaw_rate_rad_per_s.value_or(kUnknownRate)});
  write_zeros(writer, 36);
  return finished("nav_msgs/msg/Odometry", writer);
}

EncodedMessage encode_cdr(std::span<const TransformSample> transforms) {
  CdrWriter writer;
  writer.write(static_cast<std::uint32_t>(transforms.size()));
  for (const auto& edge : transforms) {
    write_header(writer, edge.stamp, edge.parent);
    writer.write_string(edge.child);
    write_vector(writer, edge.parent_from_child.translation_m);
    write_quaternion(writer, edge.parent_from_child.rotation);
  }
  return finished("tf2_msgs/msg/TFMessage", writer);
}

EncodedMessage encode_cdr(const ImuSample& imu) {
  CdrWriter writer;
  write_header(writer, imu.stamp, imu.frame_id);
  write_quaternion(writer, imu.orientation.value_or(Eigen::Quaterniond::Identity()));
  writer.write(imu.orientation ? 0.0 : -1.0);
  write_zeros(writer, 8);
  write_vector(writer, imu.angular_velocity_rad_per_s);
  write_zeros(writer, 9);
  write_vector(writer, imu.acceleration_m_per_s2);
  write_zeros(writer, 9);
  return finished("sensor_msgs/msg/Imu", writer);
}

}  // namespace scanfuse::io::ros
