#include <cmath>

#include "scanfuse/simulate/cast.hpp"
#include "scanfuse/simulate/roadside.hpp"
#include "scanfuse/simulate/scenarios.hpp"

// A robot on a footpath: what a scanner at knee height sees of people from half a metre on.
namespace scanfuse::simulate {
namespace {

constexpr double kSeconds = 12;
constexpr double kSensorAhead_m = 3.7;  ///< scanners are mounted so far before the ego's origin

struct Path {
  double right_m = -2, left_m = 2;  ///< edges
  double pace_m_per_s = 1;          ///< of the robot; 0: it stands
};

/// Walks on from `start` and strays to both sides, now slower, now faster, as people do.
PlanarMotion stroll(const Pose2& start, double speed_m_per_s, RandomStream& random) {
  constexpr double kStep_s = 1.5;
  std::vector<double> times, x, y;
  double along = 0;
  for (double t = -kStep_s; t <= kSeconds + 2 * kStep_s; t += kStep_s) {
    const Eigen::Vector2d at = start * Eigen::Vector2d(along, random.normal(0, 0.12));
    times.push_back(t);
    x.push_back(at.x());
    y.push_back(at.y());
    along += kStep_s * speed_m_per_s * random.uniform(0.75, 1.25);
  }
  return {Spline(times, x), Spline(times, y), {}};
}

/// Whom the robot follows: ahead of the scanner, at its pace.
void add_guide(const Cast& cast, const Path& path, RandomStream& random) {
  const Pose2 start{kSensorAhead_m + random.uniform(0.8, 3), random.normal(0, 0.3), 0};
  if (path.pace_m_per_s > 0.3) {
    cast.pedestrian(stroll(start, path.pace_m_per_s, random));
  } else {
    cast.pedestrian(standing({start.x_m, start.y_m, random.uniform(-kPi, kPi)}));
  }
}

/// One to four who walk abreast or behind each other.
void add_walkers(const Cast& cast, const Pose2& start, RandomStream& random) {
  const double speed = random.uniform(0.5, 1.8);
  const auto people = random.chance(0.55) ? 1 : 2 + random.below(3);
  for (std::uint64_t i = 0; i < people; ++i) {
    const Pose2 beside{random.uniform(-0.5, 0.5), 0.65 * static_cast<double>(i), 0};
    cast.pedestrian(stroll(start * beside, speed, random));
  }
}

/// Two to five who stand and talk.
void add_talkers(const Cast& cast, const Eigen::Vector2d& middle, RandomStream& random) {
  const auto people = 2 + random.below(4);
  const double radius = random.uniform(0.4, 0.8);
  for (std::uint64_t i = 0; i < people; ++i) {
    const double a = 2 * kPi * static_cast<double>(i) / static_cast<double>(people);
    cast.pedestrian(
        standing({middle.x() + radius * std::cos(a), middle.y() + radius * std::sin(a), a + kPi}));
  }
}

void add_people(const Cast& cast, const Path& path, RandomStream& random) {
  const auto across = [&] { return random.uniform(path.right_m + 0.3, path.left_m - 0.3); };
  const auto ahead = [&](double to_m) { return kSensorAhead_m + random.uniform(1, to_m); };
  for (std::uint64_t i = 0, n = 1 + random.below(5); i < n; ++i) {
    add_walkers(cast, {ahead(12), across(), 0}, random);
  }
  for (std::uint64_t i = 0, n = 1 + random.below(5); i < n; ++i) {
    add_walkers(cast, {ahead(30), across(), kPi}, random);
  }
  for (std::uint64_t i = 0, n = random.below(4); i < n; ++i) {
    const double side = random.chance(0.5) ? 1 : -1;
    const double edge = side > 0 ? path.left_m : path.right_m;
    add_walkers(cast, {ahead(15), edge + side * random.uniform(0, 6), -side * kPi / 2}, random);
  }
  for (std::uint64_t i = 0, n = random.below(3); i < n; ++i) {
    add_talkers(cast, {ahead(15), across()}, random);
  }
}

void add_cyclists(const Cast& cast, const Path& path, RandomStream& random) {
  for (const double heading : {0.0, kPi}) {
    if (!random.chance(0.5)) continue;
    const double x = heading > 1 ? random.uniform(15, 40) : random.uniform(-15, 6);
    const double y = random.uniform(path.right_m, path.left_m);
    cast.cyclist(straight({x, y, heading}, random.uniform(2.5, 6)));
  }
}

/// A wall, a hedge, posts, trunks, bushes, bins or parked cars beside the path.
void add_side(World& world, const Cast& cast, double edge_m, double side, RandomStream& random) {
  const double y = edge_m + side * random.uniform(0.2, 3);
  const double from = -10, to = 50;
  const auto kind = random.below(5);
  if (kind == 0) {
    add_wall(world.fixed, {from, y}, {to, y}, 0.3, 0, random.uniform(0.8, 4));
  } else if (kind == 1) {
    for (double x = from; x < to; x += 0.5) {
      add_bush(world.fixed, {x, y + random.uniform(-0.1, 0.1)}, random.uniform(0.3, 0.6),
               random.uniform(0.7, 2), random);
    }
  } else if (kind == 2) {
    for (double x = 0; x < to; x += 5.8) {
      if (random.chance(0.7)) cast.car(standing({x, y + side, random.chance(0.5) ? 0 : kPi}));
    }
  }
  for (double x = 2; x < to; x += random.uniform(1, 12)) {
    const Eigen::Vector2d at(x, edge_m + side * random.uniform(0, 2.5));
    const double what = random.uniform();
    if (what < 0.35) {
      add_pole(world.fixed, at, random.uniform(0.05, 0.35), random.uniform(0.8, 5));
    } else if (what < 0.55) {
      add_tree(world.fixed, at, random);
    } else if (what < 0.8) {
      add_bush(world.fixed, at, random.uniform(0.15, 0.7), random.uniform(0.4, 1.8), random);
    } else {  // a bin, a bench, a box
      add_wall(world.fixed, at, at + Eigen::Vector2d(random.uniform(0.3, 1.8), 0),
               random.uniform(0.3, 0.7), random.chance(0.3) ? 0.35 : 0, random.uniform(0.5, 1.3));
    }
  }
}

}  // namespace

World among_people(RandomStream random) {
  World world;
  world.frames = 125;
  Path path;
  path.right_m = -random.uniform(1, 5);
  path.left_m = random.uniform(1, 5);
  path.pace_m_per_s = random.chance(0.3) ? 0 : random.uniform(0.3, 1.8);
  world.ego = path.pace_m_per_s > 0 ? straight({}, path.pace_m_per_s) : standing({});
  add_ground(world.fixed, {-80, -80}, {120, 80});
  const Cast cast(world, random);
  if (random.chance(0.6)) add_guide(cast, path, random);
  add_people(cast, path, random);
  add_cyclists(cast, path, random);
  add_side(world, cast, path.right_m, -1, random);
  add_side(world, cast, path.left_m, 1, random);
  return world;
}

}  // namespace scanfuse::simulate
