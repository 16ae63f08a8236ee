#pragma once

#include "scanfuse/simulate/sensor_model.hpp"
#include "scanfuse/simulate/world.hpp"

namespace scanfuse::simulate {

/// Each builds a world from a seed. The events of the first three are placed for the LUX: another
/// sensor sees the same drive, and its own events.

/// Two cars ahead: target 1 (id 1) all the time, target 2 (id 2) comes into the field of view from
/// behind on the left at frame 26 and falls back out of it at 147; target 1 gives no light in
/// frames 102, 148, 172 and 177 [Lu2018, section 4.1].
[[nodiscard]] World lu2018_1(RandomStream random);
/// Target 2 comes into view at frame 51, cuts in before target 1 and hides it in frames 62 to 74
/// [Lu2018, section 4.2].
[[nodiscard]] World lu2018_2(RandomStream random);
/// Three cars; target 1 falls back out of the field of view at frame 16 [Lu2018, section 4.3].
[[nodiscard]] World lu2018_3(RandomStream random);

[[nodiscard]] World empty_road(RandomStream random);
[[nodiscard]] World crossing(RandomStream random);
[[nodiscard]] World road_users(RandomStream random);
[[nodiscard]] World mixed_streets(RandomStream random);
[[nodiscard]] World among_people(RandomStream random);
[[nodiscard]] World rooms(RandomStream random);
[[nodiscard]] World curved_road(RandomStream random);
[[nodiscard]] World curved_road_cyclist(RandomStream random);

}  // namespace scanfuse::simulate
