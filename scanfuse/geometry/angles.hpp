#pragma once

#include <cmath>
#include <numbers>

namespace scanfuse {

inline constexpr double kPi = std::numbers::pi;

[[nodiscard]] constexpr double radians(double degrees) { return degrees * kPi / 180.0; }
[[nodiscard]] constexpr double degrees(double radians) { return radians * 180.0 / kPi; }

/// The same direction in [-pi, pi). What lies within already is returned as it is: the library's
/// remainder gives the same, at ten times the cost.
[[nodiscard]] inline double wrap_pi(double angle_rad) {
  if (angle_rad >= -kPi && angle_rad < kPi) return angle_rad;
  const double wrapped = std::remainder(angle_rad, 2.0 * kPi);
  return wrapped >= kPi ? wrapped - 2.0 * kPi : wrapped;
}

/// The same undirected line in [-pi/2, pi/2).
[[nodiscard]] inline double wrap_half_pi(double angle_rad) {
  if (angle_rad >= -kPi / 2 && angle_rad < kPi / 2) return angle_rad;
  const double wrapped = std::remainder(angle_rad, kPi);
  return wrapped >= kPi / 2 ? wrapped - kPi : wrapped;
}

}  // namespace scanfuse
