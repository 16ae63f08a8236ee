#include "scanfuse/triangulate/closest_points.hpp"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>

namespace scanfuse::triangulate {
namespace {

constexpr double kParallel = 1e-4;  // rad

/// The line p = origin + t direction against the plane left . (p - plane's origin) = 0.
std::optional<ClosestPoints> line_through_plane(const LineOfSight& line, const LineOfSight& plane) {
  const double slope = plane.left.dot(line.direction);
  if (std::abs(slope) < kParallel) return std::nullopt;
  const double t = plane.left.dot(plane.origin_m - line.origin_m) / slope;
  const Eigen::Vector3d point = line.origin_m + t * line.direction;
  if (t <= 0 || plane.direction.dot(point - plane.origin_m) <= 0) return std::nullopt;
  return ClosestPoints{point, 0};
}

/// Two planes, at the height of the sensors' middle along their common up.
std::optional<ClosestPoints> planes(const LineOfSight& a, const LineOfSight& b) {
  const Eigen::Vector3d up = a.left.cross(b.left);
  if (up.norm() < kParallel) return std::nullopt;
  Eigen::Matrix3d rows;
  rows << a.left.transpose(), b.left.transpose(), up.normalized().transpose();
  const Eigen::Vector3d middle = (a.origin_m + b.origin_m) / 2;
  const Eigen::Vector3d point =
      rows.inverse() *
      Eigen::Vector3d(a.left.dot(a.origin_m), b.left.dot(b.origin_m), up.normalized().dot(middle));
  if (a.direction.dot(point - a.origin_m) <= 0 || b.direction.dot(point - b.origin_m) <= 0) {
    return std::nullopt;
  }
  return ClosestPoints{point, 0};
}

/// Sigma of a line across `side` (a unit vector), per metre of range.
double sigma_across(const LineOfSight& line, const Eigen::Vector3d& side) {
  return std::hypot(line.sigma_left_rad * line.left.dot(side),
                    line.sigma_up_rad * line.up.dot(side));
}

}  // namespace

std::optional<ClosestPoints> closest_points(const LineOfSight& a, const LineOfSight& b) {
  if (!a.tells_elevation() && !b.tells_elevation()) return planes(a, b);
  if (!a.tells_elevation()) return line_through_plane(b, a);
  if (!b.tells_elevation()) return line_through_plane(a, b);
  const Eigen::Vector3d across = a.direction.cross(b.direction), d = b.origin_m - a.origin_m;
  const double squared = across.squaredNorm();
  if (squared < kParallel * kParallel) return std::nullopt;
  const double range_a = d.cross(b.direction).dot(across) / squared;
  const double range_b = d.cross(a.direction).dot(across) / squared;
  if (range_a <= 0 || range_b <= 0) return std::nullopt;
  const Eigen::Vector3d side = across / std::sqrt(squared);
  const double sigma = std::hypot(range_a * sigma_across(a, side), range_b * sigma_across(b, side));
  return ClosestPoints{
      (a.origin_m + range_a * a.direction + b.origin_m + range_b * b.direction) / 2,
      std::abs(d.dot(side)) / std::max(sigma, 1e-12)};
}

}  // namespace scanfuse::triangulate
