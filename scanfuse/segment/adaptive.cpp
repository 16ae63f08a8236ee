#include "scanfuse/segment/adaptive.hpp"

#include <cmath>

#include "scanfuse/segment/breakpoint_rule.hpp"
#include "scanfuse/segment/runs.hpp"

namespace scanfuse::segment {
namespace {

/// |alpha - beta|, the angles at a and b of the triangle that they make with the sensor. By the law
/// of tangents, tan(|alpha - beta| / 2) = |r_b - r_a| / ((r_a + r_b) tan(dphi / 2)).
double incidence_difference(const PlanarPoint& a, const PlanarPoint& b, double gap_rad) {
  const double sum = static_cast<double>(a.range_m) + b.range_m,
               difference = std::abs(static_cast<double>(a.range_m) - b.range_m);
  return 2 * std::atan2(difference, sum * std::tan(gap_rad / 2));
}

}  // namespace

const Clusters& Adaptive::operator()(const VirtualScan& scan) {
  const BreakpointRule facing(scan, options_.lambda_facing_rad, options_.gap_steps,
                              options_.sigma_factor),
      grazing(scan, options_.lambda_grazing_rad, options_.gap_steps, options_.sigma_factor);
  join_runs(scan, sets_, [&](const PlanarPoint& a, const PlanarPoint& b, double gap) {
    const bool across = incidence_difference(a, b, gap) < options_.facing_rad;
    return across ? facing(a, b, gap) : grazing(a, b, gap);
  });
  label_roots(sets_, labels_, scan.points.size());
  return gather_(labels_, scan.points.size(), options_.min_points);
}

}  // namespace scanfuse::segment
