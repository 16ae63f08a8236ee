#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "scanfuse/segment/gather.hpp"
#include "scanfuse/types/clusters.hpp"
#include "scanfuse/types/virtual_scan.hpp"

namespace scanfuse::segment {

/// Cuts clusters where two things touch. A road user is convex to the sensor: its outline may turn
/// towards the sensor, at a corner, but not away. Where an outline (the nearest point of each
/// bearing) lies behind its own convex hull by more than `notch_m` and noise, it is cut at the
/// bottom of the notch, on the side of the wider gap; then each part again.
///
/// Noise is 2 sqrt(2 ln n) sigma_r, about what the extremes of n normal deviates differ by, across
/// the hull's edge. Hollow corners of buildings are cut too. What stands around the sensor (3 rad
/// or more) is left whole.
///
/// Owns its working memory: after the first scans nothing is allocated.
class NotchCutter {
 public:
  /// `notch_m` 0: `clusters` as they are. Parts of fewer than `min_points` are dropped. The result
  /// stays valid until the next call, and as long as `clusters`.
  const Clusters& operator()(const VirtualScan& scan, const Clusters& clusters, double notch_m,
                             int min_points);

 private:
  /// The nearest point of one bearing column of a cluster.
  struct Link {
    double x = 0, y = 0, range_m = 0, bearing_rad = 0;
    std::uint32_t first = 0, end = 0;  ///< the column's points in the cluster
    bool begins = false;               ///< an object of its own
  };
  bool lay_out(const VirtualScan& scan, std::span<const std::uint32_t> cluster);
  void find_notches(double sigma_m);
  [[nodiscard]] std::size_t deepest(std::size_t first, std::size_t last, double sigma_m);
  void stretch_hull(std::size_t first, std::size_t last);

  double notch_m_ = 0;
  std::vector<Link> chain_;
  std::vector<std::uint32_t> hull_;
  std::vector<std::pair<std::size_t, std::size_t>> stretches_;
  std::vector<std::uint32_t> labels_;
  Gatherer gather_;
};

}  // namespace scanfuse::segment
