#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace scanfuse::segment {

/// The occupied cells of a grid of any extent, numbered in the order of their first appearance.
/// Memory follows the number of points, never the area; a lookup takes constant time.
class CellTable {
 public:
  static constexpr std::uint32_t kNone = 0xffffffffU;
  struct Cell {
    std::int32_t row = 0;
    std::int32_t column = 0;
  };

  /// Empties the table and makes room for `points` cells.
  void reset(std::size_t points);
  /// The number of the cell, given now if it is new.
  std::uint32_t insert(Cell cell);
  /// The number of the cell, or kNone when nothing lies in it.
  [[nodiscard]] std::uint32_t find(Cell cell) const;
  [[nodiscard]] std::size_t size() const { return cells_.size(); }
  [[nodiscard]] const Cell& operator[](std::uint32_t i) const { return cells_[i]; }

 private:
  struct Slot {
    Cell cell;
    std::uint32_t number = 0;
    std::uint32_t epoch = 0;  ///< slots of older scans count as empty: nothing is cleared
  };
  [[nodiscard]] std::size_t home(Cell cell) const;

  std::vector<Slot> slots_;
  std::vector<Cell> cells_;
  std::uint32_t epoch_ = 0;
  int shift_ = 64;
};

inline std::size_t CellTable::home(Cell cell) const {
  // Fibonacci hashing of the packed cell: the top bits of the product are well mixed.
  const std::uint64_t packed =
      (static_cast<std::uint64_t>(static_cast<std::uint32_t>(cell.row)) << 32) |
      static_cast<std::uint32_t>(cell.column);
  const std::uint64_t mixed = (packed ^ (packed >> 29)) * 0x9e3779b97f4a7c15ULL;
  return static_cast<std::size_t>((mixed ^ (mixed >> 32)) * 0xd1342543de82ef95ULL >> shift_);
}

inline std::uint32_t CellTable::insert(Cell cell) {
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

inline std::uint32_t CellTable::find(Cell cell) const {
  for (std::size_t i = home(cell);; i = (i + 1) & (slots_.size() - 1)) {
    const Slot& slot = slots_[i];
    if (slot.epoch != epoch_) return kNone;
    if (slot.cell.row == cell.row && slot.cell.column == cell.column) return slot.number;
  }
}

/// floor(value / size) as an index that no odd value can make undefined.
[[nodiscard]] inline std::int32_t cell_index(double value, double size) {
  constexpr double kLimit = 1e9;
  const double index = std::floor(value / size);
  if (!(index > -kLimit)) return static_cast<std::int32_t>(-kLimit);
  return static_cast<std::int32_t>(index < kLimit ? index : kLimit);
}

}  // namespace scanfuse::segment
