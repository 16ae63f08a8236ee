#pragma once

#include <cstdint>
#include <tuple>
#include <vector>

#include "scanfuse/simulate/turntable_world.hpp"

namespace scanfuse::simulate {

/// Noise of what a detector would hand over. All are standard deviations unless said otherwise.
struct TurntableNoise {
  double corner_px = 0.07;
  double stripe_px = 0.15;
  double range_m = 0.001;
  double turntable_rad = radians(0.002);
  double stripe_line_px = 0;
  double range_line_m = 0;
  double range_bias_m = 0;
  double square_bias_m = 0;
  double angle_scale = 1;
  double range_step_m = 0;

  static constexpr auto fields() {
    using O = TurntableNoise;
    return std::tuple{
        Field{"corner_px", &O::corner_px, 0.0, 10.0, "of a corner, each way"},
        Field{"stripe_px", &O::stripe_px, 0.0, 10.0, "of a point of the stripe, across it"},
        Field{"range_m", &O::range_m, 0.0, 1.0, "of a range"},
        Field{"turntable_rad", &O::turntable_rad, 0.0, 0.1, "of an angle of the turntable"},
        Field{
            "stripe_line_px", &O::stripe_line_px, 0.0, 10.0,
            "of an error that all points of one stripe share: as much again at its ends, as tilt"},
        Field{"range_line_m", &O::range_line_m, 0.0, 1.0,
              "of an error that all returns of one board and scan share; tilt likewise"},
        Field{"range_bias_m", &O::range_bias_m, -1.0, 1.0, "added to every range (no deviation)"},
        Field{"square_bias_m", &O::square_bias_m, -1.0, 1.0,
              "added to ranges on black squares more than on white ones (no deviation)"},
        Field{"angle_scale", &O::angle_scale, 0.5, 2.0, "true turn over commanded (no deviation)"},
        Field{"range_step_m", &O::range_step_m, 0.0, 0.1, "ranges are multiples of it; 0: any"}};
  }
};

struct SimulatedTurntable {
  TurntableFeatures features;
  TurntableWorld world;            ///< its rig is the truth, bias and scale included
  std::vector<double> turned_rad;  ///< true turns over the scale: commanded plus noise
};

/// Corners, stripe points (one for each pixel along the stripe) and scans of the world's rig. The
/// same seed gives the same features. No image is rendered.
[[nodiscard]] SimulatedTurntable simulate_turntable_features(const TurntableWorldOptions& world,
                                                             const TurntableNoise& noise,
                                                             std::uint64_t seed);

}  // namespace scanfuse::simulate
