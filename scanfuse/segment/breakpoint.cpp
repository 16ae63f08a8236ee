#include "scanfuse/segment/breakpoint.hpp"

#include "scanfuse/segment/breakpoint_rule.hpp"
#include "scanfuse/segment/runs.hpp"

namespace scanfuse::segment {

const Clusters& Breakpoint::operator()(const VirtualScan& scan) {
  join_runs(scan, sets_,
            BreakpointRule(scan, options_.lambda_rad, options_.gap_steps, options_.sigma_factor));
  label_roots(sets_, labels_, scan.points.size());
  return gather_(labels_, scan.points.size(), options_.min_points);
}

const Clusters& DistanceThreshold::operator()(const VirtualScan& scan) {
  const double squared = options_.threshold_m * options_.threshold_m;
  join_runs(scan, sets_, [&](const PlanarPoint& a, const PlanarPoint& b, double) {
    return squared_distance(a, b) <= squared;
  });
  label_roots(sets_, labels_, scan.points.size());
  return gather_(labels_, scan.points.size(), options_.min_points);
}

}  // namespace scanfuse::segment
