#pragma once

#include <algorithm>
#include <vector>

#include "scanfuse/types/bearing.hpp"
#include "scanfuse/types/gaussian.hpp"

namespace scanfuse::triangulate {

/// What a cost needs to know of one sensor, in logarithms. Nothing is believed to be certain: a
/// detection probability is at most 0.9999 and there is at least one false alarm in 1e4 scans.
struct SensorPrior {
  double log_detected = 0;
  double log_missed = 0;
  double log_clutter = 0;  ///< of the density, 1/sr (azimuth only: 1/rad)
};

/// What is believed before the bearings are looked at: the sensors, how many targets there are and
/// where.
struct ScenePrior {
  std::vector<SensorPrior> sensors;
  PassiveScene::Volume volume_m{};
  double log_intensity = 0;  ///< ln(expected targets / volume), targets per m^3
  bool flat = false;         ///< no sensor tells elevation
  Gaussian<3> place;         ///< what a flat scene says of the height: the volume's, as a Gaussian
  [[nodiscard]] const Gaussian<3>* height() const { return flat ? &place : nullptr; }
};

/// The scene's own figures where it has them. A volume that is not given is the box around the
/// places where lines of two sensors pass each other closely (5 to 95 %, widened by half); an
/// expected number that is not given is what the sensors' counts leave after their false alarms,
/// at least 1. The flags say so, for the user.
struct EstimatedPrior {
  ScenePrior prior;
  bool volume_estimated = false;
  bool targets_estimated = false;
};
[[nodiscard]] EstimatedPrior scene_prior(const PassiveScene& scene, const BearingScan& scan);

/// The chance that none or one of several independent things happens, one after the other.
class AtMostOne {
 public:
  void add(double probability) {
    one_ = one_ * (1 - probability) + none_ * probability;
    none_ *= 1 - probability;
  }
  [[nodiscard]] double probability() const { return std::min(none_ + one_, 1.0); }

 private:
  double none_ = 1, one_ = 0;
};

}  // namespace scanfuse::triangulate
