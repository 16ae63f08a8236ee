#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "scanfuse/simulate/mesh.hpp"
#include "scanfuse/simulate/motion.hpp"
#include "scanfuse/types/object_class.hpp"

namespace scanfuse::simulate {

/// A rigid piece of an actor. `pose` places it in the actor's frame (box centre on the ground,
/// x forward); empty: it stays put.
struct Part {
  Mesh mesh;
  std::function<Pose3(double t_s)> pose;
};

/// Something that moves and has truth.
struct Actor {
  std::int64_t id = 0;
  ObjectClass object_class = ObjectClass::kVehicle;
  double length_m = 0;
  double width_m = 0;
  double height_m = 0;
  Polygon footprint;  ///< largest cross-section, in the actor's frame
  std::vector<Part> parts;
  PlanarMotion motion;
  std::vector<int> missed_frames;  ///< scans in which no light comes back from it
};

/// All there is. World frame: where the ego vehicle's frame stands at time 0, heading along x.
struct World {
  Mesh fixed;
  std::vector<Actor> actors;
  PlanarMotion ego;  ///< of the rear axle, on the ground
  int frames = 0;    ///< how long the scenario is meant to last
};

}  // namespace scanfuse::simulate
