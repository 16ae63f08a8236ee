#include "scanfuse/simulate/bodies.hpp"
#include "scanfuse/simulate/roadside.hpp"
#include "scanfuse/simulate/scenarios.hpp"

namespace scanfuse::simulate {

World empty_road(RandomStream random) {
  World world;
  world.frames = 200;
  RoadOptions road;
  road.to_x_m = 300;
  add_road(world.fixed, road, random);
  world.ego = straight({}, random.uniform(8, 10));
  return world;
}

}  // namespace scanfuse::simulate
