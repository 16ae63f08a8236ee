#pragma once

#include <gtest/gtest.h>

#include "scanfuse/calibrate/rig_error.hpp"
#include "scanfuse/calibrate/turntable.hpp"
#include "scanfuse/simulate/turntable_features.hpp"

namespace scanfuse::calibrate::testing {

using simulate::SimulatedTurntable;
using simulate::TurntableNoise;
using simulate::TurntableWorldOptions;

inline constexpr TurntableNoise kNoNoise{
    .corner_px = 0, .stripe_px = 0, .range_m = 0, .turntable_rad = 0};

/// A quarter of the positions and beams, the whole arc: quick.
inline TurntableWorldOptions small_world() {
  TurntableWorldOptions options;
  options.positions = 22;
  options.step_rad = radians(1);
  options.beam_step_rad = radians(0.25);
  return options;
}

inline SimulatedTurntable simulate_small(const TurntableNoise& noise = {}, std::uint64_t seed = 7) {
  return simulate::simulate_turntable_features(small_world(), noise, seed);
}

/// Largest distance between what two rigs make of the same returns, over the arc.
inline double points_apart_m(const Rig& a, const Rig& b) {
  double worst = 0;
  for (int i = 0; i <= 10; ++i) {
    const double psi =
        a.first_turntable_rad + i / 10.0 * (a.last_turntable_rad - a.first_turntable_rad);
    for (const double beam : {-0.2, 0.0, 0.3}) {
      worst =
          std::max(worst, (point_camera(a, psi, beam, 1) - point_camera(b, psi, beam, 1)).norm());
    }
  }
  return worst;
}

inline Result<TurntableCalibration> calibrate_by(const TurntableFeatures& features,
                                                 TurntableMethod method) {
  TurntableOptions options;
  options.method = method;
  return calibrate_turntable(features, options);
}

}  // namespace scanfuse::calibrate::testing
