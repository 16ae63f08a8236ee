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

std::size_t CellTable::home(Cell cell) const {
  // Fibonacci hashing of the packed cell: the top bits of the product are well mixed.
  const std::uint64_t packed =
      (static_cast<std::uint64_t>(static_cast<std::uint32_t>(cell.row)) << 32) |
      static_cast<std::uint32_t>(cell.column);
  const std::uint64_t mixed = (packed ^ (packed >> 29)) * 0x9e3779b97f4a7c15ULL;
  return static_cast<std::size_t>((mixed ^ (mixed >> 32)) * 0xd1342543de82ef95ULL >> shift_);
}

std::uint32_t CellTable::insert(Cell cell) {
  for (std::size_t i = home(cell);; i = (i + 1) & (slots_.size() - 1)) {
    Slot& slot = slots_[i];
    if (slot.epoch != epoch_) {
      slot = {cell, static_cast<std::uint32_t>(cells_.size()), epoch_};
      cells_.push_back(cell);
      return slot.number;
    }
    if (slot.cell.row == cell.row && slot.cell.column == cell.column) return slot.number;
  }
}

std::uint32_t CellTable::find(Cell cell) const {
  for (std::size_t i = home(cell);; i = (i + 1) & (slots_.size() - 1)) {
    const Slot& slot = slots_[i];
    if (slot.epoch != epoch_) return kNone;
    if (slot.cell.row == cell.row && slot.cell.column == cell.column) return slot.number;
  }
}

}  // namespace scanfuse::segment
