#include "scanfuse/serve/shown_frame.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace scanfuse::serve {
namespace {

constexpr float kSameSurfaceM = 0.5F;

/// Which point of the virtual scan stands for a bearing.
class BearingIndex {
 public:
  explicit BearingIndex(const VirtualScan& flat) : flat_(flat) {}

  /// The point nearest in bearing within one step; nothing when there is none.
  [[nodiscard]] const PlanarPoint* at(float bearing) const {
    const auto& points = flat_.points;
    const auto after = std::ranges::lower_bound(points, bearing, {}, &PlanarPoint::bearing_rad);
    const PlanarPoint* best = nullptr;
    auto gap = static_cast<float>(std::max(flat_.step_rad, 1e-4));
    for (const auto* candidate : {after != points.end() ? &*after : nullptr,
                                  after != points.begin() ? &*(after - 1) : nullptr}) {
      if (candidate == nullptr || std::abs(candidate->bearing_rad - bearing) > gap) continue;
      gap = std::abs(candidate->bearing_rad - bearing);
      best = candidate;
    }
    return best;
  }

 private:
  const VirtualScan& flat_;
};

std::uint16_t label_of(std::size_t cluster) {
  return static_cast<std::uint16_t>(1 + cluster % std::numeric_limits<std::uint16_t>::max());
}

/// The world from the levelled sensor frame: the ego's axes, the sensor's place.
Pose2 world_from_level(const pipeline::PosedScan& posed) {
  const Pose2 ego = posed.world_from_ego.planar();
  const Eigen::Vector2d place =
      ego * Eigen::Vector2d(posed.ego_from_sensor.translation_m.head<2>());
  return {place.x(), place.y(), ego.heading_rad};
}

void add_lines(ShownFrame& frame, const pipeline::PosedScan& posed,
               std::span<const Outline> outlines, double scale) {
  const Pose2 place = world_from_level(posed);
  for (const Outline& outline : outlines) {
    for (const LineSegment& line : outline.lines) {
      frame.lines.push_back({place * Eigen::Vector2d(scale * line.first_m),
                             place * Eigen::Vector2d(scale * line.last_m), outline.cluster});
    }
  }
}

}  // namespace

std::vector<std::uint16_t> label_returns(const pipeline::PosedScan& posed, const VirtualScan& flat,
                                         const Clusters& clusters) {
  std::vector<std::uint16_t> of_point(flat.points.size(), 0);
  for (std::size_t k = 0; k < clusters.size(); ++k) {
    for (const auto index : clusters[k]) of_point[index] = label_of(k);
  }
  const auto& returns = posed.scan.returns;
  std::vector<std::uint16_t> labels(returns.size(), 0);
  bool one_layer = true;
  for (const Return& r : returns) one_layer = one_layer && r.layer == 0;
  for (std::size_t i = 0; i < flat.points.size(); ++i) {
    if (flat.points[i].source < labels.size()) labels[flat.points[i].source] = of_point[i];
  }
  if (one_layer) return labels;
  // The other layers: those beside the point that stands for their bearing. De-skewing turned the
  // points by less than a step or two; the range tells.
  const BearingIndex index(flat);
  const Eigen::Matrix3f turn = posed.ego_from_sensor.rotation.toRotationMatrix().cast<float>();
  for (std::size_t i = 0; i < returns.size(); ++i) {
    if (labels[i] != 0) continue;
    const Eigen::Vector3f p =
        turn * Eigen::Vector3f(returns[i].x_m, returns[i].y_m, returns[i].z_m);
    const auto* point = index.at(std::atan2(p.y(), p.x()));
    if (point == nullptr || std::abs(p.head<2>().norm() - point->range_m) > kSameSurfaceM) continue;
    if (p.z() < point->z_low_m - 0.1F || p.z() > point->z_high_m + 0.3F) continue;
    labels[i] = of_point[static_cast<std::size_t>(point - flat.points.data())];
  }
  return labels;
}

std::vector<ShownPoint> place_returns(const pipeline::PosedScan& posed) {
  const Pose3 world_from_sensor = posed.world_from_ego * posed.ego_from_sensor;
  const Pose3 ego_from_sensor = posed.ego_from_sensor;
  const auto& twist = posed.twist;
  const bool still =
      twist.speed_m_per_s == 0 && twist.lateral_m_per_s == 0 && twist.yaw_rate_rad_per_s == 0;
  const Eigen::Matrix3d turn = world_from_sensor.rotation.toRotationMatrix();
  std::vector<ShownPoint> points;
  if (!(world_from_sensor.translation_m.norm() < 1e7)) return points;  // an unusable pose
  points.reserve(posed.scan.returns.size());
  for (const Return& r : posed.scan.returns) {
    const Eigen::Vector3d p(r.x_m, r.y_m, r.z_m);
    ShownPoint point;
    if (still || r.time_offset_s == 0) {
      point.position_m = turn * p + world_from_sensor.translation_m;
    } else {
      const double dt = r.time_offset_s;
      const Pose3 moved = Pose3::from_planar(
          {dt * twist.speed_m_per_s, dt * twist.lateral_m_per_s, dt * twist.yaw_rate_rad_per_s});
      point.position_m = posed.world_from_ego * (moved * (ego_from_sensor * p));
    }
    point.intensity = std::isfinite(r.intensity) ? r.intensity : 0;
    point.layer = static_cast<std::uint8_t>(std::clamp<int>(r.layer, 0, 255));
    points.push_back(point);
  }
  return points;
}

StepResult in_world(StepResult step) {
  if (step.coordinate_frame != "ego") return step;
  const Pose2 ego = step.world_from_ego.planar();
  const double lift = step.world_from_ego.translation_m.z();
  for (auto& detection : step.detections) {
    detection = pipeline::moved(detection, ego);
    detection.z_m += lift;
  }
  for (auto& track : step.tracks) {
    track = pipeline::moved(track, ego);
    track.z_m += lift;
  }
  step.coordinate_frame = "world";
  return step;
}

ShownFrame show(const pipeline::PosedScan& posed, const StepResult& step,
                const pipeline::Perception& perception, double scale) {
  ShownFrame frame;
  frame.step = in_world(step);
  frame.points = place_returns(posed);
  const auto labels = label_returns(posed, perception.virtual_scan(), perception.clusters());
  const std::size_t placed = std::min(labels.size(), frame.points.size());
  for (std::size_t i = 0; i < placed; ++i) frame.points[i].cluster = labels[i];
  frame.detection_of_cluster.assign(perception.clusters().size(), -1);
  const auto sources = perception.sources();
  const auto outlines = perception.outlines();
  for (std::size_t i = 0; i < sources.size(); ++i) {
    if (sources[i] >= outlines.size()) continue;
    const auto cluster = outlines[sources[i]].cluster;
    if (cluster < frame.detection_of_cluster.size()) {
      frame.detection_of_cluster[cluster] = static_cast<std::int32_t>(i);
    }
  }
  add_lines(frame, posed, outlines, scale);
  return frame;
}

}  // namespace scanfuse::serve
