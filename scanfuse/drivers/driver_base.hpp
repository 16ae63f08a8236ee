#pragma once

#include <cmath>
#include <string>

#include "scanfuse/drivers/clock_map.hpp"
#include "scanfuse/drivers/driver.hpp"

namespace scanfuse::drivers {

/// What most drivers keep: a name, a clock, a count of scans, what was odd.
class DriverBase : public Driver {
 public:
  explicit DriverBase(const DriverOptions& options) : sensor_(options.sensor) {}
  [[nodiscard]] const Diagnostics& diagnostics() const override { return diagnostics_; }

 protected:
  /// As `ClockMap::stamp`; jumps are noted.
  Time stamp(Duration event, Duration sent, Time received) {
    const auto before = clock_.jumps();
    const Time at = clock_.stamp(event, sent, received);
    if (clock_.jumps() > before) diagnostics_.note("clock of the device jumped", sensor_);
    return at;
  }
  [[nodiscard]] Scan new_scan(Time stamp) {
    Scan scan;
    scan.stamp = stamp;
    scan.frame = frame_++;
    scan.sensor = scan.frame_id = sensor_;
    return scan;
  }
  Diagnostics& odd() { return diagnostics_; }
  [[nodiscard]] const std::string& sensor() const { return sensor_; }

 private:
  std::string sensor_;
  ClockMap clock_;
  std::int64_t frame_ = 0;
  Diagnostics diagnostics_;
};

/// A return at a range, azimuth (counter-clockwise from straight ahead) and elevation.
[[nodiscard]] inline Return return_at(double range_m, double azimuth_rad, double elevation_rad) {
  const double flat_m = range_m * std::cos(elevation_rad);
  Return r;
  r.x_m = static_cast<float>(flat_m * std::cos(azimuth_rad));
  r.y_m = static_cast<float>(flat_m * std::sin(azimuth_rad));
  r.z_m = static_cast<float>(range_m * std::sin(elevation_rad));
  return r;
}

/// No lidar reaches farther; what says so is no measurement.
inline constexpr double kFarthestM = 1e4;
[[nodiscard]] inline bool is_range(double range_m) { return range_m > 0 && range_m < kFarthestM; }

/// A device's clock in ticks of `T` that is far enough from the limits of `Duration`.
template <class T>
[[nodiscard]] Duration device_time(std::uint64_t ticks) {
  constexpr std::uint64_t kMost =
      (std::uint64_t{1} << 61) / static_cast<std::uint64_t>(Duration(T(1)).count());
  return T(static_cast<std::int64_t>(ticks % kMost));
}

/// The device's time as it would count microseconds or the like.
template <class T>
[[nodiscard]] std::uint64_t ticks_of(Time time) {
  const auto count = std::chrono::floor<T>(time.time_since_epoch()).count();
  return count < 0 ? 0 : static_cast<std::uint64_t>(count);
}

}  // namespace scanfuse::drivers
