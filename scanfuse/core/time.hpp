#pragma once

#include <chrono>
#include <cmath>
#include <cstdint>

namespace scanfuse {

/// An instant as the data tells it, never the wall clock. Nanoseconds since 1970.
using Time = std::chrono::sys_time<std::chrono::nanoseconds>;
using Duration = std::chrono::nanoseconds;

/// Seconds as a double, for arithmetic on intervals.
[[nodiscard]] constexpr double to_seconds(Duration d) {
  return std::chrono::duration<double>(d).count();
}

/// Seconds since 1970. Exact to about 0.2 us for today's dates: use it for output only.
[[nodiscard]] constexpr double to_seconds(Time t) { return to_seconds(t.time_since_epoch()); }

/// Rounds to the nearest nanosecond. `seconds` must be finite and within +-9.2e9.
[[nodiscard]] inline Duration duration_from_seconds(double seconds) {
  const double whole = std::floor(seconds);
  const auto nanos = std::llround((seconds - whole) * 1e9);
  return Duration{static_cast<std::int64_t>(whole) * 1'000'000'000 + nanos};
}

[[nodiscard]] inline Time time_from_seconds(double seconds) {
  return Time{duration_from_seconds(seconds)};
}

[[nodiscard]] constexpr Time time_from_nanos(std::int64_t nanos) { return Time{Duration{nanos}}; }
[[nodiscard]] constexpr std::int64_t to_nanos(Time t) { return t.time_since_epoch().count(); }

}  // namespace scanfuse
