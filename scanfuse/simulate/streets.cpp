#include <algorithm>
#include <cmath>

#include "scanfuse/simulate/cast.hpp"
#include "scanfuse/simulate/roadside.hpp"
#include "scanfuse/simulate/scenarios.hpp"

namespace scanfuse::simulate {
namespace {

constexpr double kCrossX = 48;  ///< middle of the crossing street

void add_corners(Mesh& mesh, RandomStream& random) {
  for (const double side : {-1.0, 1.0}) {
    const double edge = side > 0 ? 5.4 : -2.0;
    for (const double along : {-1.0, 1.0}) {
      const double corner_x = kCrossX + along * 9;
      const Eigen::Vector2d corner(corner_x, edge + side * 7);
      add_wall(mesh, corner, {corner_x + along * 30, corner.y()}, 0.3, 0, 3);
      add_wall(mesh, corner, {corner_x, corner.y() + side * 30}, 0.3, 0, 3);
      add_pole(mesh, {corner_x - along * 1.5, edge + side * 1.0}, 0.2, 5);
      for (int i = 0; i < 8; ++i) {
        add_bush(mesh,
                 {corner_x + along * random.uniform(2, 28), edge + side * random.uniform(2, 5)},
                 random.uniform(0.4, 0.8), random.uniform(0.7, 1.5), random);
      }
    }
  }
}

void add_clutter(Mesh& mesh, double to_x_m, RandomStream& random) {
  for (double x = 0; x < to_x_m; x += random.uniform(4, 9)) {
    const double y = random.chance(0.5) ? random.uniform(6.6, 8.2) : random.uniform(-7.6, -5.0);
    switch (random.below(4)) {
      case 0:
        add_pole(mesh, {x, y}, random.uniform(0.06, 0.3), random.uniform(2, 6));
        break;
      case 1:
        add_bush(mesh, {x, y}, random.uniform(0.3, 0.8), random.uniform(0.5, 1.6), random);
        break;
      case 2:
        add_wall(mesh, {x, y}, {x + random.uniform(0.4, 1.2), y}, random.uniform(0.3, 0.9), 0,
                 random.uniform(0.6, 1.4));
        break;
      default:
        add_tree(mesh, {x, y}, random);
    }
  }
}

/// Poles and trees along a course, behind its edges.
void add_bend_side(Mesh& mesh, const Course& lane, RandomStream& random) {
  const auto& poses = lane.poses();
  for (std::size_t i = 0; i < poses.size(); i += 7 + random.below(6)) {
    const bool left = random.chance(0.5);
    const double away = left ? random.uniform(7, 9) : random.uniform(-6, -4);
    const Eigen::Vector2d at = poses[i] * Eigen::Vector2d(0, away);
    random.chance(0.5) ? add_pole(mesh, at, random.uniform(0.1, 0.3), 5)
                       : add_tree(mesh, at, random);
  }
}

/// A left-hand bend of 90 degrees that the ego car takes at up to 0.22 rad/s, and cars that come
/// the other way: constant curvature between two halves of it.
World bend(RandomStream& random, Course& lane) {
  World world;
  world.frames = 150;
  add_ground(world.fixed, {-150, -150}, {250, 250});
  constexpr double kSpeed = 7, kTurn = 0.22 / kSpeed;
  lane = Course({}).run(12).arc(8, 4 * kTurn).arc(42, 42 * kTurn).arc(8, 4 * kTurn).run(110);
  world.ego = lane.drive(0, steady(kSpeed));
  add_bend_side(world.fixed, lane, random);
  return world;
}

void add_oncoming(const Cast& cast, const Course& lane, RandomStream& random) {
  const double speed = random.uniform(7, 8.5);
  const Course way = lane.back(3.4);
  const double length = static_cast<double>(way.poses().size());
  for (double ahead = random.uniform(25, 35); ahead < 170; ahead += random.uniform(24, 38)) {
    cast.car(way.drive((ahead - length) / speed, steady(speed)));
  }
}

void add_traffic(const Cast& cast, double ego_speed, RandomStream& random) {
  for (double x = random.uniform(18, 26); x < 60; x += random.uniform(16, 26)) {
    cast.car(straight({x, random.uniform(-0.3, 0.3), 0}, ego_speed + 0.02 * x));
  }
  const double oncoming = random.uniform(6, 10);
  for (double x = random.uniform(15, 35); x < 190; x += random.uniform(22, 45)) {
    const Pose2 start{x, 3.5 + random.uniform(-0.2, 0.2), kPi};
    random.chance(0.15) ? cast.truck(straight(start, oncoming))
                        : cast.car(straight(start, oncoming));
  }
  for (double x = random.uniform(8, 18); x < 130; x += random.uniform(7, 24)) {
    cast.car(standing({x, -3.5 + random.uniform(-0.1, 0.1), random.normal(0, 0.02)}));
  }
}

void add_people(const Cast& cast, double ego_speed, RandomStream& random) {
  for (int i = 0; i < 7; ++i) {
    const double side = random.chance(0.5) ? 6.4 : -5.6;
    const double heading = random.chance(0.5) ? 0.0 : kPi;
    const double speed = random.chance(0.15) ? 0.0 : random.uniform(0.8, 1.8);
    const Pose2 start{random.uniform(8, 90), side + random.uniform(-0.4, 0.4), heading};
    cast.pedestrian(speed > 0 ? straight(start, speed) : standing(start));
  }
  for (double x = random.uniform(8, 14); x < 60; x += random.uniform(15, 25)) {
    cast.cyclist(straight({x, -1.9, 0}, ego_speed * 0.75 + 0.01 * x));
  }
  for (double x = random.uniform(20, 40); x < 150; x += random.uniform(25, 50)) {
    cast.cyclist(straight({x, 5.4, kPi}, 4.5));
  }
  for (int tries = 0; tries < 30; ++tries) {
    const double x = ego_speed * random.uniform(2, 9) + 20;
    const double speed = random.uniform(1.1, 1.6);
    if (cast.pedestrian(straight({x, random.uniform(-14, -5), kPi / 2}, speed))) break;
  }
}

}  // namespace

World empty_road(RandomStream random) {
  World world;
  world.frames = 200;
  RoadOptions road;
  road.to_x_m = 300;
  add_road(world.fixed, road, random);
  world.ego = straight({}, random.uniform(8, 10));
  return world;
}

World crossing(RandomStream random) {
  World world;
  world.frames = 190;
  add_ground(world.fixed, {-150, -200}, {300, 200});
  add_corners(world.fixed, random);
  world.ego = Course({}).run(140).drive(0, slowing(7, 1.2, 31, 13));

  const Cast cast(world, random);
  const auto late = [&] { return random.uniform(-0.5, 0.5); };
  // Crossing streets: to the left on the far lane, to the right on the near one.
  cast.car(Course({kCrossX + 1.7, -60, kPi / 2}).run(160).drive(late() - 1, steady(9)));
  cast.car(Course({kCrossX + 1.7, -75, kPi / 2}).run(180).drive(late() - 1, steady(9)));
  cast.car(Course({kCrossX - 1.7, 22, -kPi / 2}).run(160).drive(late(), steady(8)));
  // The car ahead turns right; an oncoming one turns to its left once the other has gone.
  cast.car(Course({17, 0, 0})
               .run(kCrossX - 17 - 7)
               .arc(8.3, -kPi / 2)
               .run(80)
               .drive(0, slowing(7, 4.2, 28, 10)));
  cast.car(Course({kCrossX + 50, 3.4, kPi})
               .run(42)
               .arc(14, kPi / 2)
               .run(80)
               .drive(2.6 + late(), slowing(8, 4.5, 48, 14)));
  cast.car(Course({kCrossX + 75, 3.4, kPi}).run(160).drive(3.5 + late(), steady(8)));
  cast.pedestrian(straight({kCrossX - 14, 8.2, -kPi / 2}, 0.6));
  cast.cyclist(Course({kCrossX + 4.6, -24, kPi / 2}).run(90).drive(0, steady(4)));
  return world;
}

World curved_road(RandomStream random) {
  Course lane({});
  World world = bend(random, lane);
  add_oncoming(Cast(world, random), lane, random);
  return world;
}

World curved_road_cyclist(RandomStream random) {
  Course lane({});
  World world = bend(random, lane);
  const Cast cast(world, random);
  // Crosses the lane from the right, where the ego car comes by seconds later.
  const auto at = static_cast<std::size_t>(random.uniform(48, 56));
  const Pose2 start = lane.poses()[at] * Pose2{0, -random.uniform(9, 12), kPi / 2};
  cast.cyclist(straight(start, random.uniform(3.2, 4.2)));
  add_oncoming(cast, lane, random);
  return world;
}

World road_users(RandomStream random) {
  World world;
  world.frames = 150;
  RoadOptions road;
  road.from_x_m = -20;
  road.to_x_m = 190;
  road.right_y_m = -4.7;
  road.left_y_m = 5.9;
  road.verge_m = 3.6;
  road.bushes = 0.4;
  add_road(world.fixed, road, random);
  add_clutter(world.fixed, road.to_x_m, random);
  add_guard_rail(world.fixed, {70, 9.0}, {110, 9.0});
  const double ego_speed = random.uniform(5, 8);
  world.ego = straight({}, ego_speed);
  const Cast cast(world, random);
  add_traffic(cast, ego_speed, random);
  add_people(cast, ego_speed, random);
  return world;
}

}  // namespace scanfuse::simulate
