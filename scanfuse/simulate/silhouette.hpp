#pragma once

#include <functional>

#include "scanfuse/geometry/box.hpp"
#include "scanfuse/simulate/world.hpp"

namespace scanfuse::simulate {

/// The bearings between which an actor's footprint is seen, in the sensor's planar frame.
struct Silhouette {
  double right_rad = 0;
  double left_rad = 0;
};
[[nodiscard]] Silhouette silhouette(const Polygon& footprint, const Pose2& world_from_actor,
                                    const Pose2& world_from_sensor);

/// True when two boxes share a point (separating axes).
[[nodiscard]] bool overlap(const Box2& a, const Box2& b);

/// Where a function with one change of sign in [low, high] crosses zero (bisection).
[[nodiscard]] double find_zero(const std::function<double(double)>& f, double low, double high);

}  // namespace scanfuse::simulate
