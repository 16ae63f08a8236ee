#include "scanfuse/segment/breakpoint.hpp"

#include <algorithm>
#include <cmath>

#include "scanfuse/geometry/angles.hpp"

namespace scanfuse::segment {
namespace {

double squared_distance(const PlanarPoint& a, const PlanarPoint& b) {
  const double dx = static_cast<double>(a.x_m) - b.x_m, dy = static_cast<double>(a.y_m) - b.y_m;
  return dx * dx + dy * dy;
}

/// Numbers the runs of points that `linked(earlier, later, gap_rad)` holds together; on a full
/// circle the last run may go on in the first.
template <class Linked>
void label_runs(const VirtualScan& scan, std::vector<std::uint32_t>& labels, Linked linked) {
  const auto& points = scan.points;
  labels.resize(points.size());
  if (points.empty()) return;
  std::uint32_t run = 0;
  labels[0] = 0;
  for (std::size_t i = 1; i < points.size(); ++i) {
    const double gap = static_cast<double>(points[i].bearing_rad) - points[i - 1].bearing_rad;
    if (!linked(points[i - 1], points[i], gap)) ++run;
    labels[i] = run;
  }
  if (!scan.full_circle || run == 0) return;
  const double seam = 2 * kPi + points.front().bearing_rad - points.back().bearing_rad;
  if (!linked(points.back(), points.front(), seam)) return;
  for (std::size_t i = points.size(); i-- > 0 && labels[i] == run;) labels[i] = 0;
}

}  // namespace

const Clusters& Breakpoint::operator()(const VirtualScan& scan) {
  const double slack = options_.sigma_factor * scan.sigma_range_m;
  const double widest =
      scan.step_rad > 0 ? (options_.gap_steps + 0.5) * scan.step_rad : options_.lambda_rad;
  // Most gaps are one step: its factor is worked out once.
  const double step_factor =
      scan.step_rad < options_.lambda_rad
          ? std::sin(scan.step_rad) / std::sin(options_.lambda_rad - scan.step_rad)
          : 0;
  const auto linked = [&](const PlanarPoint& a, const PlanarPoint& b, double gap) {
    if (gap > widest || std::max(gap, scan.step_rad) >= options_.lambda_rad) return false;
    const double nearer = std::min(a.range_m, b.range_m);
    const double factor =
        gap <= scan.step_rad ? step_factor : std::sin(gap) / std::sin(options_.lambda_rad - gap);
    const double threshold = nearer * factor + slack;
    return squared_distance(a, b) <= threshold * threshold;
  };
  label_runs(scan, labels_, linked);
  return gather_(labels_, scan.points.size(), options_.min_points);
}

const Clusters& DistanceThreshold::operator()(const VirtualScan& scan) {
  const double squared = options_.threshold_m * options_.threshold_m;
  label_runs(scan, labels_, [&](const PlanarPoint& a, const PlanarPoint& b, double) {
    return squared_distance(a, b) <= squared;
  });
  return gather_(labels_, scan.points.size(), options_.min_points);
}

}  // namespace scanfuse::segment
