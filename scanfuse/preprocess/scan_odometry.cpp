#include "scanfuse/preprocess/scan_odometry.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "scanfuse/geometry/angles.hpp"

namespace scanfuse::preprocess {
namespace {

constexpr double kFar_m = 0.3, kFar_rad = 0.2;
constexpr double kPoorShare = 0.6;
constexpr double kStillShare = 0.6;
constexpr double kMovedShare = 0.7;
constexpr double kLeastGain = 0.25;
constexpr double kLeastSpread_rad = 2 * std::numbers::pi / 3;
constexpr int kLeastCompared = 60;
constexpr int kDoubts = 3;
constexpr double kReference_s = 2;  ///< what stands is looked at anew after this
constexpr double kSigmaAccel = 3, kSigmaYawAccel = 5;
constexpr double kLongestStep_s = 0.5;
/// Squared deviations by which a motion must explain a scan better than rest.
constexpr double kRestCost = 12;
constexpr int kMostLost = 5;

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

void ScanOdometry::watch(const VirtualScan& scan) {
  const ScanFit still = matcher_.fit_at(scan, {});
  const double age_s = std::max(to_seconds(scan.stamp - kept_), 0.05);
  if (still.compared < kLeastCompared || still.share > kStillShare) {
    doubts_ = 0;
    if (age_s > kReference_s) keep(scan, world_from_sensor_);
    return;
  }
  const ScanMatch moved = matcher_(scan, {{}, age_s, age_s});
  const bool explained = moved.fit.share > kMovedShare &&
                         moved.fit.share - still.share > kLeastGain &&
                         moved.fit.spread_rad > kLeastSpread_rad;
  doubts_ = explained ? doubts_ + 1 : 0;
  if (doubts_ >= kDoubts) {
    moves_ = true;
    world_from_sensor_ = world_from_reference_ * moved.reference_from_scan;
    const Pose2& way = moved.reference_from_scan;
    twist_ = Eigen::Vector3d(way.x_m, way.y_m, way.heading_rad) / age_s;
  }
  if (age_s > kReference_s) keep(scan, world_from_sensor_);
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
  const Pose2 gone = reference_from_world * world_from_sensor_;
  const bool far = std::hypot(gone.x_m, gone.y_m) > kFar_m || std::abs(gone.heading_rad) > kFar_rad;
  if ((found_ && (far || match.fit.share < kPoorShare)) || lost_ >= kMostLost) {
    keep(scan, world_from_sensor_);
  }
}

}  // namespace scanfuse::preprocess
