#pragma once

#include "scanfuse/simulate/world.hpp"

namespace scanfuse::simulate {

/// Size of a passenger car, drawn within its class: 3.8-4.9 m x 1.65-1.95 m x 1.4-1.7 m.
struct CarSize {
  double length_m = 4.5;
  double width_m = 1.8;
  double height_m = 1.5;
};
[[nodiscard]] CarSize random_car_size(RandomStream& random);

/// Actors without a motion; the caller gives them one. A car has a body rounded in plan, a hood
/// and a cabin, sides that lean, and wheels, so that layers at different heights see it
/// differently.
[[nodiscard]] Actor make_car(std::int64_t id, const CarSize& size, RandomStream& random);
/// One box from bumper to roof, 4.4-6 m x 1.85-2.1 m x 1.9-2.7 m.
[[nodiscard]] Actor make_van(std::int64_t id, RandomStream& random);
[[nodiscard]] Actor make_truck(std::int64_t id, RandomStream& random);
/// Torso, head, two legs and two arms that swing at `steps_per_s`; 0: stands.
[[nodiscard]] Actor make_pedestrian(std::int64_t id, double steps_per_s, RandomStream& random);
/// Frame, two wheels (rims, one sees through them) and a rider whose legs turn.
[[nodiscard]] Actor make_cyclist(std::int64_t id, RandomStream& random);

}  // namespace scanfuse::simulate
