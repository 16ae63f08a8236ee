#include "scanfuse/io/mcap/scene.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "scanfuse/io/mcap/json_text.hpp"

namespace scanfuse::io::mcap {
namespace {

constexpr double kDefaultHeight = 1.5;  ///< m, drawn where the height is not known

struct SceneColor {
  double r, g, b;
};

/// Told apart by the colour-blind too (orange, sky blue, green, purple, grey).
SceneColor color_of(ObjectClass object_class) {
  switch (object_class) {
    case ObjectClass::kVehicle:
      return {0.90, 0.62, 0.0};
    case ObjectClass::kPedestrian:
      return {0.34, 0.71, 0.91};
    case ObjectClass::kCyclist:
      return {0.0, 0.62, 0.45};
    case ObjectClass::kOther:
      return {0.80, 0.47, 0.65};
    case ObjectClass::kUnknown:
      break;
  }
  return {0.6, 0.6, 0.6};
}

bool can_be_drawn(const Track& track) {
  return track.box.centre_m.allFinite() && std::isfinite(track.box.heading_rad) &&
         std::isfinite(track.box.length_m) && std::isfinite(track.box.width_m) &&
         std::isfinite(track.z_m) && std::isfinite(track.height_m) &&
         std::isfinite(track.speed_m_per_s);
}

void color(JsonText& out, const Track& track, double alpha) {
  const SceneColor c = color_of(track.object_class);
  out.key("color").begin_object();
  out.field("r", c.r).field("g", c.g).field("b", c.b).field("a", alpha).end_object();
}

void scene_pose(JsonText& out, double x, double y, double z, double heading_rad) {
  out.key("pose").begin_object().vector("position", x, y, z);
  out.key("orientation").begin_object().field("x", 0.0).field("y", 0.0);
  out.field("z", std::sin(heading_rad / 2)).field("w", std::cos(heading_rad / 2));
  out.end_object().end_object();
}

void empty_list(JsonText& out, std::string_view name) { out.key(name).begin_array().end_array(); }

double height_of(const Track& track) {
  return track.height_m > 0 ? track.height_m : kDefaultHeight;
}

void cube(JsonText& out, const Track& track) {
  const auto& box = track.box;
  out.key("cubes").begin_array().begin_object();
  scene_pose(out, box.centre_m.x(), box.centre_m.y(), track.z_m, box.heading_rad);
  out.vector("size", box.length_m, box.width_m, height_of(track));
  color(out, track, track.status == TrackStatus::kConfirmed ? 0.6 : 0.25);
  out.end_object().end_array();
}

void trail(JsonText& out, const Track& track, const std::deque<Eigen::Vector3d>& points) {
  out.key("lines").begin_array().begin_object().field("type", 0);
  scene_pose(out, 0, 0, 0, 0);
  out.field("thickness", 2).field("scale_invariant", true).key("points").begin_array();
  for (const auto& p : points) {
    out.begin_object().field("x", p.x()).field("y", p.y()).field("z", p.z()).end_object();
  }
  out.end_array();
  color(out, track, 0.9);
  empty_list(out, "colors");
  empty_list(out, "indices");
  out.end_object().end_array();
}

void label(JsonText& out, const Track& track) {
  out.key("texts").begin_array().begin_object();
  scene_pose(out, track.box.centre_m.x(), track.box.centre_m.y(),
             track.z_m + height_of(track) / 2 + 0.5, 0);
  out.field("billboard", true).field("font_size", 12).field("scale_invariant", true);
  color(out, track, 1);
  out.field("text", fmt::format("{} {}  {:.1f} m/s", to_string(track.object_class), track.id,
                                track.speed_m_per_s));
  out.end_object().end_array();
}

std::string entity_id(std::int64_t track_id) { return fmt::format("track-{}", track_id); }

void entity(JsonText& out, const StepResult& step, const Track& track, const std::string& frame_id,
            const std::deque<Eigen::Vector3d>& points) {
  out.begin_object().stamp("timestamp", step.stamp).field("frame_id", frame_id);
  out.field("id", entity_id(track.id));
  out.key("lifetime").begin_object().field("sec", 0).field("nsec", 0).end_object();
  out.field("frame_locked", false);
  for (const char* none : {"metadata", "arrows", "spheres", "cylinders", "triangles", "models"}) {
    empty_list(out, none);
  }
  cube(out, track);
  trail(out, track, points);
  label(out, track);
  out.end_object();
}

}  // namespace

std::string SceneBuilder::update(const StepResult& step) {
  std::set<std::int64_t> shown;
  for (const auto& track : step.tracks) {
    if (!can_be_drawn(track)) continue;
    shown.insert(track.id);
    auto& points = trails_[track.id];
    points.emplace_back(track.box.centre_m.x(), track.box.centre_m.y(), track.z_m);
    if (points.size() > kTrailPoints) points.pop_front();
  }
  JsonText out;
  out.begin_object().key("deletions").begin_array();
  for (const auto& [id, points] : trails_) {
    if (shown.contains(id)) continue;
    out.begin_object().stamp("timestamp", step.stamp).field("type", 0);
    out.field("id", entity_id(id)).end_object();
  }
  std::erase_if(trails_, [&](const auto& entry) { return !shown.contains(entry.first); });
  out.end_array().key("entities").begin_array();
  for (const auto& track : step.tracks) {
    if (can_be_drawn(track)) entity(out, step, track, frame_id_, trails_.at(track.id));
  }
  return out.end_array().end_object().text();
}

}  // namespace scanfuse::io::mcap
