#pragma once

#include <cmath>

#include "scanfuse/core/random.hpp"
#include "scanfuse/types/scan.hpp"

namespace scanfuse::drivers_testing {

inline constexpr double kSampleTurnS = 0.1;

/// A scan as a sensor of that pattern would measure it at random distances; a tenth of the beams
/// see nothing. Beams sweep over `turn_s` a turn, counter-clockwise or clockwise.
inline Scan sample_scan(const BeamPattern& beams, double lowest_deg, double layer_step_deg,
                        bool clockwise, std::uint64_t seed, double turn_s = kSampleTurnS) {
  RandomStream random(seed);
  Scan scan;
  scan.stamp = time_from_nanos(1'700'000'000'123'456'789);
  scan.beams = beams;
  for (int column = 0; column < beams.columns; ++column) {
    for (int layer = 0; layer < beams.layers; ++layer) {
      if (random.chance(0.1)) continue;
      const double range = random.uniform(beams.min_range_m, beams.max_range_m);
      const double up = (lowest_deg + layer * layer_step_deg) * M_PI / 180;
      const double azimuth = beams.first_azimuth_rad + column * beams.step_rad;
      const int order = clockwise ? beams.columns - 1 - column : column;
      Return r;
      r.x_m = static_cast<float>(range * std::cos(up) * std::cos(azimuth));
      r.y_m = static_cast<float>(range * std::cos(up) * std::sin(azimuth));
      r.z_m = static_cast<float>(range * std::sin(up));
      r.intensity = static_cast<float>(random.below(60) + 1);
      r.time_offset_s = static_cast<float>(order * beams.step_rad / (2 * M_PI) * turn_s);
      r.beam = column;
      r.layer = static_cast<std::int16_t>(layer);
      scan.returns.push_back(r);
    }
  }
  return scan;
}

inline BeamPattern pattern_deg(double first, double step, int columns, int layers, double min_m,
                               double max_m) {
  return {first * M_PI / 180, step * M_PI / 180, columns, layers, min_m, max_m};
}

}  // namespace scanfuse::drivers_testing
