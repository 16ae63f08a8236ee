#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "scanfuse/types/turntable.hpp"

namespace scanfuse::calibrate {

/// Ranges of all scans over one raster of beam angles: row a profile, column a beam; NaN where
/// nothing came back.
struct RangeImage {
  std::size_t profiles = 0;
  std::size_t beams = 0;
  double first_angle_rad = 0;  ///< of column 0
  double step_rad = 0;         ///< from column to column
  std::vector<double> range_m;

  [[nodiscard]] double at(std::size_t profile, std::size_t beam) const {
    return range_m[profile * beams + beam];
  }
  /// NaN outside the raster too.
  [[nodiscard]] double near(std::ptrdiff_t profile, std::ptrdiff_t beam) const;
};

/// The raster that the scans' angles follow (the median step between neighbours), and the column of
/// each return: `columns[profile][k]`; -1 where two returns fall on one column (the first has it).
struct RangeRaster {
  RangeImage image;
  std::vector<std::vector<int>> columns;
};
[[nodiscard]] RangeRaster range_raster(std::span<const TurntablePosition> scans);

/// Standard deviation of the ranges from second differences along the beams, robust against edges;
/// 0 where there are none.
[[nodiscard]] double range_noise(const RangeImage& image);

}  // namespace scanfuse::calibrate
