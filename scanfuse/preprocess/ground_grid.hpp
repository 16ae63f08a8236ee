#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace scanfuse::preprocess {

/// One return in the levelled sensor frame, as the stages of this room hand it on.
struct LevelPoint {
  float x_m = 0;
  float y_m = 0;
  float z_m = 0;
  float range_m = 0;         ///< in the plane
  float bearing_rad = 0;     ///< good to 1e-5 rad; may be left 0 where the column is known
  std::uint32_t source = 0;  ///< index into Scan::returns
  std::uint32_t column = 0;  ///< or BeamBearings::kNoColumn
  std::int16_t layer = 0;
};

/// The height of the ground around the sensor, from a cloud. The lowest point of each cell (2 deg
/// sectors, rings of 1 m growing to 8 % of the range) is followed outwards: it is ground while it
/// lies where the ground seen so far leads to, within 0.12 m and a slope of 6 %; vehicles and walls
/// rise faster and are bridged. A cell that stands out from the sectors beside it takes their
/// median.
class GroundGrid {
 public:
  GroundGrid();

  /// `sensor_height_m`: over flat ground. Without it, or where the data contradict it by more than
  /// 0.5 m, the start is the median of the lowest points of the cells from 3 to 20 m.
  void estimate(std::span<const LevelPoint> points, std::optional<double> sensor_height_m);

  /// z of the ground in the levelled sensor frame.
  [[nodiscard]] float height_m(float range_m, float bearing_rad) const;

 private:
  struct Cell {
    float low_m = 0;    ///< z of the lowest point
    float range_m = 0;  ///< where it lies
    bool seen = false;
  };
  [[nodiscard]] std::size_t ring(float range_m) const;
  [[nodiscard]] static std::size_t sector(float bearing_rad);
  void collect(std::span<const LevelPoint> points);
  [[nodiscard]] float start_height(std::optional<double> sensor_height_m);
  void grow(std::size_t sector, float start_m);
  void smooth();

  std::vector<float> middles_;       ///< range of each ring
  std::vector<std::uint8_t> rings_;  ///< ring at each half metre
  std::vector<Cell> cells_;          ///< sector by sector
  std::vector<float> raw_;           ///< ground at each cell's middle, as grown
  std::vector<float> heights_;       ///< smoothed
  std::vector<float> scratch_;
};

}  // namespace scanfuse::preprocess
