#pragma once

#include "scanfuse/simulate/mesh.hpp"

namespace scanfuse::simulate {

/// A straight road along x with what stands beside it.
struct RoadOptions {
  double from_x_m = -30;
  double to_x_m = 250;
  double right_y_m = -2;  ///< edges of the carriageway: curbs
  double left_y_m = 5.4;
  double verge_m = 1.2;  ///< from the curb to the middle of the bushes
  double bushes = 0.8;   ///< share of the roadside with bushes
  bool trees = true;
  bool poles = true;
};
void add_road(Mesh& mesh, const RoadOptions& road, RandomStream& random);

void add_ground(Mesh& mesh, const Eigen::Vector2d& low_m, const Eigen::Vector2d& high_m);
void add_bush(Mesh& mesh, const Eigen::Vector2d& at_m, double radius_m, double height_m,
              RandomStream& random);
void add_tree(Mesh& mesh, const Eigen::Vector2d& at_m, RandomStream& random);
void add_pole(Mesh& mesh, const Eigen::Vector2d& at_m, double diameter_m, double height_m);
/// An upright wall along a segment.
void add_wall(Mesh& mesh, const Eigen::Vector2d& from_m, const Eigen::Vector2d& to_m,
              double thickness_m, double low_m, double high_m);
/// A beam on posts.
void add_guard_rail(Mesh& mesh, const Eigen::Vector2d& from_m, const Eigen::Vector2d& to_m);

}  // namespace scanfuse::simulate
