#pragma once

#include <array>

#include "scanfuse/calibrate/turntable.hpp"

namespace scanfuse::app {

/// What a rig is judged by: squared errors in the units of `kTurntableErrors`.
struct TurntableError {
  const char* name;
  const char* unit;
  double target;  ///< of the joint refinement
};
inline constexpr std::array<TurntableError, 7> kTurntableErrors{
    TurntableError{"axis direction", "deg", 0.010},
    TurntableError{"axis position at the lidar", "mm", 0.12},
    TurntableError{"lidar centre over the arc", "mm", 0.10},
    TurntableError{"z axis over the arc", "deg", 0.003},
    TurntableError{"x axis over the arc", "deg", 0.006},
    TurntableError{"point at 1.5 m over the arc", "mm", 0.10},
    TurntableError{"point at 1.5 m at +-90 deg", "mm", 0.30}};
using TurntableErrors = std::array<double, kTurntableErrors.size()>;

[[nodiscard]] TurntableErrors squared_errors(const Rig& truth, const Rig& rig);

/// The same as a covariance of the rig's parameters expects them.
[[nodiscard]] TurntableErrors expected_squares(const Rig& truth,
                                               const calibrate::RigCovariance& covariance);

}  // namespace scanfuse::app
