#include "scanfuse/shape/line_fit.hpp"

#include <algorithm>
#include <cmath>

namespace scanfuse::shape {
namespace {

double cross2(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  return a.x() * b.y() - a.y() * b.x();
}

double rms_from_line(std::span<const Eigen::Vector2d> points, const Eigen::Vector2d& on_line,
                     const Eigen::Vector2d& direction) {
  double sum = 0;
  for (const auto& p : points) {
    const double d = cross2(direction, p - on_line);
    sum += d * d;
  }
  return std::sqrt(sum / static_cast<double>(points.size()));
}

}  // namespace

LineSegment fit_segment(std::span<const Eigen::Vector2d> points) {
  RunningSums sums;
  sums.reset(points);
  return sums.fit(0, points.size() - 1);
}

void RunningSums::reset(std::span<const Eigen::Vector2d> points) {
  points_ = points;
  sums_.clear();
  sums_.emplace_back();
  for (const auto& p : points) {
    const double x = p.x() - points[0].x(), y = p.y() - points[0].y();
    const Sums& s = sums_.back();
    sums_.push_back({s.x + x, s.y + y, s.xx + x * x, s.xy + x * y, s.yy + y * y});
  }
}

/// The direction at half the angle of (xx - yy, 2 xy), the larger axis of the scatter.
LineSegment RunningSums::fit(std::size_t first, std::size_t last) const {
  const Sums &a = sums_[first], &b = sums_[last + 1];
  const auto count = static_cast<double>(last - first + 1);
  const double mx = (b.x - a.x) / count, my = (b.y - a.y) / count;
  const double xx = (b.xx - a.xx) / count - mx * mx, yy = (b.yy - a.yy) / count - my * my;
  const double xy = (b.xy - a.xy) / count - mx * my;
  const double spread = std::sqrt((xx - yy) * (xx - yy) + 4 * xy * xy);  // hypot is a slow call
  const double cos2 = spread > 0 ? (xx - yy) / spread : 1;
  const Eigen::Vector2d direction(std::sqrt(std::max(1 + cos2, 0.0) / 2),
                                  std::copysign(std::sqrt(std::max(1 - cos2, 0.0) / 2), xy));
  const Eigen::Vector2d mean = points_[0] + Eigen::Vector2d(mx, my);
  return {mean + direction * direction.dot(points_[first] - mean),
          mean + direction * direction.dot(points_[last] - mean),
          std::sqrt(std::max((xx + yy - spread) / 2, 0.0)), static_cast<int>(last - first + 1)};
}

LineSegment chord(std::span<const Eigen::Vector2d> points) {
  const Eigen::Vector2d along = points.back() - points.front();
  const double length = along.norm();
  const Eigen::Vector2d direction = length > 0 ? Eigen::Vector2d(along / length) : along;
  return {points.front(), points.back(), rms_from_line(points, points.front(), direction),
          static_cast<int>(points.size())};
}

}  // namespace scanfuse::shape
