#include "scanfuse/io/mcap/result_messages.hpp"

#include <initializer_list>
#include <optional>

#include "scanfuse/io/mcap/json_text.hpp"

namespace scanfuse::io::mcap {
namespace {

std::string_view status_name(TrackStatus value) {
  for (const auto& [name, choice] : choices(value)) {
    if (choice == value) return name;
  }
  return "tentative";
}

void begin_message(JsonText& out, Time stamp, std::int64_t frame) {
  out.begin_object().stamp("stamp", stamp);
  out.field("time_s", to_seconds(stamp)).field("frame", frame);
}

void numbers(JsonText& out, std::string_view name, std::initializer_list<double> values) {
  out.key(name).begin_array();
  for (const double value : values) out.value(value);
  out.end_array();
}

template <class Matrix>
void matrix(JsonText& out, std::string_view name, const Matrix& values) {
  out.key(name).begin_array();
  for (int row = 0; row < values.rows(); ++row) {
    for (int column = 0; column < values.cols(); ++column) out.value(values(row, column));
  }
  out.end_array();
}

void pose(JsonText& out, std::string_view name, const Pose3& pose) {
  const auto& t = pose.translation_m;
  const auto& q = pose.rotation;
  numbers(out, name, {t.x(), t.y(), t.z(), q.x(), q.y(), q.z(), q.w()});
}

void track_object(JsonText& out, const Track& track) {
  const auto& P = track.state.covariance;
  out.begin_object();
  out.field("track_id", track.id).field("class", to_string(track.object_class));
  out.field("class_probability", track.class_probability);
  out.field("status", status_name(track.status));
  out.field("x_m", track.box.centre_m.x()).field("y_m", track.box.centre_m.y());
  out.field("z_m", track.z_m).field("heading_rad", track.box.heading_rad);
  out.field("vx_m_per_s", track.state.mean(1)).field("vy_m_per_s", track.state.mean(3));
  out.field("speed_m_per_s", track.speed_m_per_s);
  out.field("accel_m_per_s2", track.accel_m_per_s2);
  out.field("yaw_rate_rad_per_s", track.yaw_rate_rad_per_s);
  out.field("length_m", track.box.length_m).field("width_m", track.box.width_m);
  out.field("height_m", track.height_m);
  out.field("var_x_m2", P(0, 0)).field("cov_xy_m2", P(0, 2)).field("var_y_m2", P(2, 2));
  out.field("age_frames", track.age_frames).field("missed_frames", track.missed_frames);
  out.field("moving_probability", track.moving_probability);
  out.field("detection", track.detection).field("nis", track.nis);
  matrix(out, "state", track.state.mean);
  matrix(out, "state_covariance", P);
  out.end_object();
}

void detection_object(JsonText& out, const Detection& d) {
  const auto& P = d.covariance;
  out.begin_object();
  out.field("class", to_string(d.object_class)).field("score", d.score);
  out.field("x_m", d.box.centre_m.x()).field("y_m", d.box.centre_m.y()).field("z_m", d.z_m);
  out.field("heading_rad", d.box.heading_rad);
  out.field("length_m", d.box.length_m).field("width_m", d.box.width_m);
  out.field("height_m", d.height_m);
  out.field("var_x_m2", P(0, 0)).field("cov_xy_m2", P(0, 1)).field("var_y_m2", P(1, 1));
  out.field("cov_x_heading_m_rad", P(0, 2)).field("cov_y_heading_m_rad", P(1, 2));
  out.field("var_heading_rad2", P(2, 2));
  out.field("var_length_m2", d.var_length_m2).field("var_width_m2", d.var_width_m2);
  out.field("seen_from_x_m", d.seen_from_m.x()).field("seen_from_y_m", d.seen_from_m.y());
  out.field("visible_middle_x_m", d.visible_middle_m.x());
  out.field("visible_middle_y_m", d.visible_middle_m.y());
  out.field("length_seen", d.length_seen).field("width_seen", d.width_seen);
  out.field("faces_seen", d.faces_seen);
  out.field("left_end_occluded", d.left_end_occluded);
  out.field("right_end_occluded", d.right_end_occluded);
  out.field("points", d.points);
  out.end_object();
}

template <class T>
void optional_field(JsonText& out, std::string_view name, const std::optional<T>& value) {
  if (value) out.field(name, *value);
}

void truth_object(JsonText& out, const TruthObject& object) {
  out.begin_object();
  out.field("object_id", object.id).field("class", to_string(object.object_class));
  out.field("x_m", object.position_m.x()).field("y_m", object.position_m.y());
  out.field("z_m", object.z_m);
  optional_field(out, "heading_rad", object.heading_rad);
  if (object.velocity_m_per_s) {
    out.field("vx_m_per_s", object.velocity_m_per_s->x());
    out.field("vy_m_per_s", object.velocity_m_per_s->y());
  }
  optional_field(out, "length_m", object.length_m);
  optional_field(out, "width_m", object.width_m);
  optional_field(out, "height_m", object.height_m);
  optional_field(out, "visible_points", object.visible_points);
  optional_field(out, "occluded", object.occluded);
  out.end_object();
}

}  // namespace

std::string tracks_json(const StepResult& step) {
  JsonText out;
  begin_message(out, step.stamp, step.frame);
  out.field("sensor", step.sensor);
  pose(out, "world_from_ego", step.world_from_ego);
  pose(out, "ego_from_sensor", step.ego_from_sensor);
  out.key("tracks").begin_array();
  for (const auto& track : step.tracks) track_object(out, track);
  return out.end_array().end_object().text();
}

std::string detections_json(const StepResult& step) {
  JsonText out;
  begin_message(out, step.stamp, step.frame);
  out.field("sensor", step.sensor).key("detections").begin_array();
  for (const auto& detection : step.detections) detection_object(out, detection);
  return out.end_array().end_object().text();
}

std::string truth_json(const TruthFrame& truth) {
  JsonText out;
  begin_message(out, truth.stamp, truth.frame);
  out.field("coordinate_frame", truth.coordinate_frame).key("objects").begin_array();
  for (const auto& object : truth.objects) truth_object(out, object);
  return out.end_array().end_object().text();
}

std::string transform_json(Time stamp, std::string_view parent, std::string_view child,
                           const Pose3& parent_from_child) {
  const auto& t = parent_from_child.translation_m;
  const auto& q = parent_from_child.rotation;
  JsonText out;
  out.begin_object().stamp("timestamp", stamp);
  out.field("parent_frame_id", parent).field("child_frame_id", child);
  out.vector("translation", t.x(), t.y(), t.z());
  out.key("rotation").begin_object();
  out.field("x", q.x()).field("y", q.y()).field("z", q.z()).field("w", q.w()).end_object();
  return out.end_object().text();
}

}  // namespace scanfuse::io::mcap
