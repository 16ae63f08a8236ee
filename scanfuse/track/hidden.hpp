#pragma once

#include <Eigen/Core>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "scanfuse/geometry/box.hpp"
#include "scanfuse/types/detection.hpp"

namespace scanfuse::track {

/// The bearings that a box covers, seen from outside it.
struct Sector {
  double middle_rad = 0;  ///< bearing of the box's centre
  double right_rad = 0;   ///< smallest and largest, relative to `middle_rad`
  double left_rad = 0;
  double centre_range_m = 0;
  double nearest_corner_m = 0;
};

/// Nothing when the viewer stands in the box, or so near that it fills half of the view.
[[nodiscard]] std::optional<Sector> sector_of(const Box2& box, const Eigen::Vector2d& viewer_m);

/// What of the plane the detections of one scan hide from the sensor. Detections of one scan are
/// seen from one place. Keeps its memory: grown once, nothing is allocated.
class Shadows {
 public:
  void cast(std::span<const Detection> detections);

  /// The share of the box's bearings, 0..1, before which a detection stands with its centre nearer
  /// than the box's nearest corner.
  [[nodiscard]] double hidden_share(const Box2& box);

 private:
  Eigen::Vector2d viewer_m_ = Eigen::Vector2d::Zero();
  std::vector<Sector> sectors_;
  std::vector<std::pair<double, double>> cut_;  ///< of the box's sector, from right to left
};

}  // namespace scanfuse::track
