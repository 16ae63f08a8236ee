#include <array>
#include <cmath>
#include <vector>

#include "scanfuse/simulate/cast.hpp"
#include "scanfuse/simulate/roadside.hpp"
#include "scanfuse/simulate/scenarios.hpp"

// A robot indoors: what a scanner at leg height sees of furniture, with people or without.
namespace scanfuse::simulate {
namespace {

constexpr double kRoomSeconds = 12;
constexpr double kScannerAhead_m = 3.7;  ///< scanners are mounted so far before the ego's origin
constexpr double kCeiling_m = 2.6;
constexpr double kAisle_m = 1.1;  ///< free to both sides of the robot's way
constexpr double kLane_m = 0.8;   ///< free to both sides of where people cross it

const Surface kWood{0.35F, 0.15F, false};
const Surface kMetal{0.4F, 0.1F, false};
const Surface kCloth{0.25F, 0.2F, false};

struct Room {
  Eigen::Vector2d low_m, high_m;
  double lane_x_m = 0;
};

/// Where furniture may stand: off the aisle, off the lane, in nobody's way.
class Floor {
 public:
  explicit Floor(const Room& room) : room_(room) {}

  bool take(const Eigen::Vector2d& at, double radius_m) {
    const Eigen::Vector2d margin(radius_m, radius_m);
    const bool inside =
        (at - margin - room_.low_m).minCoeff() > 0 && (room_.high_m - at - margin).minCoeff() > 0;
    if (!inside || std::abs(at.y()) < kAisle_m + radius_m ||
        std::abs(at.x() - room_.lane_x_m) < kLane_m + radius_m) {
      return false;
    }
    for (const auto& [other, other_radius_m] : taken_) {
      if ((at - other).norm() < radius_m + other_radius_m) return false;
    }
    taken_.emplace_back(at, radius_m);
    return true;
  }

