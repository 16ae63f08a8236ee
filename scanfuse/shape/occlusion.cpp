#include "scanfuse/shape/occlusion.hpp"

#include <cstdlib>

namespace scanfuse::shape {
namespace {

/// Looks from `end` in the direction of `step` (+1: larger bearing).
bool may_go_on(const VirtualScan& scan, std::uint32_t end, int step,
               const OcclusionOptions& options) {
  const auto count = static_cast<std::int64_t>(scan.points.size());
  const PlanarPoint& from = scan.points[end];
  const double view_end = step > 0 ? scan.view_to_rad : -scan.view_from_rad;
  if (step * from.bearing_rad > view_end - 1.5 * scan.step_rad) return true;
  for (std::int64_t k = 1; k <= options.columns && k < count; ++k) {
    std::int64_t index = static_cast<std::int64_t>(end) + step * k;
    const bool wrapped = index < 0 || index >= count;
    if (wrapped && !scan.full_circle) return false;
    index = (index + count) % count;
    const PlanarPoint& other = scan.points[static_cast<std::size_t>(index)];
    if (!wrapped && std::abs(std::int64_t{other.column} - from.column) > options.columns) {
      return false;
    }
    if (other.range_m < from.range_m - options.nearer_by_m) return true;
    if (k == 1 && other.range_m < from.range_m + options.beside_m) return true;
  }
  return false;
}

}  // namespace

CutEnds find_cut_ends(const VirtualScan& scan, std::uint32_t first, std::uint32_t last,
                      const OcclusionOptions& options) {
  return {may_go_on(scan, last, 1, options), may_go_on(scan, first, -1, options)};
}

}  // namespace scanfuse::shape
