#pragma once

#include <cstdint>
#include <tuple>
#include <vector>

#include "scanfuse/core/disjoint_sets.hpp"
#include "scanfuse/core/options.hpp"
#include "scanfuse/segment/gather.hpp"
#include "scanfuse/types/clusters.hpp"
#include "scanfuse/types/virtual_scan.hpp"

namespace scanfuse::segment {

struct BreakpointOptions {
  double lambda_rad = 0.13962634015954636;  // 8 deg
  double gap_steps = 5;
  double sigma_factor = 3;
  int min_points = 3;

  static constexpr auto fields() {
    using O = BreakpointOptions;
    return std::tuple{
        Field{"lambda_rad", &O::lambda_rad, 0.01, 1.5,
              "the flattest angle at which a surface is still followed"},
        Field{"gap_steps", &O::gap_steps, 1.0, 1000.0,
              "more beams than this between two returns always cut"},
        Field{"sigma_factor", &O::sigma_factor, 0.0, 20.0, "allowance for range noise, in sigmas"},
        Field{"min_points", &O::min_points, 1, 1000, "smaller clusters are dropped"},
    };
  }
};

/// Adaptive breakpoint detector [Borges2004]: neighbours in bearing belong together while
///
///   |p_n - p_(n-1)| <= r sin(dphi) / sin(lambda - dphi) + 3 sigma_r.
///
/// Departures: dphi is the true angle between the two returns (never less than one beam step), so
/// that missing beams widen the threshold, up to `gap_steps`; dphi >= lambda cuts; r is the nearer
/// range of the two, so that the direction of the scan does not matter; a full circle has no seam.
/// Where a bearing column holds several points, each is compared with all of its own and of the
/// column before.
class Breakpoint {
 public:
  explicit Breakpoint(BreakpointOptions options = {}) : options_(options) {}
  /// The result stays valid until the next call.
  const Clusters& operator()(const VirtualScan& scan);

 private:
  BreakpointOptions options_;
  DisjointSets sets_;
  std::vector<std::uint32_t> labels_;
  Gatherer gather_;
};

struct DistanceThresholdOptions {
  double threshold_m = 1.0;
  int min_points = 3;

  static constexpr auto fields() {
    using O = DistanceThresholdOptions;
    return std::tuple{
        Field{"threshold_m", &O::threshold_m, 0.001, 100.0,
              "neighbours in bearing farther apart than this are cut"},
        Field{"min_points", &O::min_points, 1, 1000, "smaller clusters are dropped"},
    };
  }
};

/// The fixed distance threshold between neighbours in bearing that [Lu2018, fig. 7 d] compares
/// with.
class DistanceThreshold {
 public:
  explicit DistanceThreshold(DistanceThresholdOptions options = {}) : options_(options) {}
  /// The result stays valid until the next call.
  const Clusters& operator()(const VirtualScan& scan);

 private:
  DistanceThresholdOptions options_;
  DisjointSets sets_;
  std::vector<std::uint32_t> labels_;
  Gatherer gather_;
};

}  // namespace scanfuse::segment