 private:
  Room room_;
  std::vector<std::pair<Eigen::Vector2d, double>> taken_;
};

void add_block(Mesh& mesh, const Pose2& at, const Eigen::Vector3d& size_m, double low_m,
               const Surface& surface) {
  add_box(mesh, Pose3::from_planar(at, low_m + size_m.z() / 2), size_m, surface);
}

/// Four legs at the corners of a rectangle.
void add_legs(Mesh& mesh, const Pose2& at, double length_m, double width_m, double leg_m,
              double height_m) {
  for (const double x : {-0.5, 0.5}) {
    for (const double y : {-0.5, 0.5}) {
      add_pole(mesh, at * Eigen::Vector2d(x * (length_m - leg_m), y * (width_m - leg_m)), leg_m,
               height_m);
    }
  }
}

void add_chair(Mesh& mesh, const Pose2& at, RandomStream& random) {
  const double side = random.uniform(0.38, 0.5), seat = random.uniform(0.42, 0.48);
  if (random.chance(0.4)) {  // on one foot, as in offices
    add_pole(mesh, {at.x_m, at.y_m}, random.uniform(0.04, 0.09), seat);
    for (int k = 0; k < 5; ++k) {
      const Pose2 arm = at * Pose2{0, 0, 2 * kPi * k / 5} * Pose2{0.15, 0, 0};
      add_block(mesh, arm, {0.3, 0.04, 0.06}, 0.04, kMetal);
    }
  } else {
    add_legs(mesh, at, side, side, random.uniform(0.018, 0.05), seat);
  }
  add_block(mesh, at, {side, side, 0.05}, seat, kCloth);
  add_block(mesh, at * Pose2{-side / 2, 0, 0}, {0.04, side, 0.4}, seat + 0.1, kCloth);
}

void add_table(Mesh& mesh, const Pose2& at, RandomStream& random) {
  const double length = random.uniform(0.7, 1.8), width = random.uniform(0.6, 0.9);
  const double height = random.uniform(0.68, 0.78);
  add_legs(mesh, at, length, width, random.uniform(0.025, 0.09), height);
  add_block(mesh, at, {length, width, 0.03}, height, kWood);
  for (const double side : {-1.0, 1.0}) {
    for (double x = -length / 2 + 0.35; x < length / 2; x += 0.65) {
      if (!random.chance(0.5)) continue;
      const Pose2 seat{x, side * (width / 2 + random.uniform(-0.1, 0.3)),
                       -side * kPi / 2 + random.normal(0, 0.3)};
      add_chair(mesh, at * seat, random);
    }
  }
}

/// A bin, a bag, a box, a plant in its pot, a stool, a lamp, a trolley.
void add_small_thing(Mesh& mesh, const Pose2& at, RandomStream& random) {
  const Eigen::Vector2d place(at.x_m, at.y_m);
  const auto kind = random.below(5);
  if (kind == 0) {
    add_pole(mesh, place, random.uniform(0.2, 0.4), random.uniform(0.35, 0.9));
  } else if (kind == 1) {
    const Eigen::Vector3d size(random.uniform(0.2, 0.7), random.uniform(0.15, 0.5),
                               random.uniform(0.25, 0.9));
    add_block(mesh, at, size, 0, kCloth);
  } else if (kind == 2) {
    add_pole(mesh, place, random.uniform(0.2, 0.35), random.uniform(0.2, 0.4));
    add_bush(mesh, place, random.uniform(0.15, 0.4), random.uniform(0.7, 1.6), random);
  } else if (kind == 3) {
    add_pole(mesh, place, random.uniform(0.02, 0.06), random.uniform(0.6, 1.7));
  } else {
    add_legs(mesh, at, random.uniform(0.3, 0.8), random.uniform(0.3, 0.5),
             random.uniform(0.02, 0.05), random.uniform(0.45, 0.9));
  }
}

void add_furniture(Mesh& mesh, const Room& room, Floor& floor, RandomStream& random) {
  const double clutter = random.uniform(0.3, 1);
  const Eigen::Vector2d size = room.high_m - room.low_m;
  const int tries = static_cast<int>(clutter * size.x() * size.y() * 0.8);
  for (int n = 0; n < tries; ++n) {
    const Pose2 at{random.uniform(room.low_m.x(), room.high_m.x()),
                   random.uniform(room.low_m.y(), room.high_m.y()), random.uniform(-kPi, kPi)};
    const Eigen::Vector2d place(at.x_m, at.y_m);
    const double what = random.uniform();
    if (what < 0.2) {
      if (floor.take(place, 1.2)) add_table(mesh, at, random);
    } else if (what < 0.45) {
      if (floor.take(place, 0.35)) add_chair(mesh, at, random);
    } else if (what < 0.8) {
      if (floor.take(place, 0.45)) add_small_thing(mesh, at, random);
    } else if (what < 0.9) {
      const Eigen::Vector3d cupboard(random.uniform(0.4, 1.6), random.uniform(0.3, 0.8),
                                     random.uniform(0.5, 2));
      if (floor.take(place, 0.9)) add_block(mesh, at, cupboard, 0, kWood);
    } else if (floor.take(place, 0.4)) {
      add_pole(mesh, place, random.uniform(0.25, 0.7), kCeiling_m);
    }
  }
}

/// Four walls with doors, niches and ledges.
void add_walls(Mesh& mesh, const Room& room, RandomStream& random) {
  const std::array<Eigen::Vector2d, 4> corners{
      room.low_m, Eigen::Vector2d(room.high_m.x(), room.low_m.y()), room.high_m,
      Eigen::Vector2d(room.low_m.x(), room.high_m.y())};
  for (std::size_t k = 0; k < 4; ++k) {
    const Eigen::Vector2d& from = corners[k];
    const Eigen::Vector2d& to = corners[(k + 1) % 4];
    const double length = (to - from).norm();
    const Eigen::Vector2d along = (to - from) / length, out(along.y(), -along.x());
    for (double s = 0; s < length;) {
      const double run = std::min(random.uniform(0.5, 4), length - s);
      const double back = random.chance(0.3) ? random.uniform(0.05, 0.5) : 0;
      const bool is_door = random.chance(0.12) && run < 1.5;
      if (!is_door) {
        add_wall(mesh, from + s * along + back * out, from + (s + run) * along + back * out, 0.12,
                 0, kCeiling_m);
      }
      s += run;
    }
  }
  const Eigen::Vector2d far(4, 4);  // what is seen through the doors
  for (const double side : {-1.0, 1.0}) {
    const double y = side > 0 ? room.high_m.y() + far.y() : room.low_m.y() - far.y();
    add_wall(mesh, {room.low_m.x() - far.x(), y}, {room.high_m.x() + far.x(), y}, 0.2, 0,
             kCeiling_m);
  }
}

/// Nobody walks into the robot.
bool keeps_clear(const PlanarMotion& motion, double pace_m_per_s) {
  for (double t = 0; t <= kRoomSeconds + 1; t += 0.1) {
    const Pose2 pose = motion.pose(t);
    if (std::hypot(pose.x_m - kScannerAhead_m - pace_m_per_s * t, pose.y_m) < 0.6) return false;
  }
  return true;
}

void add_people(const Cast& cast, const Room& room, double pace_m_per_s, Floor& floor,
                RandomStream& random) {
  const double robot_m = kScannerAhead_m;
  for (std::uint64_t i = 0, n = random.below(5); i < n; ++i) {  // along the aisle
    const bool towards = random.chance(0.5);
    const double x = towards ? random.uniform(robot_m + 3, room.high_m.x() - 0.5)
                             : robot_m + random.uniform(0.8, 4);
    const double speed = towards ? random.uniform(0.4, 1.4) : pace_m_per_s + random.uniform(0, 0.7);
    const auto walk = straight({x, random.uniform(-0.9, 0.9), towards ? kPi : 0}, speed);
    if (keeps_clear(walk, pace_m_per_s)) cast.pedestrian(walk);
  }
  for (std::uint64_t i = 0, n = random.below(3); i < n; ++i) {  // across
    const double side = random.chance(0.5) ? 1 : -1;
    const double y = side > 0 ? room.high_m.y() - 0.4 : room.low_m.y() + 0.4;
    const double x = room.lane_x_m + random.uniform(-0.5, 0.5);
    const double slowest = (room.high_m.y() - room.low_m.y()) / kRoomSeconds;
    const auto walk = straight({x, y, -side * kPi / 2}, random.uniform(0.3, 0.9) * slowest);
    if (keeps_clear(walk, pace_m_per_s)) cast.pedestrian(walk);
  }
  for (std::uint64_t i = 0, n = random.below(7); i < n; ++i) {  // who stand
    const Eigen::Vector2d at(random.uniform(room.low_m.x() + 0.5, room.high_m.x() - 0.5),
                             random.uniform(room.low_m.y() + 0.5, room.high_m.y() - 0.5));
    if (!floor.take(at, 0.35)) continue;
    cast.pedestrian(standing({at.x(), at.y(), random.uniform(-kPi, kPi)}));
  }
}

}  // namespace

World rooms(RandomStream random) {
  World world;
  world.frames = 125;
  const double pace = random.chance(0.4) ? 0 : random.uniform(0.2, 0.9);
  world.ego = pace > 0 ? straight({}, pace) : standing({});
  Room room;
  room.low_m = {kScannerAhead_m - random.uniform(1, 6), -random.uniform(2, 7)};
  room.high_m = {kScannerAhead_m + pace * kRoomSeconds + random.uniform(2.5, 9),
                 random.uniform(2, 7)};
  room.lane_x_m = random.uniform(kScannerAhead_m + 1, room.high_m.x());
  add_ground(world.fixed, {-40, -40}, {60, 40});
  add_walls(world.fixed, room, random);
  Floor floor(room);
  if (random.chance(0.75)) {
    const Cast cast(world, random);
    add_people(cast, room, pace, floor, random);
  }
  add_furniture(world.fixed, room, floor, random);
  return world;
}

}  // namespace scanfuse::simulate
