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

struct AdaptiveOptions {
  double lambda_grazing_rad = 0.13962634015954636;  // 8 deg
  double lambda_facing_rad = 0.5235987755982988;    // 30 deg
  double facing_rad = 1.0471975511965976;           // 60 deg
  double gap_steps = 5;
  double sigma_factor = 3;
  int min_points = 3;

  static constexpr auto fields() {
    using O = AdaptiveOptions;
    return std::tuple{
        Field{"lambda_grazing_rad", &O::lambda_grazing_rad, 0.01, 1.5,
              "lambda where two returns lie along the beam: small, so a large threshold"},
        Field{"lambda_facing_rad", &O::lambda_facing_rad, 0.01, 1.5,
              "lambda where they lie across it: large, so a small threshold"},
        Field{"facing_rad", &O::facing_rad, 0.0, 3.2,
              "|alpha - beta| below this counts as across the beam"},
        Field{"gap_steps", &O::gap_steps, 1.0, 1000.0,
              "more beams than this between two returns always cut"},
        Field{"sigma_factor", &O::sigma_factor, 0.0, 20.0, "allowance for range noise, in sigmas"},
        Field{"min_points", &O::min_points, 1, 1000, "smaller clusters are dropped"},
    };
  }
};

/// The adaptive distance threshold of [Guo, eqs 1-2], with its rule of two lambdas: neighbours in
/// bearing belong together while
///
///   |p_n - p_(n-1)| <= r sin(dphi) / sin(lambda - dphi) + 3 sigma_r
///
/// lambda is `lambda_facing_rad` where |alpha - beta| < `facing_rad`, else `lambda_grazing_rad`;
/// alpha and beta are the angles at p_(n-1) and p_n of the triangle that they make with the sensor.
/// The print lost eq. 2; it is that of [Borges2004], see Breakpoint for gaps, symmetry and the
/// seam.
///
/// The rule decides nothing unless facing_rad > pi - 2 lambda_facing_rad: by the law of sines
/// |p_n - p_(n-1)| is a function of the smaller of the two angles alone, the threshold asks whether
/// that angle is less than lambda - dphi, and of a pair across the beam it never is. What is left
/// is Breakpoint with the small lambda, which tests hold it to.
class Adaptive {
 public:
  explicit Adaptive(AdaptiveOptions options = {}) : options_(options) {}
  /// The result stays valid until the next call.
  const Clusters& operator()(const VirtualScan& scan);

 private:
  AdaptiveOptions options_;
  DisjointSets sets_;
  std::vector<std::uint32_t> labels_;
  Gatherer gather_;
};

}  // namespace scanfuse::segment
