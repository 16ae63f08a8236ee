#pragma once

#include "scanfuse/simulate/passive.hpp"
#include "scanfuse/triangulate/associate_scan.hpp"

namespace scanfuse::associate::scenes {

/// What `scanfuse associate` solves: the hypotheses of a simulated scan at their evidence.
inline Packing triangulated(const simulate::PassiveOptions& options, std::uint64_t seed) {
  const auto recording = simulate::simulate_passive(options, seed);
  const auto& scan = recording->scans[0];
  const auto prior = triangulate::scene_prior(recording->scene, scan).prior;
  return triangulate::weigh_hypotheses(scan, recording->scene, prior, {}, 1)->packing;
}

/// Targets and sensors anywhere in 40 x 40 x 11 km, detection probability 0.9.
inline simulate::PassiveOptions crowd(int targets, int sensors, double noise_rad,
                                      double false_alarms) {
  simulate::PassiveOptions options;
  options.targets = targets;
  options.sensors = sensors;
  options.noise_rad = noise_rad;
  options.detection_probability = 0.9;
  options.false_alarms = false_alarms;
  options.sensor_layout = simulate::SensorLayout::kRandom;
  options.target_layout = simulate::TargetLayout::kRandom;
  return options;
}

}  // namespace scanfuse::associate::scenes
