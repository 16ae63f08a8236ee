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

void put_pose(CdrWriter& out, const Eigen::Vector3d& position_m, double heading_rad) {
  put_vector(out, position_m);
  for (const double q : {0.0, 0.0, std::sin(heading_rad / 2), std::cos(heading_rad / 2)}) {
    out.write(q);
  }
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
  put_pose(out, marker.position_m, marker.heading_rad);
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

Eigen::Vector3d centre_of(const Track& track) {
  return {track.box.centre_m.x(), track.box.centre_m.y(), drawn_height(track) / 2};
}

Eigen::Vector3d size_of(const Track& track) {
  return {track.box.length_m, track.box.width_m, drawn_height(track)};
}

/// Row by row over x, y, z and the turns about them.
void put_covariance(CdrWriter& out, const Gaussian<4>& state) {
  static constexpr std::array<int, 2> kPosition{0, 2};  // of x, vx, y, vy
  for (std::size_t row = 0; row < 6; ++row) {
    for (std::size_t column = 0; column < 6; ++column) {
      const bool known = row < 2 && column < 2;
      out.write(known ? state.covariance(kPosition[row], kPosition[column]) : 0.0);
    }
  }
}

std::vector<const Track*> shown_tracks(const StepResult& step) {
  std::vector<const Track*> shown;
  for (const Track& track : step.tracks) {
    if (track.status != TrackStatus::kTentative) shown.push_back(&track);
  }
  return shown;
}

std::vector<Marker> markers_of(const StepResult& step) {
  std::vector<Marker> markers(1);
  markers.front().action = kDeleteAll;
  for (const Track* shown : shown_tracks(step)) {
    const Track& track = *shown;
    const double height = drawn_height(track);
    const Eigen::Vector3d centre = centre_of(track);
    const auto id = static_cast<std::int32_t>(2 * track.id);
    markers.push_back(
        {id, kCube, kAdd, centre, track.box.heading_rad, size_of(track), colour_of(track), ""});
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

EncodedMessage encode_detections(const StepResult& step) {
  CdrWriter out;
  put_header(out, step.stamp, step.coordinate_frame);
  const auto shown = shown_tracks(step);
  out.write(static_cast<std::uint32_t>(shown.size()));
  for (const Track* track : shown) {
    put_header(out, step.stamp, step.coordinate_frame);
    out.write(std::uint32_t{1});
    out.write_string(to_string(track->object_class));
    out.write(track->class_probability);
    put_pose(out, centre_of(*track), track->box.heading_rad);
    put_covariance(out, track->state);
    put_pose(out, centre_of(*track), track->box.heading_rad);
    put_vector(out, size_of(*track));
    out.write_string(fmt::format("{}", track->id));
  }
  const std::string type = "vision_msgs/msg/Detection3DArray";
  return {type, definition_of(type), out.take()};
}

std::vector<TransformSample> track_transforms(const StepResult& step) {
  std::vector<TransformSample> edges;
  for (const Track* track : shown_tracks(step)) {
    const Eigen::Quaterniond turn(
        Eigen::AngleAxisd(track->box.heading_rad, Eigen::Vector3d::UnitZ()));
    edges.push_back({step.stamp,
                     step.coordinate_frame,
                     fmt::format("track_{}", track->id),
                     {turn, centre_of(*track)},
                     false});
  }
  return edges;
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
