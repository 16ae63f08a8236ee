#include "scanfuse/segment/surface.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "scanfuse/segment/breakpoint_rule.hpp"
#include "scanfuse/segment/runs.hpp"

namespace scanfuse::segment {
namespace {

/// Whether c lies on the line through a and b, within range noise. In 1 / r a line is
///   1 / r(theta) = A cos theta + B sin theta,
/// over a few beams a straight line in theta; noise of 1 / r is sigma / r^2.
class StraightRule {
 public:
  StraightRule(const VirtualScan& scan, double sigma_factor)
      : points_(scan.points),
        most_sigma2_(sigma_factor * sigma_factor * scan.sigma_range_m * scan.sigma_range_m),
        widest_rad_(1.5 * scan.step_rad) {}

  /// In order of bearing, or of falling bearing.
  [[nodiscard]] bool operator()(std::size_t a, std::size_t b, std::size_t c) const {
    const double ab = wrap_pi(static_cast<double>(points_[b].bearing_rad) - points_[a].bearing_rad),
                 bc = wrap_pi(static_cast<double>(points_[c].bearing_rad) - points_[b].bearing_rad);
    if (std::abs(ab) > widest_rad_ || std::abs(bc) > widest_rad_ || !(ab * bc > 0)) return false;
    const double t = bc / ab;
    const double ua = 1.0 / points_[a].range_m, ub = 1.0 / points_[b].range_m,
                 uc = 1.0 / points_[c].range_m;
    const double off = uc - ub - t * (ub - ua);
    const double ua2 = ua * ua, ub2 = ub * ub, uc2 = uc * uc;
    return off * off <=
           most_sigma2_ * (uc2 * uc2 + (1 + t) * (1 + t) * ub2 * ub2 + t * t * ua2 * ua2);
  }

 private:
  std::span<const PlanarPoint> points_;
  double most_sigma2_;
  double widest_rad_;
};

}  // namespace

void Surface::follow(const VirtualScan& scan) {
  const BreakpointRule near(scan, options_.lambda_rad, options_.gap_steps, options_.sigma_factor);
  const StraightRule straight(scan, options_.sigma_factor);
  const double along2 = options_.along_m * options_.along_m, widest = 1.5 * scan.step_rad;
  const std::size_t n = scan.points.size();
  join_runs(scan, sets_, [&](const PlanarPoint& a, const PlanarPoint& b, double gap) {
    if (near(a, b, gap)) return true;
    if (gap > widest || squared_distance(a, b) > along2 || n < 3) return false;
    const auto i = static_cast<std::size_t>(&a - scan.points.data()),
               j = static_cast<std::size_t>(&b - scan.points.data());
    const std::size_t before = i > 0 ? i - 1 : n - 1, after = j + 1 < n ? j + 1 : 0;
    return straight(before, i, j) || straight(after, j, i);
  });
}

const Clusters& Surface::operator()(const VirtualScan& scan) {
  follow(scan);
  label_roots(sets_, labels_, scan.points.size());
  const Clusters& whole = gather_(labels_, scan.points.size(), options_.min_points);
  return cut_(scan, whole, options_.notch_m, options_.min_points);
}

}  // namespace scanfuse::segment
