#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

namespace scanfuse::associate {

/// Points of the plane sorted into square cells: finds those near a place without looking at all.
class PositionGrid {
 public:
  /// `cell_m` > 0 is the largest radius that may be asked for.
  explicit PositionGrid(double cell_m) : cell_m_(cell_m) {}

  void clear() { entries_.clear(); }
  /// Empties the grid, keeping its memory, and gives its cells another size.
  void reset(double cell_m) {
    cell_m_ = cell_m;
    entries_.clear();
  }
  void add(const Eigen::Vector2d& position_m, int index) {
    entries_.emplace_back(key(cell(position_m.x()), cell(position_m.y())), index);
  }
  /// To be called once after the last `add`. Indices within a cell come back in ascending order.
  void sort() { std::sort(entries_.begin(), entries_.end()); }

  /// Calls `visit(index)` for every point of the nine cells around `position_m`: all that lie
  /// within `cell_m`, and some beyond.
  template <class Visit>
  void near(const Eigen::Vector2d& position_m, Visit&& visit) const {
    const std::int64_t x = cell(position_m.x()), y = cell(position_m.y());
    for (std::int64_t column = x - 1; column <= x + 1; ++column) {
      const std::uint64_t last = key(column, y + 1);
      auto entry = std::lower_bound(entries_.begin(), entries_.end(),
                                    std::pair<std::uint64_t, int>{key(column, y - 1), -1});
      for (; entry != entries_.end() && entry->first <= last; ++entry) visit(entry->second);
    }
  }

 private:
  [[nodiscard]] std::int64_t cell(double coordinate_m) const {
    return static_cast<std::int64_t>(std::floor(std::clamp(coordinate_m / cell_m_, -1e9, 1e9)));
  }
  static std::uint64_t key(std::int64_t column, std::int64_t row) {
    constexpr std::int64_t kMiddle = std::int64_t{1} << 31;
    return (static_cast<std::uint64_t>(column + kMiddle) << 32) |
           static_cast<std::uint64_t>(row + kMiddle);
  }

  double cell_m_;
  std::vector<std::pair<std::uint64_t, int>> entries_;
};

}  // namespace scanfuse::associate
