#pragma once

#include <cstdint>
#include <tuple>
#include <vector>

#include "scanfuse/core/disjoint_sets.hpp"
#include "scanfuse/core/options.hpp"
#include "scanfuse/segment/gather.hpp"
#include "scanfuse/segment/notch.hpp"
#include "scanfuse/types/clusters.hpp"
#include "scanfuse/types/virtual_scan.hpp"

namespace scanfuse::segment {

struct SurfaceOptions {
  double lambda_rad = 0.13962634015954636;  // 8 deg
  double gap_steps = 5;
  double sigma_factor = 3;
  double along_m = 2;
  double notch_m = 0.02;
  int min_points = 3;

  static constexpr auto fields() {
    using O = SurfaceOptions;
    return std::tuple{
        Field{"lambda_rad", &O::lambda_rad, 0.01, 1.5,
              "the flattest angle at which a surface of any shape is still followed"},
        Field{"gap_steps", &O::gap_steps, 1.0, 1000.0,
              "more beams than this between two returns always cut"},
        Field{"sigma_factor", &O::sigma_factor, 0.0, 20.0, "allowance for range noise, in sigmas"},
        Field{"along_m", &O::along_m, 0.0, 20.0,
              "the widest gap that a straight face may have between two beams"},
        Field{"notch_m", &O::notch_m, 0.0, 10.0,
              "an outline dented by more than this and noise is cut there; 0: never"},
        Field{"min_points", &O::min_points, 1, 1000, "smaller clusters are dropped"},
    };
  }
};

/// Follows surfaces, for sensors whose beams see a few points of each road user.
///
/// 1. Neighbours in bearing belong together as in Breakpoint [Borges2004].
/// 2. So do neighbouring beams up to `along_m` apart that lie on one straight face with the next
///    beam on either side. On a line 1 / r = A cos theta + B sin theta, and noise of 1 / r is
///    sigma_r / r^2: the third of three beams is where the other two say, within `sigma_factor`. A
///    car's flank at grazing incidence is followed from its corner on, and a gap that jumps
///    sideways, from a pedestrian to the wall behind, is not. No beam may miss: through the gap
///    between two cars standing in line a beam passes, unless beams are wider apart than the cars.
/// 3. An outline with a notch is cut there, see NotchCutter.
///
/// Owns its working memory: after the first scans nothing is allocated.
class Surface {
 public:
  explicit Surface(SurfaceOptions options = {}) : options_(options) {}
  /// The result stays valid until the next call.
  const Clusters& operator()(const VirtualScan& scan);

 private:
  void follow(const VirtualScan& scan);

  SurfaceOptions options_;
  DisjointSets sets_;
  std::vector<std::uint32_t> labels_;
  Gatherer gather_;
  NotchCutter cut_;
};

}  // namespace scanfuse::segment
