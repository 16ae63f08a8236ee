#include "scanfuse/calibrate/cloud/beam_grid.hpp"

#include <algorithm>
#include <cmath>

namespace scanfuse::calibrate {
namespace {

double angle_in_lidar(const CloudProfile& profile, const Eigen::Vector3d& p) {
  const Eigen::Vector3d in_lidar = profile.cloud_from_lidar.inverse() * p;
  return std::atan2(in_lidar.y(), in_lidar.x());
}

/// Sums of a straight line through (beam, angle).
struct AngleLine {
  double n = 0, b = 0, a = 0, bb = 0, ba = 0;

  void add(double beam, double angle) {
    n += 1;
    b += beam;
    a += angle;
    bb += beam * beam;
    ba += beam * angle;
  }
};

}  // namespace

BeamGrid::BeamGrid(const Cloud& cloud) : cloud_(&cloud), rows_(cloud.profiles.size()) {
  AngleLine line;
  double reference = 0;
  for (std::size_t k = 0; k < cloud.points.size(); ++k) {
    const CloudPoint& point = cloud.points[k];
    if (point.profile < 0) continue;
    const auto p = static_cast<std::size_t>(point.profile);
    rows_[p].emplace_back(point.beam, k);
    last_beam_ = std::max(last_beam_, point.beam);
    // About the first point's angle, so that a field of view across the back does not wrap.
    const double angle = angle_in_lidar(cloud.profiles[p], point.position_m);
    if (line.n == 0) reference = angle;
    line.add(point.beam, wrap_pi(angle - reference));
  }
  const double spread = line.n * line.bb - line.b * line.b;
  step_rad_ = spread > 0 ? (line.n * line.ba - line.b * line.a) / spread : 0;
  first_rad_ = reference + (line.n > 0 ? (line.a - step_rad_ * line.b) / line.n : 0);
}

std::optional<std::size_t> BeamGrid::index(int profile, int beam) const {
  if (profile < 0 || profile >= profiles()) return std::nullopt;
  const auto& row = rows_[static_cast<std::size_t>(profile)];
  const auto found = std::ranges::lower_bound(row, beam, {}, [](const auto& e) { return e.first; });
  if (found == row.end() || found->first != beam) return std::nullopt;
  return found->second;
}

const CloudPoint* BeamGrid::point(int profile, int beam) const {
  const auto found = index(profile, beam);
  return found ? &cloud_->points[*found] : nullptr;
}

Eigen::Vector3d BeamGrid::ray(int profile, int beam) const {
  if (const CloudPoint* p = point(profile, beam)) {
    return (p->position_m - origin(profile)).normalized();
  }
  const double angle = first_rad_ + step_rad_ * beam;
  return cloud_->profiles[static_cast<std::size_t>(profile)].cloud_from_lidar.rotation *
         Eigen::Vector3d(std::cos(angle), std::sin(angle), 0);
}

std::pair<int, int> BeamGrid::beams_around(int profile, const Eigen::Vector3d& p,
                                           double half_width_rad) const {
  if (step_rad_ == 0) return {0, -1};
  const double angle =
      wrap_pi(angle_in_lidar(cloud_->profiles[static_cast<std::size_t>(profile)], p) - first_rad_);
  const double from = (angle - half_width_rad) / step_rad_,
               to = (angle + half_width_rad) / step_rad_;
  const auto bounded = [&](double beam) {
    return static_cast<int>(std::clamp(beam, -1.0, static_cast<double>(last_beam_) + 1));
  };
  return {bounded(std::floor(std::min(from, to))), bounded(std::ceil(std::max(from, to)))};
}

std::optional<Eigen::Vector3d> BeamGrid::meets(const PlaneFit& plane, int profile, int beam) const {
  const Eigen::Vector3d along = ray(profile, beam), from = origin(profile);
  const double sine = plane.normal().dot(along);
  const double height = plane.height(from);
  if (!(std::abs(sine) > 1e-3) || !(-height / sine > 0)) return std::nullopt;
  return from - along * (height / sine);
}

std::vector<Eigen::Vector3d> rays_of(const Cloud& cloud, std::span<const std::size_t> points) {
  std::vector<Eigen::Vector3d> rays;
  if (!cloud.has_profiles()) return rays;
  for (const std::size_t k : points) {
    const CloudPoint& point = cloud.points[k];
    if (point.profile < 0) return {};
    const auto& pose = cloud.profiles[static_cast<std::size_t>(point.profile)].cloud_from_lidar;
    rays.push_back((point.position_m - pose.translation_m).normalized());
  }
  return rays;
}

}  // namespace scanfuse::calibrate
