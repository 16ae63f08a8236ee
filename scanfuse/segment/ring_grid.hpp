#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "scanfuse/geometry/angles.hpp"
#include "scanfuse/segment/cell_table.hpp"

namespace scanfuse::segment {

/// A polar grid around the sensor. Its cells are max(smallest, growth * r) wide across the line of
/// sight and `depth` times that along it: rows are rings, columns count from -pi around each ring.
class RingGrid {
 public:
  struct Shape {
    double smallest_m = 0.1;
    double growth = 0.01;
    double depth = 4;
    double range_max_m = 120;
    [[nodiscard]] bool operator==(const Shape&) const = default;
  };

  /// Lays the rings out; nothing happens when they stand so already.
  void lay_out(const Shape& shape);

  /// The cell at a range in [0, range_max_m) and a bearing in [-pi, pi].
  [[nodiscard]] CellTable::Cell cell(float range_m, float bearing_rad) const;

  [[nodiscard]] std::int32_t rings() const { return static_cast<std::int32_t>(counts_.size()); }
  /// Cells around a ring.
  [[nodiscard]] std::int32_t around(std::int32_t row) const {
    return counts_[static_cast<std::size_t>(row)];
  }

  /// Columns first to last of a ring; below 0 and from `around` on they go on at its other end.
  struct Columns {
    std::int32_t first = 0;
    std::int32_t last = 0;
    std::int32_t around = 1;
    [[nodiscard]] bool cross_the_seam() const { return first < 0 || last >= around; }
    [[nodiscard]] bool contain(std::int32_t column) const {
      return (column >= first && column <= last) || column - around >= first ||
             column + around <= last;
    }
  };
  /// Those on the ring outside that touch `cell`, which is not on the last ring.
  [[nodiscard]] Columns touched_outside(CellTable::Cell cell) const {
    const auto row = static_cast<std::size_t>(cell.row);
    const double scale = scales_[row];
    // Half a cell more at each end stands for the corners that touch on a square grid. One is added
    // and taken away again, so that the conversion rounds down.
    return {static_cast<std::int32_t>(cell.column * scale + 0.5) - 1,
            static_cast<std::int32_t>((cell.column + 1) * scale + 0.5), counts_[row + 1]};
  }

 private:
  static constexpr float kShortcutsPerMetre = 8;

  Shape shape_;
  std::vector<float> edges_;            ///< inner radius of each ring, and the outer end
  std::vector<std::int32_t> counts_;    ///< cells around each ring
  std::vector<double> scales_;          ///< cells of the next ring over those of each
  std::vector<std::int32_t> shortcut_;  ///< the ring at each multiple of kShortcut
};

inline CellTable::Cell RingGrid::cell(float range_m, float bearing_rad) const {
  const auto place =
      std::min(static_cast<std::size_t>(range_m * kShortcutsPerMetre), shortcut_.size() - 1);
  auto ring = static_cast<std::size_t>(shortcut_[place]);
  while (ring + 1 < counts_.size() && edges_[ring + 1] <= range_m) ++ring;
  const std::int32_t around = counts_[ring];
  const double turn = (static_cast<double>(bearing_rad) + kPi) / (2 * kPi);
  const auto column = static_cast<std::int32_t>(turn * around);
  return {static_cast<std::int32_t>(ring), std::clamp(column, 0, around - 1)};
}

}  // namespace scanfuse::segment
