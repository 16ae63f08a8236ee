#pragma once

#include <algorithm>
#include <cmath>

#include "scanfuse/segment/runs.hpp"

namespace scanfuse::segment {

/// Whether two neighbours in bearing belong together by the adaptive distance threshold
/// [Borges2004], for the scans of one sensor:
///
///   |p_n - p_(n-1)| <= r sin(dphi) / sin(lambda - dphi) + sigma_factor sigma_r
///
/// r is the nearer range of the two; dphi the true angle between them, but no less than one beam
/// step. dphi >= lambda, or more than `gap_steps` steps, cuts.
class BreakpointRule {
 public:
  BreakpointRule(const VirtualScan& scan, double lambda_rad, double gap_steps, double sigma_factor)
      : lambda_rad_(lambda_rad),
        step_rad_(scan.step_rad),
        widest_rad_(step_rad_ > 0 ? (gap_steps + 0.5) * step_rad_ : lambda_rad),
        slack_m_(sigma_factor * scan.sigma_range_m) {
    if (step_rad_ < lambda_rad) step_factor_ = factor(step_rad_);
  }

  [[nodiscard]] bool operator()(const PlanarPoint& a, const PlanarPoint& b, double gap_rad) const {
    if (gap_rad > widest_rad_ || std::max(gap_rad, step_rad_) >= lambda_rad_) return false;
    const double nearer = std::min(a.range_m, b.range_m);
    const double threshold =
        nearer * (gap_rad <= step_rad_ ? step_factor_ : factor(gap_rad)) + slack_m_;
    return squared_distance(a, b) <= threshold * threshold;
  }

 private:
  [[nodiscard]] double factor(double gap_rad) const {
    return std::sin(gap_rad) / std::sin(lambda_rad_ - gap_rad);
  }
  double lambda_rad_;
  double step_rad_;
  double widest_rad_;
  double slack_m_;
  double step_factor_ = 0;  ///< most gaps are one step: worked out once
};

}  // namespace scanfuse::segment
