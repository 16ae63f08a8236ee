#include "scanfuse/segment/ring_grid.hpp"

#include <algorithm>
#include <cmath>

#include "scanfuse/geometry/angles.hpp"

namespace scanfuse::segment {
void RingGrid::lay_out(const Shape& shape) {
  if (shape == shape_ && !counts_.empty()) return;
  shape_ = shape;
  edges_.clear();
  counts_.clear();
  scales_.clear();
  shortcut_.clear();
  double inner = 0;
  while (inner < shape.range_max_m) {
    const double width = std::max({shape.smallest_m, shape.growth * inner, 0.01});
    const double depth = std::max(shape.depth, 0.2) * width;
    edges_.push_back(static_cast<float>(inner));
    counts_.push_back(
        std::max(1, static_cast<std::int32_t>(std::ceil(2 * kPi * (inner + depth / 2) / width))));
    inner += depth;
  }
  edges_.push_back(static_cast<float>(inner));
  for (std::size_t i = 0; i + 1 < counts_.size(); ++i) {
    scales_.push_back(static_cast<double>(counts_[i + 1]) / counts_[i]);
  }
  std::int32_t ring = 0;
  const auto shortcuts = static_cast<std::size_t>(inner * kShortcutsPerMetre) + 2;
  for (std::size_t i = 0; i < shortcuts; ++i) {
    const float range = static_cast<float>(i) / kShortcutsPerMetre;
    while (ring + 1 < static_cast<std::int32_t>(counts_.size()) &&
           edges_[static_cast<std::size_t>(ring) + 1] <= range) {
      ++ring;
    }
    shortcut_.push_back(ring);
  }
}

}  // namespace scanfuse::segment
