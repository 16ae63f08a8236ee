#include "scanfuse/track/hidden.hpp"

#include <algorithm>
#include <cmath>

#include "scanfuse/geometry/angles.hpp"

namespace scanfuse::track {
namespace {

double bearing(const Eigen::Vector2d& v) { return std::atan2(v.y(), v.x()); }

}  // namespace

std::optional<Sector> sector_of(const Box2& box, const Eigen::Vector2d& viewer_m) {
  if (box.contains(viewer_m)) return std::nullopt;
  const Eigen::Vector2d sight = box.centre_m - viewer_m;
  Sector sector;
  sector.middle_rad = bearing(sight);
  sector.centre_range_m = sector.nearest_corner_m = sight.norm();
  for (const Eigen::Vector2d& corner : box.corners()) {
    const Eigen::Vector2d to_corner = corner - viewer_m;
    const double off = wrap_pi(bearing(to_corner) - sector.middle_rad);
    if (std::abs(off) > kPi / 2) return std::nullopt;
    sector.right_rad = std::min(sector.right_rad, off);
    sector.left_rad = std::max(sector.left_rad, off);
    sector.nearest_corner_m = std::min(sector.nearest_corner_m, to_corner.norm());
  }
  return sector;
}

void Shadows::cast(std::span<const Detection> detections) {
  sectors_.clear();
  if (detections.empty()) return;
  viewer_m_ = detections.front().seen_from_m;
  for (const Detection& detection : detections) {
    if (const auto sector = sector_of(detection.box, viewer_m_)) sectors_.push_back(*sector);
  }
}

double Shadows::hidden_share(const Box2& box) {
  const auto target = sectors_.empty() ? std::nullopt : sector_of(box, viewer_m_);
  if (!target || target->left_rad <= target->right_rad) return 0;
  cut_.clear();
  for (const Sector& near : sectors_) {
    if (near.centre_range_m >= target->nearest_corner_m) continue;
    const double shift = wrap_pi(near.middle_rad - target->middle_rad);
    const double right = std::max(near.right_rad + shift, target->right_rad);
    const double left = std::min(near.left_rad + shift, target->left_rad);
    if (right < left) cut_.emplace_back(right, left);
  }
  std::sort(cut_.begin(), cut_.end());
  double covered = 0, reached = target->right_rad;
  for (const auto& [right, left] : cut_) {
    covered += std::max(0.0, left - std::max(right, reached));
    reached = std::max(reached, left);
  }
  return covered / (target->left_rad - target->right_rad);
}

}  // namespace scanfuse::track
