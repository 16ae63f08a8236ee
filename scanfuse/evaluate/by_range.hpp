#pragma once

#include <map>
#include <optional>
#include <vector>

#include "scanfuse/evaluate/clear.hpp"
#include "scanfuse/evaluate/sequence.hpp"
#include "scanfuse/types/object_class.hpp"

namespace scanfuse::evaluate {

/// Of one class between two ranges from the ego vehicle.
struct RangeMetrics {
  double from_m = 0;
  double to_m = 0;
  std::int64_t objects = 0;
  std::int64_t tracks = 0;
  std::optional<double> precision;  ///< of the tracks said to be of the class
  std::optional<double> recall;     ///< of the objects of the class
};

/// Rings of `ring_m` metres, from 0 to the farthest that holds an object or a track (100 at most).
[[nodiscard]] std::map<ObjectClass, std::vector<RangeMetrics>> metrics_by_range(
    const Sequence& sequence, const std::vector<std::vector<MatchedPair>>& matches, double ring_m);

}  // namespace scanfuse::evaluate
