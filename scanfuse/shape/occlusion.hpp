#pragma once

#include <span>
#include <tuple>

#include "scanfuse/core/options.hpp"
#include "scanfuse/types/virtual_scan.hpp"

namespace scanfuse::shape {

struct OcclusionOptions {
  double nearer_by_m = 0.5;
  double beside_m = 0.5;
  int columns = 3;

  static constexpr auto fields() {
    using O = OcclusionOptions;
    return std::tuple{
        Field{"nearer_by_m", &O::nearer_by_m, 0.0, 100.0,
              "a neighbour nearer by this much may hide the rest of an object"},
        Field{"beside_m", &O::beside_m, 0.0, 100.0,
              "a neighbour no farther behind than this may be a part of the object"},
        Field{"columns", &O::columns, 1, 100, "how many columns beyond an end are looked at"},
    };
  }
};

struct CutEnds {
  bool left = false;  ///< at the end of larger bearing
  bool right = false;
};

/// Which ends of an object were not seen: something nearer stands beside its outermost point and
/// may hide the rest; or the next column goes on at about the same range, so that the cut was made
/// by clustering; or the field of view ends. `first` and `last` index scan.points: the ends of
/// smallest and largest bearing.
[[nodiscard]] CutEnds find_cut_ends(const VirtualScan& scan, std::uint32_t first,
                                    std::uint32_t last, const OcclusionOptions& options);

}  // namespace scanfuse::shape
