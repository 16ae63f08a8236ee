#include "scanfuse/segment/cell_table.hpp"

#include <algorithm>
#include <bit>

namespace scanfuse::segment {

void CellTable::reset(std::size_t points) {
  const std::size_t wanted = std::bit_ceil(std::max<std::size_t>(2 * points, 64));
  if (slots_.size() < wanted) {
    slots_.assign(wanted, {});
    epoch_ = 0;
  }
  if (++epoch_ == 0) {
    std::ranges::fill(slots_, Slot{});
    epoch_ = 1;
  }
  shift_ = 64 - std::countr_zero(slots_.size());
  cells_.clear();
}

}  // namespace scanfuse::segment
