#pragma once

#include <Eigen/Core>
#include <cstdint>

#include "scanfuse/geometry/box.hpp"
#include "scanfuse/types/object_class.hpp"

namespace scanfuse {

/// What one scan shows of a shape, before any prior: a track averages it to tell its class. Real
/// metres, whatever the scale of the scene. All zero: not told.
struct ShapeCues {
  double range_m = 0;
  double breadth_m = 0;      ///< of the box, across the line of sight
  double depth_m = 0;        ///< standard deviation of the points' ranges
  double fill = 0;           ///< points against those expected at its range and breadth
  double height_m = 0;       ///< between its lowest and highest return; 0 for one layer
  double layered_share = 0;  ///< of its points, those that several layers see; 0: nothing is known
  double layer_depth_m = 0;  ///< how far apart those layers see it
};

/// One object seen in one scan. Planar, in the frame of the stage that made it: the levelled sensor
/// frame out of `classify`, the tracking (world) frame once the pipeline has moved it there.
struct Detection {
  ObjectClass object_class = ObjectClass::kVehicle;
  double score = 1;  ///< 0..1
  /// By ObjectClass, adding up to 1; all zero: the recogniser tells no probabilities.
  ClassProbabilities class_probability{};
  ShapeCues cues;
  Box2 box;             ///< heading known mod pi at best, mod pi/2 when one face is seen
  double z_m = 0;       ///< centre height above the frame's origin
  double height_m = 0;  ///< 0: not known
  /// Of centre x, y (m) and heading (rad), as if the extent were right: it says how well the seen
  /// side is placed. What an uncertain extent adds stands in the two variances below.
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Identity();
  double var_length_m2 = 1;
  double var_width_m2 = 1;
  bool length_seen = false;  ///< both ends of the long side were seen; else a prior or lower bound
  bool width_seen = false;
  int faces_seen = 0;              ///< 0: not known, 1 or 2
  bool left_end_occluded = false;  ///< its end of larger bearing is hidden: by something nearer, a
                                   ///< neighbouring cluster, or the edge of the view
  bool right_end_occluded = false;
  int points = 0;
  double time_offset_s =
      0;  ///< when its beams were fired, after the scan's stamp: mean of its points
  Eigen::Vector2d seen_from_m = Eigen::Vector2d::Zero();  ///< the sensor, in the same frame
  /// Middle of the longest visible line: the position of [Lu2018], 1.7 to 2.3 m from the centre.
  Eigen::Vector2d visible_middle_m = Eigen::Vector2d::Zero();
};

}  // namespace scanfuse
