#include "scanfuse/pipeline/perception.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>

namespace scanfuse::pipeline {
namespace {

constexpr double kFarthestPose_m = 1e7;  // beyond it millimetres are lost, and it is no odometry
constexpr double kFastestEgo = 1e3;      // m/s, rad/s

bool is_near(const Pose3& pose) {
  return pose.translation_m.allFinite() &&
         pose.translation_m.cwiseAbs().maxCoeff() < kFarthestPose_m &&
         pose.rotation.coeffs().allFinite();
}

bool is_likely(const PoseBuffer::Twist& twist) {
  return std::abs(twist.speed_m_per_s) < kFastestEgo &&
         std::abs(twist.lateral_m_per_s) < kFastestEgo &&
         std::abs(twist.yaw_rate_rad_per_s) < kFastestEgo;
}

/// The levelled sensor frame: the ego's axes, the sensor's place.
Pose2 world_from_level(const PosedScan& posed) {
  const Eigen::Vector3d mount = posed.ego_from_sensor.translation_m;
  return posed.world_from_ego.planar() * Pose2{mount.x(), mount.y(), 0};
}

}  // namespace

Perception::Perception(const PerceptionOptions& options)
    : options_(options),
      filter_(options.preprocess),
      flatten_(options.preprocess),
      segment_(options.segment),
      outline_(options.shape),
      recognize_(options.classify) {}

void Perception::give_in_scene(const PosedScan& posed) {
  const double scale = options_.pipeline.scale;
  result_.world_from_ego = posed.world_from_ego;
  result_.ego_from_sensor = posed.ego_from_sensor;
  for (Detection& detection : result_.detections) detection = scaled(detection, scale);
  for (Track& track : result_.tracks) track = scaled(track, scale);
  virtual_scan_ = scaled(std::move(virtual_scan_), scale);
}

bool Perception::is_placed(const PosedScan& posed) {
  return is_near(posed.world_from_ego) && is_near(posed.ego_from_sensor);
}

PosedScan Perception::left_empty(const PosedScan& posed) {
  diagnostics_.note("scan at an unusable pose taken as empty",
                    posed.scan.sensor + " scan " + std::to_string(posed.scan.frame));
  PosedScan nothing;
  nothing.scan.stamp = posed.scan.stamp;
  nothing.scan.frame = posed.scan.frame;
  nothing.scan.sensor = posed.scan.sensor;
  nothing.scan.frame_id = posed.scan.frame_id;
  nothing.mount_is_known = posed.mount_is_known;
  return nothing;
}

Diagnostics Perception::diagnostics() const {
  Diagnostics all = diagnostics_;
  for (const auto& [frame, tracker] : trackers_) all.merge(tracker.diagnostics());
  return all;
}

track::Tracker& Perception::tracker_of(const PosedScan& posed) {
  constexpr std::string_view kEgo;
  const std::string_view frame = posed.mount_is_known ? kEgo : posed.scan.frame_id;
  const auto known = trackers_.find(frame);
  if (known != trackers_.end()) return known->second;
  if (!trackers_.empty()) {
    diagnostics_.note("sensor tracked for itself: where it is on the ego is not known",
                      std::string(frame));
  }
  return trackers_.try_emplace(std::string(frame), options_.track, track_ids_).first->second;
}

int Perception::number_of(const std::string& sensor) {
  const auto known = std::find(sensors_.begin(), sensors_.end(), sensor);
  if (known != sensors_.end()) return static_cast<int>(known - sensors_.begin());
  sensors_.push_back(sensor);
  return static_cast<int>(sensors_.size()) - 1;
}

void Perception::straighten(const PosedScan& posed) {
  const auto& twist = posed.twist;
  if (!is_likely(twist)) {
    diagnostics_.note("scan not corrected for an unlikely ego motion",
                      posed.scan.sensor + " scan " + std::to_string(posed.scan.frame));
    return;
  }
  preprocess::deskew(virtual_scan_,
                     {{twist.speed_m_per_s, twist.lateral_m_per_s}, twist.yaw_rate_rad_per_s},
                     posed.ego_from_sensor.translation_m.head<2>());
}

void Perception::expect(const PosedScan& posed) {
  tracker_of(posed).expect(posed.scan.stamp, expected_);
  const Pose2 level_from_world = world_from_level(posed).inverse();
  for (Expected& object : expected_) {
    object.box.centre_m = level_from_world * object.box.centre_m;
    object.box.heading_rad = wrap_pi(object.box.heading_rad + level_from_world.heading_rad);
  }
}

void Perception::give_in_world(const PosedScan& posed, std::span<const Detection> detections) {
  result_.stamp = posed.scan.stamp;
  result_.frame = posed.scan.frame;
  result_.sensor = posed.scan.sensor;
  result_.world_from_ego = posed.world_from_ego;
  result_.coordinate_frame = options_.pipeline.frame == OutputFrame::kEgo ? "ego" : "world";
  result_.ego_from_sensor = posed.ego_from_sensor;
  // Detections stand in the levelled sensor frame: the ego's axes, the sensor's place.
  const Pose2 place = world_from_level(posed);
  const double lift =
      posed.world_from_ego.translation_m.z() + posed.ego_from_sensor.translation_m.z();
  result_.detections.clear();
  for (const Detection& detection : detections) {
    result_.detections.push_back(moved(detection, place));
    result_.detections.back().z_m += lift;
  }
}

void Perception::give_in_ego() {
  const Pose2 ego_from_world = result_.world_from_ego.planar().inverse();
  const double drop = result_.world_from_ego.translation_m.z();
  for (Detection& detection : result_.detections) {
    detection = moved(detection, ego_from_world);
    detection.z_m -= drop;
  }
  for (Track& track : result_.tracks) {
    track = moved(track, ego_from_world);
    track.z_m -= drop;
  }
}

Detection moved(const Detection& detection, const Pose2& target_from_source) {
  const Eigen::Matrix2d turn =
      Eigen::Rotation2Dd(target_from_source.heading_rad).toRotationMatrix();
  Eigen::Matrix3d turn3 = Eigen::Matrix3d::Identity();
  turn3.topLeftCorner<2, 2>() = turn;
  Detection out = detection;
  out.box.centre_m = target_from_source * detection.box.centre_m;
  out.box.heading_rad = wrap_pi(detection.box.heading_rad + target_from_source.heading_rad);
  out.covariance = turn3 * detection.covariance * turn3.transpose();
  out.seen_from_m = target_from_source * detection.seen_from_m;
  out.visible_middle_m = target_from_source * detection.visible_middle_m;
  return out;
}

Track moved(const Track& track, const Pose2& target_from_source) {
  const Eigen::Matrix2d turn =
      Eigen::Rotation2Dd(target_from_source.heading_rad).toRotationMatrix();
  Track out = track;
  out.box.centre_m = target_from_source * track.box.centre_m;
  out.box.heading_rad = wrap_pi(track.box.heading_rad + target_from_source.heading_rad);
  // State order x, vx, y, vy: positions at 0 and 2, velocities at 1 and 3.
  Eigen::Matrix4d turn4 = Eigen::Matrix4d::Zero();
  for (const int first : {0, 1}) {
    turn4(first, first) = turn(0, 0);
    turn4(first, first + 2) = turn(0, 1);
    turn4(first + 2, first) = turn(1, 0);
    turn4(first + 2, first + 2) = turn(1, 1);
  }
  out.state.mean = turn4 * track.state.mean;
  out.state.mean[0] += target_from_source.x_m;
  out.state.mean[2] += target_from_source.y_m;
  out.state.covariance = turn4 * track.state.covariance * turn4.transpose();
  return out;
}

}  // namespace scanfuse::pipeline
