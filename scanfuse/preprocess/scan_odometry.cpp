#include "scanfuse/preprocess/scan_odometry.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "scanfuse/geometry/angles.hpp"

namespace scanfuse::preprocess {
namespace {

constexpr double kFar_m = 0.3, kFar_rad = 0.2;
constexpr double kPoorShare = 0.6;
constexpr double kStillShare = 0.65;
constexpr double kMovedShare = 0.7;
constexpr double kLeastGain = 0.2;
constexpr double kLeastSpread_rad = 2.5;
constexpr int kLeastCompared = 60;
constexpr int kDoubts = 3;
constexpr double kReference_s = 2;  ///< what stands is looked at anew after this
constexpr double kSigmaAccel = 3, kSigmaYawAccel = 5;
constexpr double kLongestStep_s = 0.5;
/// Squared deviations by which a motion must explain a scan better than rest.
constexpr double kRestCost = 12;
constexpr int kMostLost = 5;
/// A recording may begin in the middle of a drive.
constexpr std::array kSpeeds_m_per_s{8.0, 16.0, 24.0, -8.0};
constexpr double kFastest_m_per_s = 30;

bool is_far(const Pose2& way) {
  return std::hypot(way.x_m, way.y_m) > kFar_m || std::abs(way.heading_rad) > kFar_rad;
}

}  // namespace

Pose2 ScanOdometry::expected(Time stamp) const {
  if (!last_ || !moves_) return world_from_sensor_;
  const double dt_s = std::clamp(to_seconds(stamp - *last_), 0.0, kLongestStep_s);
  const Eigen::Vector3d step = twist_ * dt_s;
  return world_from_sensor_ * Pose2{step.x(), step.y(), step.z()};
}

Pose2 ScanOdometry::operator()(const VirtualScan& scan) {
  if (!matcher_.has_reference()) {
    keep(scan, world_from_sensor_);
    found_ = static_cast<int>(scan.points.size()) >= kLeastCompared;
  } else if (moves_) {
    follow(scan);
  } else {
    watch(scan);
  }
  last_ = scan.stamp;
  return world_from_sensor_;
}

void ScanOdometry::keep(const VirtualScan& scan, const Pose2& pose) {
  matcher_.refer_to(scan);
  world_from_reference_ = pose;
  kept_ = scan.stamp;
}

ScanMatch ScanOdometry::from_any_speed(const VirtualScan& scan, double dt_s) const {
  std::array<Pose2, kSpeeds_m_per_s.size()> starts;
  for (std::size_t k = 0; k < starts.size(); ++k) starts[k].x_m = kSpeeds_m_per_s[k] * dt_s;
  return matcher_(scan, {{}, kFastest_m_per_s * dt_s, dt_s}, starts);
}

void ScanOdometry::watch(const VirtualScan& scan) {
  const ScanFit still = matcher_.fit_at(scan, {});
  const double age_s = std::max(to_seconds(scan.stamp - kept_), 0.05);
  const bool in_doubt = still.compared >= kLeastCompared && still.share < kStillShare;
  const ScanMatch moved = in_doubt ? from_any_speed(scan, age_s) : ScanMatch{};
  if (moved.fit.share < kMovedShare || moved.fit.share - still.share < kLeastGain ||
      moved.fit.spread_rad < kLeastSpread_rad) {
    if (in_doubt || doubts_ > 0 || age_s > kReference_s) keep(scan, world_from_sensor_);
    doubts_ = 0;
    return;
  }
  const Pose2& way = moved.reference_from_scan;
  const Pose2 now = world_from_reference_ * way;
  if (++doubts_ >= kDoubts) {
    moves_ = true;
    world_from_sensor_ = now;
    twist_ = Eigen::Vector3d(way.x_m, way.y_m, way.heading_rad) / age_s;
  }
  if (is_far(way)) keep(scan, now);
}

void ScanOdometry::follow(const VirtualScan& scan) {
  const double dt_s = std::clamp(to_seconds(scan.stamp - *last_), 1e-3, kLongestStep_s);
  const Pose2 before = world_from_sensor_;
  const Pose2 reference_from_world = world_from_reference_.inverse();
  ScanPrior prior{reference_from_world * expected(scan.stamp), 0.01 + kSigmaAccel * dt_s * dt_s,
                  0.005 + kSigmaYawAccel * dt_s * dt_s};
  const ScanMatch match = matcher_(scan, prior);
  found_ = match.fit.share > kPoorShare / 2 && match.converged;
  lost_ = found_ ? 0 : lost_ + 1;
  world_from_sensor_ =
      found_ ? world_from_reference_ * match.reference_from_scan : expected(scan.stamp);
  if (found_) {
    const ScanFit rest = matcher_.fit_at(scan, reference_from_world * before);
    if (rest.cost - match.fit.cost < kRestCost) world_from_sensor_ = before;
  }
  const Pose2 way = before.inverse() * world_from_sensor_;
  twist_ = Eigen::Vector3d(way.x_m, way.y_m, way.heading_rad) / dt_s;
  if (lost_ >= kMostLost) twist_.setZero();
  const bool far = is_far(reference_from_world * world_from_sensor_);
  if ((found_ && (far || match.fit.share < kPoorShare)) || lost_ >= kMostLost) {
    keep(scan, world_from_sensor_);
  }
}

}  // namespace scanfuse::preprocess
