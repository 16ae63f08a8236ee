#include "scanfuse/report/track_report.hpp"

#include <algorithm>
#include <cmath>

#include "scanfuse/report/page.hpp"

namespace scanfuse::report {
namespace {

std::size_t page_bytes(const ReportedFrame& frame) {
  return 90 + frame.point_group.size() * 20 / 3 + frame.tracks.size() * 110;
}

/// Appends a point of the ego frame, if 16 bits hold it.
void put_point(ReportedFrame& frame, double x_m, double y_m, std::uint8_t group) {
  const double x_cm = std::round(100 * x_m), y_cm = std::round(100 * y_m);
  if (!(std::abs(x_cm) < 32767 && std::abs(y_cm) < 32767)) return;
  frame.points_cm.push_back(static_cast<std::int16_t>(x_cm));
  frame.points_cm.push_back(static_cast<std::int16_t>(y_cm));
  frame.point_group.push_back(group);
}

ReportedTrack reported_track(const Track& track, const StepResult& step, const Pose2& world_from) {
  ReportedTrack out;
  out.id = track.id;
  out.object_class = track.object_class;
  out.status = track.status;
  out.box = track.box;
  out.box.centre_m = world_from * track.box.centre_m;
  out.box.heading_rad = wrap_pi(track.box.heading_rad + world_from.heading_rad);
  const Eigen::Matrix2d turn = Eigen::Rotation2Dd(world_from.heading_rad).toRotationMatrix();
  out.velocity_m_per_s = turn * Eigen::Vector2d(track.state.mean[1], track.state.mean[3]);
  const auto& P = track.state.covariance;  // of x, vx, y, vy
  Eigen::Matrix2d position;
  position << P(0, 0), P(0, 2), P(2, 0), P(2, 2);
  out.covariance_m2 = turn * position * turn.transpose();
  if (track.detection >= 0 && track.detection < static_cast<int>(step.detections.size())) {
    out.measured = true;
    const Detection& seen = step.detections[static_cast<std::size_t>(track.detection)];
    out.measured_m = world_from * seen.box.centre_m;
    out.left_end_hidden = seen.left_end_occluded;
    out.right_end_hidden = seen.right_end_occluded;
  }
  return out;
}

}  // namespace

void TrackReport::add(const StepResult& step, const Scan& scan, const VirtualScan* flat,
                      const Clusters* clusters) {
  ReportedFrame frame;
  frame.frame = step.frame;
  frame.stamp = step.stamp;
  frame.world_from_ego = step.world_from_ego.planar();
  frame.sensor_m = (step.world_from_ego * step.ego_from_sensor).translation_m.head<2>();
  const Pose2 world_from = step.coordinate_frame == "ego" ? frame.world_from_ego : Pose2{};
  for (const Track& track : step.tracks) {
    frame.tracks.push_back(reported_track(track, step, world_from));
  }
  account(frame);
  if (frames_seen_++ % stride_ != 0) return;
  add_points(frame, step, scan, flat, clusters);
  bytes_ += page_bytes(frame);
  frames_.push_back(std::move(frame));
  while (bytes_ > options_.max_bytes && frames_.size() > 2) thin();
}

void TrackReport::add(const TruthFrame& truth) { truth_.insert_or_assign(truth.frame, truth); }

void TrackReport::add_points(ReportedFrame& frame, const StepResult& step, const Scan& scan,
                             const VirtualScan* flat, const Clusters* clusters) {
  const std::size_t count = flat != nullptr ? flat->points.size() : scan.returns.size();
  const std::size_t skip = count / std::max<std::size_t>(options_.max_points_per_frame, 1) + 1;
  points_thinned_ = points_thinned_ || skip > 1;
  if (flat == nullptr) {
    for (std::size_t i = 0; i < count; i += skip) {
      const auto& r = scan.returns[i];
      const Eigen::Vector3d p = step.ego_from_sensor * Eigen::Vector3d(r.x_m, r.y_m, r.z_m);
      put_point(frame, p.x(), p.y(), 0);
    }
    return;
  }
  std::vector<std::uint8_t> group(count, 0);
  for (std::size_t k = 0; clusters != nullptr && k < clusters->size(); ++k) {
    for (const auto i : (*clusters)[k]) {
      if (i < count) group[i] = static_cast<std::uint8_t>(1 + k % 255);
    }
  }
  const Eigen::Vector3d mount = step.ego_from_sensor.translation_m;
  for (std::size_t i = 0; i < count; i += skip) {
    const auto& p = flat->points[i];
    put_point(frame, p.x_m + mount.x(), p.y_m + mount.y(), group[i]);
  }
}

void TrackReport::account(const ReportedFrame& frame) {
  const Eigen::Rotation2Dd ego_from_world(-frame.world_from_ego.heading_rad);
  for (const auto& track : frame.tracks) {
    auto [entry, is_new] = lives_.try_emplace(track.id);
    TrackLife& life = entry->second;
    if (is_new) life.first_frame = frame.frame;
    life.last_frame = frame.frame;
    life.object_class = track.object_class;
    life.confirmed = life.confirmed || track.status == TrackStatus::kConfirmed;
    life.frames += 1;
    if (!track.measured) continue;
    const Eigen::Vector2d d = ego_from_world * (track.box.centre_m - track.measured_m);
    if (!d.allFinite()) continue;
    life.measured += 1;
    life.square_difference_m2 += Eigen::Array2d(d.y(), d.x()).square();
  }
}

void TrackReport::thin() {
  stride_ *= 2;
  std::size_t kept = 0;
  bytes_ = 0;
  for (std::size_t i = 0; i < frames_.size(); i += 2, ++kept) {
    if (kept != i) frames_[kept] = std::move(frames_[i]);
    bytes_ += page_bytes(frames_[kept]);
  }
  frames_.resize(kept);
}

std::string TrackReport::html(const TrackReportHeader& header) const {
  return track_report_page(*this, header);
}

}  // namespace scanfuse::report
