#include "scanfuse/serve/messages.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "scanfuse/serve/wire.hpp"

namespace scanfuse::serve {
namespace {

constexpr std::size_t kTruthCountAt = 32;

float rounded(double metres) { return static_cast<float>(std::round(metres * 1024) / 1024); }

void put_pose(WireWriter& out, const Pose3& pose, const Eigen::Vector3d& origin_m) {
  const Eigen::Vector3d t = pose.translation_m - origin_m;
  out.f32(t.x()).f32(t.y()).f32(t.z()).f32(pose.planar().heading_rad);
}

/// Lowest and highest, for colours; the same scale is told to the page.
std::pair<float, float> intensity_range(std::span<const ShownPoint> points) {
  float low = std::numeric_limits<float>::max(), high = std::numeric_limits<float>::lowest();
  for (const auto& point : points) {
    low = std::min(low, point.intensity);
    high = std::max(high, point.intensity);
  }
  return points.empty() ? std::pair{0.0F, 0.0F} : std::pair{low, high};
}

void put_points(WireWriter& out, std::span<const ShownPoint> points, std::pair<float, float> range,
                const Eigen::Vector3d& origin_m) {
  for (const auto& point : points) {
    const Eigen::Vector3d p = point.position_m - origin_m;
    out.put(rounded(p.x())).put(rounded(p.y())).put(rounded(p.z()));
  }
  for (const auto& point : points) out.put(point.cluster);
  out.align(4);
  for (const auto& point : points) out.put(point.layer);
  out.align(4);
  const float spread = range.second - range.first;
  for (const auto& point : points) {
    const float share = spread > 0 ? (point.intensity - range.first) / spread : 0;
    out.put(static_cast<std::uint8_t>(255 * share));
  }
  out.align(4);
}

void put_box(WireWriter& out, const Box2& box, double z_m, double height_m,
             const Eigen::Vector3d& origin_m) {
  out.f32(box.centre_m.x() - origin_m.x()).f32(box.centre_m.y() - origin_m.y());
  out.f32(z_m - origin_m.z()).f32(box.heading_rad);
  out.f32(box.length_m).f32(box.width_m).f32(height_m);
}

void put_detection(WireWriter& out, const Detection& d, const Eigen::Vector3d& origin_m) {
  put_box(out, d.box, d.z_m, d.height_m, origin_m);
  out.f32(d.covariance(0, 0)).f32(d.covariance(0, 1)).f32(d.covariance(1, 1)).f32(d.score);
  out.u32(static_cast<std::uint32_t>(d.object_class) |
          static_cast<std::uint32_t>(std::clamp(d.points, 0, 0xffffff)) << 8U);
}

void put_track(WireWriter& out, const Track& t, const Eigen::Vector3d& origin_m) {
  const auto& P = t.state.covariance;
  out.f64(static_cast<double>(t.id));
  put_box(out, t.box, t.z_m, t.height_m, origin_m);
  out.f32(t.state.mean(1)).f32(t.state.mean(3));
  out.f32(P(0, 0)).f32(P(0, 2)).f32(P(2, 2));
  out.f32(t.speed_m_per_s).f32(t.accel_m_per_s2).f32(t.yaw_rate_rad_per_s);
  out.f32(t.class_probability).f32(t.moving_probability).f32(t.nis);
  out.put(static_cast<std::int32_t>(t.detection));
  out.u32(static_cast<std::uint32_t>(std::max(t.age_frames, 0)));
  out.u32(static_cast<std::uint32_t>(std::max(t.missed_frames, 0)));
  out.u32(static_cast<std::uint32_t>(t.object_class) | static_cast<std::uint32_t>(t.status) << 8U);
}

void put_line(WireWriter& out, const ShownLine& line, const Eigen::Vector3d& origin_m) {
  for (const auto& p : {line.first_m, line.last_m}) {
    out.f32(p.x() - origin_m.x()).f32(p.y() - origin_m.y());
  }
  out.u32(line.cluster);
}

void put_ends(WireWriter& out, const Eigen::Vector3d& from_m, const Eigen::Vector3d& to_m,
              const Eigen::Vector3d& origin_m) {
  for (const auto& p : {from_m, to_m}) {
    out.f32(p.x() - origin_m.x()).f32(p.y() - origin_m.y()).f32(p.z() - origin_m.z());
  }
}

}  // namespace

std::string frame_message(const ShownFrame& shown, RunName run, std::uint32_t frame, double time_s,
                          const Eigen::Vector3d& origin_m) {
  const StepResult& step = shown.step;
  WireWriter out(256 + 16 * shown.points.size() + 96 * step.tracks.size());
  out.u32(static_cast<std::uint32_t>(MessageKind::kFrame)).u32(static_cast<std::uint32_t>(run));
  out.u32(frame).u32(shown.points.size()).u32(shown.detection_of_cluster.size());
  out.u32(shown.lines.size()).u32(step.detections.size()).u32(step.tracks.size());
  out.u32(0).u32(shown.rays.size());
  out.f64(time_s).f64(static_cast<double>(step.frame));
  put_pose(out, step.world_from_ego * step.ego_from_sensor, origin_m);
  put_pose(out, step.world_from_ego, origin_m);
  const auto range = intensity_range(shown.points);
  out.put(range.first).put(range.second).u32(shown.sensor).u32(shown.edges.size());
  put_points(out, shown.points, range, origin_m);
  for (const auto detection : shown.detection_of_cluster) out.put(detection);
  for (const auto& line : shown.lines) put_line(out, line, origin_m);
  for (const auto& detection : step.detections) put_detection(out, detection, origin_m);
  for (const auto& track : step.tracks) put_track(out, track, origin_m);
  for (const auto& ray : shown.rays) {
    put_ends(out, ray.from_m, ray.to_m, origin_m);
    out.u32(ray.sensor).put(ray.target);
  }
  for (const auto& edge : shown.edges) {
    put_ends(out, edge.from_m, edge.to_m, origin_m);
    out.u32(static_cast<std::uint32_t>(edge.part));
  }
  return out.take();
}

void append_truth(std::string& message, std::span<const TruthObject> truth,
                  const Eigen::Vector3d& origin_m) {
  WireWriter out;
  for (const auto& object : truth) {
    out.f64(static_cast<double>(object.id));
    const Box2 box{object.position_m, object.heading_rad.value_or(0), object.length_m.value_or(0.5),
                   object.width_m.value_or(0.5)};
    put_box(out, box, object.z_m, object.height_m.value_or(0), origin_m);
    out.u32(static_cast<std::uint32_t>(object.object_class));
  }
  const auto count = static_cast<std::uint32_t>(truth.size());
  std::memcpy(message.data() + kTruthCountAt, &count, sizeof(count));
  message += out.take();
}

std::string index_message(RunName run, std::uint32_t from, std::span<const double> times_s) {
  WireWriter out(16 + 8 * times_s.size());
  out.u32(static_cast<std::uint32_t>(MessageKind::kIndex)).u32(static_cast<std::uint32_t>(run));
  out.u32(from).u32(times_s.size());
  for (const double time : times_s) out.f64(time);
  return out.take();
}

std::string events_message(RunName run, std::uint32_t from, std::span<const Event> events) {
  WireWriter out(16 + 16 * events.size());
  out.u32(static_cast<std::uint32_t>(MessageKind::kEvents)).u32(static_cast<std::uint32_t>(run));
  out.u32(from).u32(events.size());
  for (const auto& event : events) {
    out.f64(static_cast<double>(event.track)).u32(event.frame);
    out.u32(static_cast<std::uint32_t>(event.kind));
  }
  return out.take();
}

std::string history_message(RunName run, std::int64_t track, std::span<const HistorySample> samples,
                            const Eigen::Vector3d& origin_m) {
  WireWriter out(24 + 112 * samples.size());
  out.u32(static_cast<std::uint32_t>(MessageKind::kHistory)).u32(static_cast<std::uint32_t>(run));
  out.u32(samples.size()).u32(0).f64(static_cast<double>(track));
  for (const auto& sample : samples) {
    out.f64(sample.time_s).u32(sample.frame).u32(0);
    put_track(out, sample.track, origin_m);
  }
  return out.take();
}

std::string trails_message(RunName run, std::span<const TrailStep> steps,
                           const Eigen::Vector3d& origin_m) {
  WireWriter out;
  out.u32(static_cast<std::uint32_t>(MessageKind::kTrails)).u32(static_cast<std::uint32_t>(run));
  std::uint32_t count = 0;
  out.u32(0);
  for (const auto& step : steps) {
    for (const auto& track : step.tracks) {
      ++count;
      out.u32(step.frame).f64(static_cast<double>(track.id));
      out.f32(track.box.centre_m.x() - origin_m.x()).f32(track.box.centre_m.y() - origin_m.y());
    }
  }
  out.patch(8, count);
  return out.take();
}

}  // namespace scanfuse::serve
