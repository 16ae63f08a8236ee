#pragma once

#include <span>
#include <tuple>

#include "scanfuse/core/options.hpp"
#include "scanfuse/types/virtual_scan.hpp"

namespace scanfuse::shape {

struct OcclusionOptions {
  double nearer_by_m = 0.5;
  int columns = 3;

  static constexpr auto fields() {
    using O = OcclusionOptions;
    return std::tuple{
        Field{"nearer_by_m", &O::nearer_by_m, 0.0, 100.0,
              "a neighbour nearer by this much may hide the rest of an object"},
        Field{"columns", &O::columns, 1, 100, "how many columns beyond an end are looked at"},
    };
  }
};

struct CutEnds {
  bool left = false;  ///< at the end of larger bearing
  bool right = false;
};

/// Whether something nearer stands beside an object's outermost points, so that the object may go
/// on behind it. `first` and `last` index scan.points: the ends of smallest and largest bearing.
[[nodiscard]] CutEnds find_cut_ends(const VirtualScan& scan, std::uint32_t first,
                                    std::uint32_t last, const OcclusionOptions& options);

}  // namespace scanfuse::shape
