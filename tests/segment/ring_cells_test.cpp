#include "scanfuse/segment/ring_cells.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <utility>
#include <vector>

#include "scanfuse/core/random.hpp"

namespace scanfuse::segment {
namespace {

using Pair = std::pair<std::uint32_t, std::uint32_t>;

Pair in_order(std::uint32_t a, std::uint32_t b) { return std::minmax(a, b); }

/// Every pair of cells looked at.
std::set<Pair> by_brute_force(const RingGrid& grid, const std::vector<CellTable::Cell>& cells) {
  std::set<Pair> pairs;
  for (std::uint32_t i = 0; i < cells.size(); ++i) {
    for (std::uint32_t j = 0; j < cells.size(); ++j) {
      const std::int32_t around = grid.around(cells[i].row);
      const bool beside = i != j && cells[j].row == cells[i].row &&
                          cells[j].column == (cells[i].column + 1) % around;
      bool outside = false;
      if (cells[j].row == cells[i].row + 1) {
        const auto touched = grid.touched_outside(cells[i]);
        for (std::int32_t c = touched.first; c <= touched.last; ++c) {
          const std::int32_t n = touched.around;
          outside = outside || (c % n + n) % n == cells[j].column;
        }
      }
      if (beside || outside) pairs.insert(in_order(i, j));
    }
  }
  return pairs;
}

TEST(RingCells, FindEveryTouchingPair) {
  RandomStream random(11);
  RingCells cells;
  for (int round = 0; round < 60; ++round) {
    RingGrid grid;
    grid.lay_out({random.uniform(0.3, 3), random.uniform(0, 0.3), random.uniform(0.5, 5), 12});
    std::vector<float> bearings;
    for (int i = 0; i < 150; ++i) bearings.push_back(static_cast<float>(random.uniform(-kPi, kPi)));
    std::ranges::sort(bearings);
    cells.reset(static_cast<std::size_t>(grid.rings()));
    std::vector<CellTable::Cell> listed;
    for (const float bearing : bearings) {
      const auto cell = grid.cell(static_cast<float>(random.uniform(0, 11.9)), bearing);
      const std::uint32_t number = cells.insert(cell);
      if (number == listed.size()) listed.push_back(cell);
      ASSERT_EQ(listed[number].row, cell.row);
      ASSERT_EQ(listed[number].column, cell.column);
    }
    ASSERT_EQ(cells.size(), listed.size());
    std::set<Pair> pairs;
    cells.for_neighbours(grid, [&](auto a, auto b) { pairs.insert(in_order(a, b)); });
    EXPECT_EQ(pairs, by_brute_force(grid, listed)) << round;
  }
}

}  // namespace
}  // namespace scanfuse::segment
