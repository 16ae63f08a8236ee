#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "scanfuse/geometry/box.hpp"

namespace scanfuse {

/// A straight run of points: its ends in order of bearing, on the fitted line.
struct LineSegment {
  Eigen::Vector2d first_m = Eigen::Vector2d::Zero();
  Eigen::Vector2d last_m = Eigen::Vector2d::Zero();
  double rms_m = 0;  ///< distance of its points from the line
  int points = 0;

  [[nodiscard]] double length_m() const { return (last_m - first_m).norm(); }
  [[nodiscard]] double direction_rad() const {
    const Eigen::Vector2d d = last_m - first_m;
    return std::atan2(d.y(), d.x());
  }
};

/// What a cluster looks like: its lines, its box, which of it was seen. Levelled sensor frame.
struct Outline {
  std::vector<LineSegment> lines;  ///< in order of bearing
  /// Tight around the points, before any size prior; length along the longer face, or the only one.
  Box2 box;
  Eigen::Matrix3d covariance =
      Eigen::Matrix3d::Identity();  ///< of the seen corner or face: x, y, heading
  int faces_seen = 0;
  /// The end of larger bearing may go on: something nearer hides it, or the field of view ends.
  bool left_end_occluded = false;
  bool right_end_occluded = false;
  int points = 0;
  double time_offset_s =
      0;               ///< when its beams were fired, after the scan's stamp: mean of its points
  double z_low_m = 0;  ///< of the returns that its points stand for
  double z_high_m = 0;
  double var_range_m2 = 0;   ///< variance of the points' ranges, a feature of [Guo]
  double residual_m = 0;     ///< rms distance of all points from the seen faces
  double inlier_share = 1;   ///< of the points, those within the noise of a seen face
  double coverage = 1;       ///< points per column that nothing nearer hides, from end to end
  double roundness = 0;      ///< smaller by larger principal deviation of the points, 0..1
  double beam_gap_m = 0;     ///< from beam to beam at its range; 0: not known
  double mean_support = 1;   ///< layers that agree, mean over the points: tells of height
  double layered_share = 0;  ///< of the points, those that several layers agree on
  double layer_depth_m = 0;  ///< how far apart layers see the same bearing, mean over those points
  double var_length_m2 = 0;  ///< of the box's extent between two free ends
  double var_width_m2 = 0;
  std::uint32_t cluster = 0;   ///< which cluster of the scan
  std::int32_t expected = -1;  ///< which object that a track expects lies here; -1: none
};

}  // namespace scanfuse
