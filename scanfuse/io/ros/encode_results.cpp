#include "scanfuse/io/ros/encode_results.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>

#include "scanfuse/io/ros/definitions.hpp"
#include "scanfuse/io/ros/wire_writer.hpp"

namespace scanfuse::io::ros {
namespace {

constexpr std::int32_t kCube = 1, kTextFacing = 9;
constexpr std::int32_t kAdd = 0, kDeleteAll = 3;

using Colour = std::array<float, 4>;

Colour colour_of(const Track& track) {
  static constexpr std::array<std::array<float, 3>, kObjectClasses> kColours{{
      {0.60F, 0.60F, 0.60F},  // unknown
      {0.34F, 0.71F, 0.91F},  // vehicle
      {0.90F, 0.62F, 0.00F},  // pedestrian
      {0.00F, 0.62F, 0.45F},  // cyclist
      {0.80F, 0.47F, 0.65F},  // other
  }};
  const auto& [r, g, b] = kColours[static_cast<std::size_t>(track.object_class)];
  return {r, g, b, track.status == TrackStatus::kCoasting ? 0.25F : 0.6F};
}

struct Marker {
  std::int32_t id = 0;
  std::int32_t type = 0;
  std::int32_t action = kAdd;
  Eigen::Vector3d position_m = Eigen::Vector3d::Zero();
  double heading_rad = 0;
  Eigen::Vector3d scale_m = Eigen::Vector3d::Ones();
  Colour colour{};
  std::string text;
};

void put_vector(CdrWriter& out, const Eigen::Vector3d& v) {
  for (const double value : v) out.write(value);
}

void put_header(CdrWriter& out, Time stamp, std::string_view frame) {
  out.write_time(stamp);
  out.write_string(frame);
}

void write_marker(CdrWriter& out, const Marker& marker, const StepResult& step) {
  put_header(out, step.stamp, step.coordinate_frame);
  out.write_string("tracks");
  out.write(marker.id);
  out.write(marker.type);
  out.write(marker.action);
  put_vector(out, marker.position_m);
  for (const double q :
       {0.0, 0.0, std::sin(marker.heading_rad / 2), std::cos(marker.heading_rad / 2)}) {
    out.write(q);
  }
  put_vector(out, marker.scale_m);
  for (const float part : marker.colour) out.write(part);
  out.write(std::int32_t{0});  // lifetime: until the next array
  out.write(std::uint32_t{0});
  out.write(std::uint8_t{0});   // frame_locked
  out.write(std::uint32_t{0});  // points
  out.write(std::uint32_t{0});  // colors
  out.write_string("");         // texture_resource
  put_header(out, Time{}, "");
  out.write_string("");         // texture.format
  out.write(std::uint32_t{0});  // texture.data
  out.write(std::uint32_t{0});  // uv_coordinates
  out.write_string(marker.text);
  out.write_string("");         // mesh_resource
  out.write_string("");         // mesh_file.filename
  out.write(std::uint32_t{0});  // mesh_file.data
  out.write(std::uint8_t{0});   // mesh_use_embedded_materials
}

double drawn_height(const Track& track) { return track.height_m > 0 ? track.height_m : 1.5; }

std::vector<Marker> markers_of(const StepResult& step) {
  std::vector<Marker> markers(1);
  markers.front().action = kDeleteAll;
  for (const Track& track : step.tracks) {
    if (track.status == TrackStatus::kTentative) continue;
    const double height = drawn_height(track);
    const Eigen::Vector3d centre(track.box.centre_m.x(), track.box.centre_m.y(), height / 2);
    const auto id = static_cast<std::int32_t>(2 * track.id);
    markers.push_back({id,
                       kCube,
                       kAdd,
                       centre,
                       track.box.heading_rad,
                       {track.box.length_m, track.box.width_m, height},
                       colour_of(track),
                       ""});
    markers.push_back({id + 1,
                       kTextFacing,
                       kAdd,
                       centre + Eigen::Vector3d(0, 0, height),
                       0,
                       {0, 0, 0.8},
                       {1, 1, 1, 1},
                       fmt::format("{} {}", track.id, to_string(track.object_class))});
  }
  return markers;
}

}  // namespace

EncodedMessage encode_markers(const StepResult& step) {
  const auto markers = markers_of(step);
  CdrWriter out;
  out.write(static_cast<std::uint32_t>(markers.size()));
  for (const Marker& marker : markers) write_marker(out, marker, step);
  const std::string type = "visualization_msgs/msg/MarkerArray";
  return {type, definition_of(type), out.take()};
}

EncodedMessage encode_diagnostics(Time stamp, const std::vector<DiagnosticStatus>& status) {
  CdrWriter out;
  put_header(out, stamp, "");
  out.write(static_cast<std::uint32_t>(status.size()));
  for (const auto& one : status) {
    out.write(static_cast<std::uint8_t>(one.level));
    out.write_string(one.name);
    out.write_string(one.message);
    out.write_string("");
    out.write(static_cast<std::uint32_t>(one.values.size()));
    for (const auto& [key, value] : one.values) {
      out.write_string(key);
      out.write_string(value);
    }
  }
  const std::string type = "diagnostic_msgs/msg/DiagnosticArray";
  return {type, definition_of(type), out.take()};
}

}  // namespace scanfuse::io::ros
