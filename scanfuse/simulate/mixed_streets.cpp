#include <cmath>

#include "scanfuse/simulate/cast.hpp"
#include "scanfuse/simulate/roadside.hpp"
#include "scanfuse/simulate/scenarios.hpp"

// Streets of many kinds, for learning what does not hang on one kind. Measures are those of common
// European streets, drawn anew for each seed; none is taken from a recording.
namespace scanfuse::simulate {
namespace {

enum class Boundary { kNone, kFacade, kHedge, kPickets, kRails, kBushes };
constexpr int kBoundaries = 6;

/// The lie of a street along x. The ego car drives on y = 0.
struct Street {
  double from_x_m = -25, to_x_m = 130;
  double lane_m = 3.4;
  double kerb_right_m = -2, kerb_left_m = 5.4;  ///< before bays to park in
  double pavement_m = 2.5;                      ///< from the bays to the boundary
  double parked = 0.5;                          ///< share of the bays that are taken
  bool across = false;                          ///< bays at right angles to the kerb
  double bay_m = 0;                             ///< depth of the bays
  double crowd = 1;                             ///< people, against a street as usual
  double furniture = 0.5;                       ///< posts, trunks, bins a metre and side, times 10
  double traffic = 1;

  [[nodiscard]] double kerb(double side) const {
    return side > 0 ? kerb_left_m + bay_m : kerb_right_m - bay_m;
  }
};

Street random_street(RandomStream& random) {
  Street street;
  street.lane_m = random.uniform(2.8, 3.7);
  const bool two_lanes = random.chance(0.3);
  street.kerb_right_m = -street.lane_m / 2 - random.uniform(0, 1.2) - (two_lanes ? 3.2 : 0);
  street.kerb_left_m = 1.5 * street.lane_m + random.uniform(0, 1.2);
  street.pavement_m = random.uniform(0.8, 6);
  street.across = random.chance(0.2);
  const bool bays = random.chance(0.7);
  street.bay_m = bays ? (street.across ? 5.2 : 2.2) : 0;
  street.parked = bays ? random.uniform(0.2, 0.95) : 0;
  street.crowd = random.uniform(0.3, 2);
  street.furniture = random.uniform(0.2, 1.5);
  street.traffic = random.uniform(0.2, 1.5);
  return street;
}

void add_pickets(Mesh& mesh, double x0, double x1, double y, RandomStream& random) {
  const double step = random.uniform(0.15, 0.5), height = random.uniform(0.8, 1.8);
  const double width = random.uniform(0.03, 0.1);
  for (double x = x0; x < x1; x += step) add_pole(mesh, {x, y}, width, height);
}

void add_hedge(Mesh& mesh, double x0, double x1, double y, RandomStream& random) {
  const double height = random.uniform(0.7, 2.2), radius = random.uniform(0.3, 0.6);
  for (double x = x0; x < x1; x += 0.9 * radius) {
    add_bush(mesh, {x, y + random.uniform(-0.08, 0.08)}, radius, height, random);
  }
}

/// Walls with recesses and steps.
void add_facade(Mesh& mesh, double x0, double x1, double y, double side, RandomStream& random) {
  const double height = random.chance(0.4) ? random.uniform(0.5, 1.8) : random.uniform(3, 8);
  for (double x = x0; x < x1;) {
    const double end = std::min(x1, x + random.uniform(1, 8));
    const double back = random.chance(0.4) ? random.uniform(0.1, 0.6) : 0;
    add_wall(mesh, {x, y + side * (0.15 + back)}, {end, y + side * (0.15 + back)}, 0.3, 0, height);
    x = end + (random.chance(0.2) ? random.uniform(0.8, 2.5) : 0);
  }
}

void add_boundary(Mesh& mesh, const Street& street, double side, RandomStream& random) {
  const double y = street.kerb(side) + side * street.pavement_m;
  for (double x = street.from_x_m; x < street.to_x_m;) {
    const double end = x + random.uniform(6, 30);
    switch (static_cast<Boundary>(random.below(kBoundaries))) {
      case Boundary::kNone:
        break;
      case Boundary::kFacade:
        add_facade(mesh, x, end, y, side, random);
        break;
      case Boundary::kHedge:
        add_hedge(mesh, x, end, y + side * 0.5, random);
        break;
      case Boundary::kPickets:
        add_pickets(mesh, x, end, y, random);
        break;
      case Boundary::kRails:
        add_guard_rail(mesh, {x, y}, {end, y});
        break;
      case Boundary::kBushes:
        for (double at = x; at < end; at += random.uniform(1, 4)) {
          add_bush(mesh, {at, y + side * random.uniform(0, 2)}, random.uniform(0.3, 0.9),
                   random.uniform(0.5, 2), random);
        }
    }
    x = end + random.uniform(0, 4);
  }
}

/// Posts, trunks, bollards, bins, boxes and signs: what may be taken for a person.
void add_piece(Mesh& mesh, const Eigen::Vector2d& at, RandomStream& random) {
  switch (random.below(8)) {
    case 0:
      return add_pole(mesh, at, random.uniform(0.06, 0.3), random.uniform(2.2, 6));
    case 1:
      return add_tree(mesh, at, random);
    case 2:  // a row of bollards
      for (int i = 0; i < 4; ++i) {
        add_pole(mesh, at + Eigen::Vector2d(1.4 * i, 0), 0.16, random.uniform(0.8, 1.1));
      }
      return;
    case 3:  // a bin or a box
      return add_wall(mesh, at, at + Eigen::Vector2d(random.uniform(0.3, 1.4), 0),
                      random.uniform(0.3, 0.9), 0, random.uniform(0.7, 1.5));
    case 4:  // a sign on two posts
      add_pole(mesh, at, 0.07, 2);
      add_pole(mesh, at + Eigen::Vector2d(0, random.uniform(0.5, 1.2)), 0.07, 2);
      return;
    case 5:
      return add_bush(mesh, at, random.uniform(0.2, 0.6), random.uniform(0.5, 1.7), random);
    case 6:  // a pillar
      return add_pole(mesh, at, random.uniform(0.3, 0.8), random.uniform(1, 3));
    default:  // a short wall across the pavement
      add_wall(mesh, at, at + Eigen::Vector2d(0, random.uniform(0.4, 1.5)), 0.2, 0,
               random.uniform(0.8, 2));
  }
}

void add_furniture(Mesh& mesh, const Street& street, RandomStream& random) {
  for (const double side : {-1.0, 1.0}) {
    for (double x = 3; x < street.to_x_m; x += random.uniform(2, 18) / street.furniture) {
      const double in = random.chance(0.6) ? random.uniform(0.3, 0.6)
                                           : random.uniform(0.3, street.pavement_m + 2);
      add_piece(mesh, {x, street.kerb(side) + side * in}, random);
    }
  }
}

void add_vehicle(const Cast& cast, PlanarMotion motion, RandomStream& random) {
  const double kind = random.uniform();
  kind < 0.7    ? cast.car(std::move(motion))
  : kind < 0.92 ? cast.van(std::move(motion))
                : cast.truck(std::move(motion));
}

void add_parked(const Cast& cast, const Street& street, RandomStream& random) {
  if (street.bay_m <= 0) return;
  for (const double side : {-1.0, 1.0}) {
    const double y = street.kerb(side) - side * street.bay_m / 2;
    const double step = street.across ? 2.6 : 5.9;
    for (double x = random.uniform(0, 6); x < street.to_x_m; x += step + random.uniform(0, 0.5)) {
      if (!random.chance(street.parked)) continue;
      const double turn = (street.across ? kPi / 2 : 0) + (random.chance(0.5) ? kPi : 0);
      const Pose2 pose{x, y + random.uniform(-0.15, 0.15), turn + random.normal(0, 0.03)};
      street.across ? static_cast<void>(cast.car(standing(pose)))
                    : add_vehicle(cast, standing(pose), random);
    }
  }
}

void add_lanes(const Cast& cast, const Street& street, double ego_speed, RandomStream& random) {
  for (double x = random.uniform(9, 25); x < 70; x += random.uniform(9, 30) / street.traffic) {
    add_vehicle(cast, straight({x, random.uniform(-0.3, 0.3), 0}, ego_speed + 0.03 * x + 0.1),
                random);
  }
  const double oncoming = random.uniform(3, 13);
  for (double x = random.uniform(10, 35); x < 200; x += random.uniform(14, 50) / street.traffic) {
    add_vehicle(cast, straight({x, street.lane_m + random.uniform(-0.2, 0.2), kPi}, oncoming),
                random);
  }
}

/// Cars that cross far ahead, and one that waits to.
void add_crossing(const Cast& cast, double at_x_m, RandomStream& random) {
  const double speed = random.uniform(4, 11);
  for (double y = -20; y > -150; y -= random.uniform(12, 40)) {
    add_vehicle(cast, straight({at_x_m + 1.7, y, kPi / 2}, speed), random);
  }
  for (double y = 25; y < 150; y += random.uniform(12, 40)) {
    add_vehicle(cast, straight({at_x_m - 1.7, y, -kPi / 2}, speed), random);
  }
  add_vehicle(cast, standing({at_x_m + 1.7, -8, kPi / 2}), random);
  cast.cyclist(straight({at_x_m + 4.5, -random.uniform(10, 40), kPi / 2}, random.uniform(3, 5.5)));
  cast.cyclist(straight({at_x_m - 4.5, random.uniform(10, 40), -kPi / 2}, random.uniform(3, 5.5)));
}

void add_person(const Cast& cast, const Pose2& start, double speed) {
  cast.pedestrian(speed > 0 ? straight(start, speed) : standing(start));
}

/// One to four people side by side or behind each other, who walk or stand about.
void add_group(const Cast& cast, const Pose2& start, RandomStream& random) {
  const auto people = random.chance(0.6) ? 1 : 2 + random.below(3);
  const double speed = random.chance(0.35) ? 0.0 : random.uniform(0.6, 1.9);
  for (std::uint64_t i = 0; i < people; ++i) {
    const double beside = 0.75 * static_cast<double>(i);
    Pose2 pose = start * Pose2{random.uniform(-0.4, 0.4), beside, 0};
    if (speed <= 0) pose.heading_rad = random.uniform(-kPi, kPi);
    add_person(cast, pose, speed);
  }
}

void add_crowd(const Cast& cast, const Street& street, RandomStream& random) {
  const auto anywhere = [&] { return random.uniform(6, 80); };
  const auto along = [&] { return random.chance(0.5) ? 0.0 : kPi; };
  const int groups = static_cast<int>(std::lround(9 * street.crowd));
  for (int i = 0; i < groups; ++i) {
    const double side = random.chance(0.5) ? 1 : -1;
    // On the pavement; close to the boundary; in the bays between parked cars.
    const double where = random.uniform();
    const double in = where < 0.6   ? random.uniform(0.4, street.pavement_m)
                      : where < 0.8 ? street.pavement_m - random.uniform(0.3, 0.5)
                                    : -random.uniform(0.2, street.bay_m + 0.4);
    add_group(cast, {anywhere(), street.kerb(side) + side * in, along()}, random);
  }
  const int crossing = static_cast<int>(random.below(4));
  for (int i = 0; i < crossing; ++i) {
    const double side = random.chance(0.5) ? 1 : -1;
    const Pose2 start{anywhere() + 10, street.kerb(side) + side * random.uniform(0, 8),
                      -side * kPi / 2 + random.normal(0, 0.3)};
    add_person(cast, start, random.uniform(0.8, 1.8));
  }
}

void add_cyclists(const Cast& cast, const Street& street, double ego_speed, RandomStream& random) {
  for (double x = random.uniform(6, 30); x < 80; x += random.uniform(12, 45)) {
    const double y = street.kerb_right_m + random.uniform(0.4, 0.8);
    cast.cyclist(straight({x, y, 0}, std::max(0.8 * ego_speed, 2.5) + 0.01 * x));
  }
  for (double x = random.uniform(15, 45); x < 140; x += random.uniform(20, 60)) {
    const double y = street.kerb_left_m - random.uniform(0.4, 0.8);
    cast.cyclist(straight({x, y, kPi}, random.uniform(3, 6.5)));
  }
  if (!random.chance(0.4)) return;
  const double side = random.chance(0.5) ? 1 : -1;  // on the pavement
  cast.cyclist(
      straight({random.uniform(10, 50), street.kerb(side) + side, random.chance(0.5) ? 0 : kPi},
               random.uniform(2, 4)));
}

}  // namespace

World mixed_streets(RandomStream random) {
  World world;
  world.frames = 125;
  const Street street = random_street(random);
  add_ground(world.fixed, {-150, -150}, {280, 150});
  for (const double side : {-1.0, 1.0}) add_boundary(world.fixed, street, side, random);
  add_furniture(world.fixed, street, random);
  const double ego_speed = random.chance(0.2) ? 0 : random.uniform(2, 11);
  world.ego = ego_speed > 0 ? straight({}, ego_speed) : standing({});
  const Cast cast(world, random);
  if (random.chance(0.5)) add_crossing(cast, random.uniform(45, 75), random);
  add_lanes(cast, street, ego_speed, random);
  add_cyclists(cast, street, ego_speed, random);
  add_parked(cast, street, random);
  add_crowd(cast, street, random);
  return world;
}

}  // namespace scanfuse::simulate
