#include <fmt/format.h>

#include <cmath>
#include <span>

#include "scanfuse/report/page.hpp"

namespace scanfuse::report {
namespace {

std::string base64(std::span<const std::uint8_t> bytes) {
  static constexpr char kDigits[] =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const std::size_t left = bytes.size() - i;
    const unsigned group =
        bytes[i] << 16U | (left > 1 ? bytes[i + 1] << 8U : 0U) | (left > 2 ? bytes[i + 2] : 0U);
    text += kDigits[group >> 18U];
    text += kDigits[group >> 12U & 63U];
    text += left > 1 ? kDigits[group >> 6U & 63U] : '=';
    text += left > 2 ? kDigits[group & 63U] : '=';
  }
  return text;
}

std::string packed_points(const std::vector<std::int16_t>& values) {
  std::vector<std::uint8_t> bytes;
  bytes.reserve(2 * values.size());
  for (const std::int16_t value : values) {  // little endian, whatever this machine is
    const auto bits = static_cast<std::uint16_t>(value);
    bytes.push_back(static_cast<std::uint8_t>(bits & 0xffU));
    bytes.push_back(static_cast<std::uint8_t>(bits >> 8U));
  }
  return base64(bytes);
}

std::string fixed(double value, int digits = 2) {
  return std::isfinite(value) ? fmt::format("{:.{}f}", value, digits) : "null";
}

std::string box_data(const Box2& box) {
  return fmt::format("{},{},{},{},{}", fixed(box.centre_m.x()), fixed(box.centre_m.y()),
                     fixed(box.heading_rad, 3), fixed(box.length_m), fixed(box.width_m));
}

std::string track_data(const ReportedTrack& t) {
  const int hidden = (t.left_end_hidden ? 1 : 0) + (t.right_end_hidden ? 2 : 0);
  return fmt::format("[{},\"{}\",{},{},{},{},{},{},{},{},{},{}]", t.id, to_string(t.object_class),
                     static_cast<int>(t.status), box_data(t.box), fixed(t.velocity_m_per_s.x()),
                     fixed(t.velocity_m_per_s.y()), fixed(t.covariance_m2(0, 0), 4),
                     fixed(t.covariance_m2(0, 1), 4), fixed(t.covariance_m2(1, 1), 4),
                     t.measured ? fixed(t.measured_m.x()) : "null",
                     t.measured ? fixed(t.measured_m.y()) : "null", hidden);
}

std::string truth_data(const TruthObject& object, const Pose2& world_from) {
  const Box2 box{world_from * object.position_m,
                 wrap_pi(object.heading_rad.value_or(0) + world_from.heading_rad),
                 object.length_m.value_or(0.6), object.width_m.value_or(0.6)};
  return fmt::format("[{},\"{}\",{}]", object.id, to_string(object.object_class), box_data(box));
}

std::string frame_data(const ReportedFrame& frame, const TruthFrame* truth, double start_s) {
  std::string tracks, objects;
  for (const auto& track : frame.tracks) tracks += (tracks.empty() ? "" : ",") + track_data(track);
  if (truth != nullptr) {
    const Pose2 world_from = truth->coordinate_frame == "ego" ? frame.world_from_ego : Pose2{};
    for (const auto& object : truth->objects) {
      objects += (objects.empty() ? "" : ",") + truth_data(object, world_from);
    }
  }
  const Pose2& ego = frame.world_from_ego;
  return fmt::format(
      R"({{"f":{},"t":{},"e":[{},{},{}],"s":[{},{}],"p":"{}","c":"{}","k":[{}],"g":{}}})",
      frame.frame, fixed(to_seconds(frame.stamp) - start_s, 3), fixed(ego.x_m), fixed(ego.y_m),
      fixed(ego.heading_rad, 4), fixed(frame.sensor_m.x()), fixed(frame.sensor_m.y()),
      packed_points(frame.points_cm), base64(frame.point_group), tracks,
      truth != nullptr ? "[" + objects + "]" : "null");
}

}  // namespace

std::string track_report_data(const TrackReport& report) {
  std::string frames;
  const auto& kept = report.frames();
  const double start_s = kept.empty() ? 0 : to_seconds(kept.front().stamp);
  for (const auto& frame : kept) {
    const auto truth = report.truth().find(frame.frame);
    if (!frames.empty()) frames += ",\n";
    frames += frame_data(frame, truth == report.truth().end() ? nullptr : &truth->second, start_s);
  }
  return fmt::format("{{\"stride\":{},\"frames\":[{}]}}", report.frame_stride(), frames);
}

}  // namespace scanfuse::report
