#include "scanfuse/shape/line_fit.hpp"

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
  Eigen::Vector2d mean = Eigen::Vector2d::Zero();
  for (const auto& p : points) mean += p;
  mean /= static_cast<double>(points.size());
  double xx = 0, xy = 0, yy = 0;
  for (const auto& p : points) {
    const Eigen::Vector2d d = p - mean;
    xx += d.x() * d.x();
    xy += d.x() * d.y();
    yy += d.y() * d.y();
  }
  const double angle = 0.5 * std::atan2(2 * xy, xx - yy);
  const Eigen::Vector2d direction(std::cos(angle), std::sin(angle));
  return {mean + direction * direction.dot(points.front() - mean),
          mean + direction * direction.dot(points.back() - mean),
          rms_from_line(points, mean, direction), static_cast<int>(points.size())};
}

LineSegment chord(std::span<const Eigen::Vector2d> points) {
  const Eigen::Vector2d along = points.back() - points.front();
  const double length = along.norm();
  const Eigen::Vector2d direction = length > 0 ? Eigen::Vector2d(along / length) : along;
  return {points.front(), points.back(), rms_from_line(points, points.front(), direction),
          static_cast<int>(points.size())};
}

}  // namespace scanfuse::shape
