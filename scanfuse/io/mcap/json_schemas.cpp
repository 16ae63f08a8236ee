#include <string>

#include "scanfuse/io/mcap/result_messages.hpp"

namespace scanfuse::io::mcap {
namespace {

// Only what is written is described; a reader may meet more members later.

#define SCANFUSE_JSON_TIME                                                     \
  R"({"type":"object","properties":{"sec":{"type":"integer"},"nsec":{"type":)" \
  R"("integer","minimum":0,"maximum":999999999}},"required":["sec","nsec"]})"
#define SCANFUSE_JSON_VECTOR                                                      \
  R"({"type":"object","properties":{"x":{"type":"number"},"y":{"type":"number"})" \
  R"(,"z":{"type":"number"}}})"
#define SCANFUSE_JSON_QUATERNION                                                  \
  R"({"type":"object","properties":{"x":{"type":"number"},"y":{"type":"number"})" \
  R"(,"z":{"type":"number"},"w":{"type":"number"}}})"
#define SCANFUSE_JSON_POSE                                             \
  R"({"type":"object","properties":{"position":)" SCANFUSE_JSON_VECTOR \
  R"(,"orientation":)" SCANFUSE_JSON_QUATERNION "}}"
#define SCANFUSE_JSON_COLOR                                                       \
  R"({"type":"object","properties":{"r":{"type":"number"},"g":{"type":"number"})" \
  R"(,"b":{"type":"number"},"a":{"type":"number"}}})"
#define SCANFUSE_JSON_EMPTY R"({"type":"array","items":{"type":"object"}})"

constexpr std::string_view kTracksSchema =
    R"({"title":"scanfuse.Tracks","description":"The tracks after one scan, in the output frame",)"
    R"("type":"object","properties":{"stamp":)" SCANFUSE_JSON_TIME
    R"(,"time_s":{"type":"number"},"frame":{"type":"integer"},"sensor":{"type":"string"},)"
    R"("world_from_ego":{"type":"array","items":{"type":"number"},)"
    R"("description":"x, y, z, qx, qy, qz, qw"},)"
    R"("ego_from_sensor":{"type":"array","items":{"type":"number"},)"
    R"("description":"x, y, z, qx, qy, qz, qw"},)"
    R"("tracks":{"type":"array","items":{"type":"object","properties":{)"
    R"("track_id":{"type":"integer"},"class":{"type":"string"},)"
    R"("class_probability":{"type":"number"},)"
    R"("status":{"type":"string","enum":["tentative","confirmed","coasting"]},)"
    R"("x_m":{"type":"number"},"y_m":{"type":"number"},"z_m":{"type":"number"},)"
    R"("heading_rad":{"type":"number"},"vx_m_per_s":{"type":"number"},)"
    R"("vy_m_per_s":{"type":"number"},"speed_m_per_s":{"type":"number"},)"
    R"("accel_m_per_s2":{"type":"number"},"yaw_rate_rad_per_s":{"type":"number"},)"
    R"("length_m":{"type":"number"},"width_m":{"type":"number"},"height_m":{"type":"number"},)"
    R"("var_x_m2":{"type":"number"},"cov_xy_m2":{"type":"number"},"var_y_m2":{"type":"number"},)"
    R"("age_frames":{"type":"integer"},"missed_frames":{"type":"integer"},)"
    R"("moving_probability":{"type":"number"},)"
    R"("detection":{"type":"integer","description":"index of the detection used, -1: none"},)"
    R"("nis":{"type":"number"},)"
    R"("state":{"type":"array","items":{"type":"number"},"description":"x, vx, y, vy"},)"
    R"("state_covariance":{"type":"array","items":{"type":"number"},)"
    R"("description":"of x, vx, y, vy, row by row"}}}}}})";

constexpr std::string_view kDetectionsSchema =
    R"({"title":"scanfuse.Detections","description":"The detections of one scan, output frame",)"
    R"("type":"object","properties":{"stamp":)" SCANFUSE_JSON_TIME
    R"(,"time_s":{"type":"number"},"frame":{"type":"integer"},"sensor":{"type":"string"},)"
    R"("detections":{"type":"array","items":{"type":"object","properties":{)"
    R"("class":{"type":"string"},"score":{"type":"number"},"x_m":{"type":"number"},)"
    R"("y_m":{"type":"number"},"z_m":{"type":"number"},"heading_rad":{"type":"number"},)"
    R"("length_m":{"type":"number"},"width_m":{"type":"number"},"height_m":{"type":"number"},)"
    R"("var_x_m2":{"type":"number"},"cov_xy_m2":{"type":"number"},"var_y_m2":{"type":"number"},)"
    R"("cov_x_heading_m_rad":{"type":"number"},"cov_y_heading_m_rad":{"type":"number"},)"
    R"("var_heading_rad2":{"type":"number"},"var_length_m2":{"type":"number"},)"
    R"("var_width_m2":{"type":"number"},"seen_from_x_m":{"type":"number"},)"
    R"("seen_from_y_m":{"type":"number"},"visible_middle_x_m":{"type":"number"},)"
    R"("visible_middle_y_m":{"type":"number"},"length_seen":{"type":"boolean"},)"
    R"("width_seen":{"type":"boolean"},"faces_seen":{"type":"integer"},)"
    R"("left_end_occluded":{"type":"boolean"},"right_end_occluded":{"type":"boolean"},)"
    R"("points":{"type":"integer"}}}}}})";

constexpr std::string_view kTruthSchema =
    R"({"title":"scanfuse.Truth","description":"Where the objects really were",)"
    R"("type":"object","properties":{"stamp":)" SCANFUSE_JSON_TIME
    R"(,"time_s":{"type":"number"},"frame":{"type":"integer"},)"
    R"("coordinate_frame":{"type":"string","enum":["world","ego"]},)"
    R"("objects":{"type":"array","items":{"type":"object","properties":{)"
    R"("object_id":{"type":"integer"},"class":{"type":"string"},"x_m":{"type":"number"},)"
    R"("y_m":{"type":"number"},"z_m":{"type":"number"},"heading_rad":{"type":"number"},)"
    R"("vx_m_per_s":{"type":"number"},"vy_m_per_s":{"type":"number"},)"
    R"("length_m":{"type":"number"},"width_m":{"type":"number"},"height_m":{"type":"number"},)"
    R"("visible_points":{"type":"integer"},"occluded":{"type":"number"}},)"
    R"("required":["object_id","class","x_m","y_m"]}}}})";

constexpr std::string_view kFrameTransformSchema =
    R"({"title":"foxglove.FrameTransform","type":"object","properties":{"timestamp":)" SCANFUSE_JSON_TIME
    R"(,"parent_frame_id":{"type":"string"},"child_frame_id":{"type":"string"},"translation":)" SCANFUSE_JSON_VECTOR
    R"(,"rotation":)" SCANFUSE_JSON_QUATERNION "}}";

constexpr std::string_view kSceneUpdateSchema =
    R"({"title":"foxglove.SceneUpdate","type":"object","properties":{"deletions":{"type":"array",)"
    R"("items":{"type":"object","properties":{"timestamp":)" SCANFUSE_JSON_TIME
    R"(,"type":{"type":"integer"},"id":{"type":"string"}}}},"entities":{"type":"array","items":{)"
    R"("type":"object","properties":{"timestamp":)" SCANFUSE_JSON_TIME
    R"(,"frame_id":{"type":"string"},"id":{"type":"string"},"lifetime":)" SCANFUSE_JSON_TIME
    R"(,"frame_locked":{"type":"boolean"},"metadata":{"type":"array","items":{"type":"object",)"
    R"("properties":{"key":{"type":"string"},"value":{"type":"string"}}}},"arrows":)" SCANFUSE_JSON_EMPTY
    R"(,"cubes":{"type":"array","items":{"type":"object","properties":{"pose":)" SCANFUSE_JSON_POSE
    R"(,"size":)" SCANFUSE_JSON_VECTOR R"(,"color":)" SCANFUSE_JSON_COLOR
    R"(}}},"spheres":)" SCANFUSE_JSON_EMPTY R"(,"cylinders":)" SCANFUSE_JSON_EMPTY
    R"(,"lines":{"type":"array","items":{"type":"object","properties":{"type":{"type":"integer"},)"
    R"("pose":)" SCANFUSE_JSON_POSE
    R"(,"thickness":{"type":"number"},"scale_invariant":{"type":"boolean"},"points":{"type":)"
    R"("array","items":)" SCANFUSE_JSON_VECTOR R"(},"color":)" SCANFUSE_JSON_COLOR
    R"(,"colors":{"type":"array","items":)" SCANFUSE_JSON_COLOR
    R"(},"indices":{"type":"array","items":{"type":"integer"}}}}},"triangles":)" SCANFUSE_JSON_EMPTY
    R"(,"texts":{"type":"array","items":{"type":"object","properties":{"pose":)" SCANFUSE_JSON_POSE
    R"(,"billboard":{"type":"boolean"},"font_size":{"type":"number"},"scale_invariant":)"
    R"({"type":"boolean"},"color":)" SCANFUSE_JSON_COLOR
    R"(,"text":{"type":"string"}}}},"models":)" SCANFUSE_JSON_EMPTY "}}}}}";

#undef SCANFUSE_JSON_TIME
#undef SCANFUSE_JSON_VECTOR
#undef SCANFUSE_JSON_QUATERNION
#undef SCANFUSE_JSON_POSE
#undef SCANFUSE_JSON_COLOR
#undef SCANFUSE_JSON_EMPTY

}  // namespace

std::string_view json_schema(std::string_view name) {
  if (name == "scanfuse.Tracks") return kTracksSchema;
  if (name == "scanfuse.Detections") return kDetectionsSchema;
  if (name == "scanfuse.Truth") return kTruthSchema;
  if (name == "foxglove.FrameTransform") return kFrameTransformSchema;
  if (name == "foxglove.SceneUpdate") return kSceneUpdateSchema;
  return {};
}

}  // namespace scanfuse::io::mcap
