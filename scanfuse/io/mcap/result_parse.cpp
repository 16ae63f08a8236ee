#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "scanfuse/io/mcap/result_messages.hpp"

namespace scanfuse::io::mcap {
namespace {

using JsonValue = nlohmann::json;

/// Takes typed members out of a JSON object; remembers the first that is missing or of a wrong
/// kind.
class JsonMembers {
 public:
  explicit JsonMembers(const JsonValue& object) : object_(object) {
    if (!object.is_object()) wrong_ = "object expected";
  }

  [[nodiscard]] const std::string& wrong() const { return wrong_; }

  [[nodiscard]] std::optional<double> maybe_number(const char* name) {
    const JsonValue* member = find(name);
    if (member == nullptr || member->is_null()) return std::nullopt;
    if (!member->is_number()) return miss(name), std::nullopt;
    const double value = member->get<double>();
    if (!std::isfinite(value)) return miss(name), std::nullopt;
    return value;
  }
  [[nodiscard]] double number(const char* name) {
    const auto value = maybe_number(name);
    if (!value) miss(name);
    return value.value_or(0);
  }
  /// A member that may be absent or null: then `otherwise`.
  [[nodiscard]] double number_or(const char* name, double otherwise) {
    return maybe_number(name).value_or(otherwise);
  }
  [[nodiscard]] std::int64_t whole(const char* name) {
    const JsonValue* member = find(name);
    if (member == nullptr || !member->is_number_integer() ||
        (member->is_number_unsigned() &&
         member->get<std::uint64_t>() > std::numeric_limits<std::int64_t>::max())) {
      return miss(name), 0;
    }
    return member->get<std::int64_t>();
  }
  [[nodiscard]] int count(const char* name) {
    const auto value = whole(name);
    if (value < std::numeric_limits<int>::min() || value > std::numeric_limits<int>::max()) {
      return miss(name), 0;
    }
    return static_cast<int>(value);
  }
  [[nodiscard]] bool flag(const char* name) {
    const JsonValue* member = find(name);
    if (member == nullptr || !member->is_boolean()) return miss(name), false;
    return member->get<bool>();
  }
  [[nodiscard]] std::string text(const char* name) {
    const JsonValue* member = find(name);
    if (member == nullptr || !member->is_string()) return miss(name), std::string();
    return member->get<std::string>();
  }
  [[nodiscard]] ObjectClass object_class(const char* name) {
    return object_class_from(text(name)).value_or(ObjectClass::kUnknown);
  }
  [[nodiscard]] Time stamp(const char* name) {
    static const JsonValue kNone;
    const JsonValue* member = find(name);
    JsonMembers parts(member == nullptr ? kNone : *member);
    const std::int64_t seconds = parts.whole("sec"), nanos = parts.whole("nsec");
    constexpr std::int64_t kMostSeconds = 9'000'000'000;
    if (!parts.wrong().empty() || seconds > kMostSeconds || seconds < -kMostSeconds || nanos < 0 ||
        nanos > 999'999'999) {
      miss(name);
      return {};
    }
    return time_from_nanos(seconds * 1'000'000'000 + nanos);
  }
  /// `size` numbers; empty when there are not that many.
  [[nodiscard]] std::vector<double> numbers(const char* name, std::size_t size) {
    const JsonValue* member = find(name);
    std::vector<double> values;
    if (member != nullptr && member->is_array() && member->size() == size) {
      for (const auto& value : *member) {
        if (value.is_number()) values.push_back(value.get<double>());
      }
    }
    if (values.size() != size) values.assign(size, 0), miss(name);
    return values;
  }
  [[nodiscard]] const JsonValue& list(const char* name) {
    static const JsonValue kEmpty = JsonValue::array();
    const JsonValue* member = find(name);
    if (member == nullptr || !member->is_array()) return miss(name), kEmpty;
    return *member;
  }
  void miss(const char* name) {
    if (wrong_.empty()) wrong_ = fmt::format("'{}' is missing or of a wrong kind", name);
  }
  void adopt(const std::string& wrong) {
    if (wrong_.empty()) wrong_ = wrong;
  }

 private:
  [[nodiscard]] const JsonValue* find(const char* name) const {
    if (!object_.is_object()) return nullptr;
    const auto found = object_.find(name);
    return found == object_.end() ? nullptr : &*found;
  }
  const JsonValue& object_;
  std::string wrong_;
};

JsonValue parse_text(std::span<const std::byte> bytes) {
  const auto* begin = reinterpret_cast<const char*>(bytes.data());
  return JsonValue::parse(begin, begin + bytes.size(), nullptr, false);
}

Pose3 pose_of(const std::vector<double>& v) {
  Pose3 pose;
  pose.translation_m = {v[0], v[1], v[2]};
  const Eigen::Quaterniond rotation(v[6], v[3], v[4], v[5]);
  if (rotation.norm() > 1e-9) pose.rotation = rotation.normalized();
  return pose;
}

Track parse_track(JsonMembers& in) {
  Track track;
  track.id = in.whole("track_id");
  track.object_class = in.object_class("class");
  track.class_probability = in.number_or("class_probability", 0);
  const std::string status = in.text("status");
  for (const auto& [name, value] : choices(TrackStatus{})) {
    if (status == name) track.status = value;
  }
  track.box.centre_m = {in.number("x_m"), in.number("y_m")};
  track.box.heading_rad = in.number("heading_rad");
  track.box.length_m = in.number("length_m");
  track.box.width_m = in.number("width_m");
  track.z_m = in.number_or("z_m", 0);
  track.height_m = in.number_or("height_m", 0);
  track.speed_m_per_s = in.number_or("speed_m_per_s", 0);
  track.accel_m_per_s2 = in.number_or("accel_m_per_s2", 0);
  track.yaw_rate_rad_per_s = in.number_or("yaw_rate_rad_per_s", 0);
  track.age_frames = in.count("age_frames");
  track.missed_frames = in.count("missed_frames");
  track.moving_probability = in.number_or("moving_probability", 0.5);
  track.detection = in.count("detection");
  track.nis = in.number_or("nis", 0);
  const auto state = in.numbers("state", 4);
  const auto covariance = in.numbers("state_covariance", 16);
  track.state.mean = Eigen::Map<const Eigen::Vector4d>(state.data());
  track.state.covariance =
      Eigen::Map<const Eigen::Matrix<double, 4, 4, Eigen::RowMajor>>(covariance.data());
  return track;
}

Detection parse_detection(JsonMembers& in) {
  Detection d;
  d.object_class = in.object_class("class");
  d.score = in.number_or("score", 1);
  d.box.centre_m = {in.number("x_m"), in.number("y_m")};
  d.box.heading_rad = in.number("heading_rad");
  d.box.length_m = in.number("length_m");
  d.box.width_m = in.number("width_m");
  d.z_m = in.number_or("z_m", 0);
  d.height_m = in.number_or("height_m", 0);
  const double xx = in.number("var_x_m2"), xy = in.number("cov_xy_m2");
  const double yy = in.number("var_y_m2"), xh = in.number("cov_x_heading_m_rad");
  const double yh = in.number("cov_y_heading_m_rad"), hh = in.number("var_heading_rad2");
  d.covariance << xx, xy, xh, xy, yy, yh, xh, yh, hh;
  d.var_length_m2 = in.number_or("var_length_m2", 1);
  d.var_width_m2 = in.number_or("var_width_m2", 1);
  d.seen_from_m = {in.number_or("seen_from_x_m", 0), in.number_or("seen_from_y_m", 0)};
  d.visible_middle_m = {in.number("visible_middle_x_m"), in.number("visible_middle_y_m")};
  d.length_seen = in.flag("length_seen");
  d.width_seen = in.flag("width_seen");
  d.faces_seen = in.count("faces_seen");
  d.left_end_occluded = in.flag("left_end_occluded");
  d.right_end_occluded = in.flag("right_end_occluded");
  d.points = in.count("points");
  return d;
}

TruthObject parse_truth_object(JsonMembers& in) {
  TruthObject object;
  object.id = in.whole("object_id");
  object.object_class = in.object_class("class");
  object.position_m = {in.number("x_m"), in.number("y_m")};
  object.z_m = in.number_or("z_m", 0);
  object.heading_rad = in.maybe_number("heading_rad");
  const auto vx = in.maybe_number("vx_m_per_s"), vy = in.maybe_number("vy_m_per_s");
  if (vx && vy) object.velocity_m_per_s = Eigen::Vector2d(*vx, *vy);
  object.length_m = in.maybe_number("length_m");
  object.width_m = in.maybe_number("width_m");
  object.height_m = in.maybe_number("height_m");
  object.occluded = in.maybe_number("occluded");
  if (in.maybe_number("visible_points")) object.visible_points = in.count("visible_points");
  return object;
}

/// Parses every element of the list; what is wrong in one is wrong with the message.
template <class Parse>
auto parse_list(JsonMembers& in, const char* name, Parse parse) {
  std::vector<decltype(parse(in))> items;
  for (const auto& element : in.list(name)) {
    JsonMembers members(element);
    items.push_back(parse(members));
    in.adopt(members.wrong());
  }
  return items;
}

tl::unexpected<Error> bad_message(const char* schema, const JsonMembers& in) {
  return fail(Error::Code::kMalformed, "{} message: {}", schema, in.wrong());
}

}  // namespace

Result<StepResult> tracks_from_json(std::span<const std::byte> bytes) {
  const JsonValue text = parse_text(bytes);
  JsonMembers in(text);
  StepResult step;
  step.stamp = in.stamp("stamp");
  step.frame = in.whole("frame");
  step.sensor = in.text("sensor");
  step.world_from_ego = pose_of(in.numbers("world_from_ego", 7));
  step.ego_from_sensor = pose_of(in.numbers("ego_from_sensor", 7));
  step.tracks = parse_list(in, "tracks", parse_track);
  if (!in.wrong().empty()) return bad_message("scanfuse.Tracks", in);
  return step;
}

Result<std::vector<Detection>> detections_from_json(std::span<const std::byte> bytes) {
  const JsonValue text = parse_text(bytes);
  JsonMembers in(text);
  auto detections = parse_list(in, "detections", parse_detection);
  if (!in.wrong().empty()) return bad_message("scanfuse.Detections", in);
  return detections;
}

Result<TruthFrame> truth_from_json(std::span<const std::byte> bytes) {
  const JsonValue text = parse_text(bytes);
  JsonMembers in(text);
  TruthFrame truth;
  truth.stamp = in.stamp("stamp");
  truth.frame = in.whole("frame");
  truth.coordinate_frame = in.text("coordinate_frame");
  truth.objects = parse_list(in, "objects", parse_truth_object);
  if (!in.wrong().empty()) return bad_message("scanfuse.Truth", in);
  return truth;
}

}  // namespace scanfuse::io::mcap
