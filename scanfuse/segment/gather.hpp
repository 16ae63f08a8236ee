#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "scanfuse/types/clusters.hpp"

namespace scanfuse::segment {

/// Turns one label a point into Clusters: in the order of their first point, indices ascending.
class Gatherer {
 public:
  static constexpr std::uint32_t kNoise = 0xffffffffU;

  /// `labels[i]` is any number below `label_count`, or kNoise. Groups of fewer than `min_points`
  /// are dropped. The result stays valid until the next call.
  const Clusters& operator()(std::span<const std::uint32_t> labels, std::size_t label_count,
                             int min_points);

 private:
  Clusters clusters_;
  std::vector<std::uint32_t> counts_;
  std::vector<std::uint32_t> places_;
};

}  // namespace scanfuse::segment
