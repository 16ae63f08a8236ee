#pragma once

#include "scanfuse/geometry/box.hpp"
#include "scanfuse/types/object_class.hpp"

namespace scanfuse {

/// Where a track says that its object will be at the next scan, in the frame of the stage that
/// reads it: what lies in that box may be pieces of one object.
struct Expected {
  Box2 box;
  double sigma_m = 0;  ///< of the box's place, along its worse axis
  ObjectClass object_class = ObjectClass::kUnknown;
};

}  // namespace scanfuse
