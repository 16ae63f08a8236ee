#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "scanfuse/segment/cell_table.hpp"
#include "scanfuse/segment/ring_grid.hpp"

namespace scanfuse::segment {

/// The occupied cells of a RingGrid, numbered in the order of their first appearance, for points
/// that come in order of bearing. The cells of a ring then come in order too: each ring is a list,
/// and neighbours on two rings are found by walking both, which is faster than a CellTable
/// (`scanfuse bench speed`, segment). Memory follows the number of points and rings.
class RingCells {
 public:
  /// Empties it; `rings` as RingGrid has them.
  void reset(std::size_t rings);
  /// The number of the cell, given now if it is new. On each ring, columns must not fall.
  std::uint32_t insert(CellTable::Cell cell);
  [[nodiscard]] std::size_t size() const { return cells_.size(); }

  /// Calls visit(a, b) with the numbers of every two cells that touch.
  template <class Visit>
  void for_neighbours(const RingGrid& grid, Visit visit);

 private:
  static constexpr std::uint32_t kNone = CellTable::kNone;
  struct Cell {
    std::int32_t row = 0;
    std::int32_t column = 0;
    std::uint32_t next = kNone;  ///< on the same ring
  };
  struct Ring {
    std::uint32_t epoch = 0;  ///< rings of older scans count as empty: nothing is cleared
    std::uint32_t first = kNone;
    std::uint32_t last = kNone;
    std::uint32_t place = kNone;  ///< before it, nothing touches the next cell of the ring inside
  };
  template <class Visit>
  void for_next_on_ring(std::uint32_t i, std::int32_t around, Visit visit) const;
  template <class Visit>
  void for_outer(std::uint32_t i, const RingGrid::Columns& touched, Visit visit);

  std::vector<Cell> cells_;
  std::vector<Ring> rings_;
  std::uint32_t epoch_ = 0;
};

inline void RingCells::reset(std::size_t rings) {
  if (rings_.size() != rings || ++epoch_ == 0) {
    rings_.assign(rings, {});
    epoch_ = 1;
  }
  cells_.clear();
}

inline std::uint32_t RingCells::insert(CellTable::Cell cell) {
  Ring& ring = rings_[static_cast<std::size_t>(cell.row)];
  const auto number = static_cast<std::uint32_t>(cells_.size());
  if (ring.epoch != epoch_) {
    ring = {epoch_, number, number, number};
  } else {
    Cell& before = cells_[ring.last];
    if (before.column == cell.column) return ring.last;
    before.next = number;
    ring.last = number;
  }
  cells_.push_back({cell.row, cell.column, kNone});
  return number;
}

template <class Visit>
void RingCells::for_neighbours(const RingGrid& grid, Visit visit) {
  for (std::uint32_t i = 0; i < cells_.size(); ++i) {
    const CellTable::Cell here{cells_[i].row, cells_[i].column};
    for_next_on_ring(i, grid.around(here.row), visit);
    if (here.row + 1 < grid.rings()) for_outer(i, grid.touched_outside(here), visit);
  }
}

template <class Visit>
void RingCells::for_next_on_ring(std::uint32_t i, std::int32_t around, Visit visit) const {
  const Cell& here = cells_[i];
  if (here.next != kNone && cells_[here.next].column == here.column + 1) visit(i, here.next);
  if (here.column + 1 < around || around == 1) return;
  const std::uint32_t first = rings_[static_cast<std::size_t>(here.row)].first;
  if (cells_[first].column == 0) visit(i, first);
}

template <class Visit>
void RingCells::for_outer(std::uint32_t i, const RingGrid::Columns& touched, Visit visit) {
  Ring& ring = rings_[static_cast<std::size_t>(cells_[i].row) + 1];
  if (ring.epoch != epoch_) return;
  if (touched.cross_the_seam()) {
    for (std::uint32_t j = ring.first; j != kNone; j = cells_[j].next) {
      if (touched.contain(cells_[j].column)) visit(i, j);
    }
    return;
  }
  std::uint32_t& place = ring.place;
  while (place != kNone && cells_[place].column < touched.first) place = cells_[place].next;
  for (std::uint32_t j = place; j != kNone && cells_[j].column <= touched.last;
       j = cells_[j].next) {
    visit(i, j);
  }
}

}  // namespace scanfuse::segment
