#include "scanfuse/simulate/roadside.hpp"

#include <cmath>

namespace scanfuse::simulate {
namespace {

const Surface kAsphalt{0.22F, 0.15F, true};
const Surface kStone{0.35F, 0.15F, false};
const Surface kLeaf{0.4F, 0.2F, false};
const Surface kBark{0.25F, 0.2F, false};
const Surface kSteel{0.4F, 0.1F, false};

Pose3 upright(const Eigen::Vector2d& at_m, double z_m, double heading_rad = 0) {
  return Pose3::from_planar({at_m.x(), at_m.y(), heading_rad}, z_m);
}

// Bushes come in runs with gaps between them, never in step on the two sides.
void add_bushes(Mesh& mesh, const RoadOptions& road, double side, RandomStream& random) {
  const double edge = side > 0 ? road.left_y_m : road.right_y_m;
  for (double x = road.from_x_m; x < road.to_x_m;) {
    const double run_end = x + random.uniform(6, 25);
    for (; x < run_end && x < road.to_x_m; x += random.uniform(0.8, 1.4)) {
      const double away = road.verge_m + random.uniform(-0.2, 0.6);
      add_bush(mesh, {x, edge + side * away}, random.uniform(0.45, 0.8), random.uniform(0.8, 1.6),
               random);
    }
    x = run_end + random.uniform(6, 25) * (1 - road.bushes) / std::max(road.bushes, 0.05);
  }
}

void add_roadside(Mesh& mesh, const RoadOptions& road, double side, RandomStream& random) {
  const double edge = side > 0 ? road.left_y_m : road.right_y_m;
  const double middle = (road.from_x_m + road.to_x_m) / 2;
  add_box(mesh, upright({middle, edge + side * 0.1}, 0.06),
          {road.to_x_m - road.from_x_m, 0.2, 0.12}, kStone);
  if (road.bushes > 0) add_bushes(mesh, road, side, random);
  if (road.trees) {
    for (double x = road.from_x_m + random.uniform(0, 8); x < road.to_x_m;
         x += random.uniform(6, 11)) {
      add_tree(mesh, {x, edge + side * (road.verge_m + random.uniform(1.2, 2.5))}, random);
    }
  }
  if (road.poles) {
    for (double x = road.from_x_m + random.uniform(0, 25); x < road.to_x_m;
         x += random.uniform(25, 35)) {
      add_pole(mesh, {x, edge + side * 0.6}, random.uniform(0.12, 0.22), 5);
    }
  }
}

}  // namespace

void add_ground(Mesh& mesh, const Eigen::Vector2d& low_m, const Eigen::Vector2d& high_m) {
  const Eigen::Vector2d middle = (low_m + high_m) / 2, size = high_m - low_m;
  add_box(mesh, upright(middle, -0.5), {size.x(), size.y(), 1.0}, kAsphalt);
}

void add_bush(Mesh& mesh, const Eigen::Vector2d& at_m, double radius_m, double height_m,
              RandomStream& random) {
  const int facets = static_cast<int>(150 * radius_m * height_m / 0.6);
  add_leaves(mesh, {at_m.x(), at_m.y(), height_m / 2}, {radius_m, radius_m, height_m / 2}, facets,
             0.09, kLeaf, random);
}

void add_tree(Mesh& mesh, const Eigen::Vector2d& at_m, RandomStream& random) {
  const double trunk = random.uniform(0.18, 0.4), crown = random.uniform(2.4, 3.2);
  add_loft(mesh, shifted(ellipse(trunk, trunk, 9), at_m), 0,
           shifted(ellipse(0.8 * trunk, 0.8 * trunk, 9), at_m), crown, kBark);
  add_leaves(mesh, {at_m.x(), at_m.y(), crown + 1.2}, {1.6, 1.6, 1.4}, 160, 0.16, kLeaf, random);
}

void add_pole(Mesh& mesh, const Eigen::Vector2d& at_m, double diameter_m, double height_m) {
  const auto section = shifted(ellipse(diameter_m, diameter_m, 9), at_m);
  add_loft(mesh, section, 0, section, height_m, kSteel);
}

void add_wall(Mesh& mesh, const Eigen::Vector2d& from_m, const Eigen::Vector2d& to_m,
              double thickness_m, double low_m, double high_m) {
  const Eigen::Vector2d along = to_m - from_m;
  add_box(mesh,
          upright((from_m + to_m) / 2, (low_m + high_m) / 2, std::atan2(along.y(), along.x())),
          {along.norm(), thickness_m, high_m - low_m}, kStone);
}

void add_guard_rail(Mesh& mesh, const Eigen::Vector2d& from_m, const Eigen::Vector2d& to_m) {
  const Eigen::Vector2d along = to_m - from_m;
  const double heading = std::atan2(along.y(), along.x());
  add_box(mesh, upright((from_m + to_m) / 2, 0.6, heading), {along.norm(), 0.08, 0.31}, kSteel);
  const int posts = static_cast<int>(along.norm() / 2);
  for (int i = 0; i <= posts; ++i) {
    add_box(mesh, upright(from_m + along * i / std::max(posts, 1), 0.35, heading), {0.1, 0.15, 0.7},
            kSteel);
  }
}

void add_road(Mesh& mesh, const RoadOptions& road, RandomStream& random) {
  add_ground(mesh, {road.from_x_m - 100, -150}, {road.to_x_m + 150, 150});
  add_roadside(mesh, road, -1, random);
  add_roadside(mesh, road, 1, random);
}

}  // namespace scanfuse::simulate
