#pragma once

#include <Eigen/Core>
#include <array>
#include <string>
#include <vector>

#include "scanfuse/core/time.hpp"
#include "scanfuse/types/detection.hpp"

namespace scanfuse::track {

/// Rows of the belief: vehicle, pedestrian, cyclist, other.
inline constexpr int kBelievedClasses = 4;
inline constexpr std::array kSpeedKnots_m_per_s{0.0, 0.3, 0.7, 1.2, 2.0, 3.0, 4.5, 7.0, 11.0};
inline constexpr std::array kSurenessKnots{0.0, 1.0, 2.0, 4.0, 8.0, 16.0};
inline constexpr int kSpeeds = static_cast<int>(kSpeedKnots_m_per_s.size());
inline constexpr int kSurenesses = static_cast<int>(kSurenessKnots.size());

/// What of a track tells its class. All are bounded and have a value for every sensor.
enum BeliefCue : int {
  kSumVehicle,  ///< sums of log likelihood ratios against "other"
  kSumPedestrian,
  kSumCyclist,
  kMeanVehicle,  ///< the same by detection
  kMeanPedestrian,
  kMeanCyclist,
  kLogEvidence,   ///< ln of how many detections that is
  kSeenShare,     ///< of the time it was looked for, that in which it was seen
  kLogLife,       ///< ln of the time since birth
  kCueRange,      ///< ln of the distance from the sensor
  kCueBreadth,    ///< ln of the mean breadth across the line of sight
  kBreadthWaver,  ///< deviation of that logarithm from scan to scan: limbs swing, leaves flutter
  kCueDepth,      ///< ln of the mean depth along the line of sight
  kDepthWaver,
  kCueFill,       ///< mean ln of points against those expected
  kCueHeight,     ///< mean height seen
  kCueLayered,    ///< share of points that several layers see; 0: height and layer depth unknown
  kLayerDepth,    ///< ln of how far apart layers see it: upright or not
  kCueSpeed,      ///< ln of the filter's speed
  kCueMeanSpeed,  ///< ln of the mean speed since birth
  kBeliefCues
};

/// Terms of the belief: 1; the cues; every product of two; hats of the filter's speed, of the mean
/// speed since birth, and of the speed in its own deviations.
inline constexpr int kBeliefTerms =
    1 + kBeliefCues + kBeliefCues * (kBeliefCues + 1) / 2 + 2 * kSpeeds + kSurenesses;
/// What is summed of a shape: ln range, ln breadth and its square, ln depth and its square, ln
/// fill, height, layered share, and of layered points: their number and ln of their depth.
enum ShapeSum : int {
  kOfRange,
  kOfBreadth,
  kOfBreadth2,
  kOfDepth,
  kOfDepth2,
  kOfFill,
  kOfHeight,
  kOfLayered,
  kOfLayerDepth,
  kShapeSums
};

using BeliefTerms = Eigen::Matrix<double, kBeliefTerms, 1>;
[[nodiscard]] std::vector<std::string> belief_term_names();

/// p(class | track) = softmax(weights terms). Successive scans see an object alike, so their
/// likelihoods are not independent: the weights of the sums, below 1, are the exponent that makes
/// up for it. They come from `scanfuse learn classes`, by regression on tracks that the recogniser
/// was not fitted to.
struct BeliefModel {
  double memory_s = 2.0;  ///< evidence fades by 1/e in this time
  double full_s = 0.1;    ///< detections nearer in time than this count in proportion
  std::array<double, kBelievedClasses> prior{0.25, 0.25, 0.25, 0.25};  ///< that detections carry
  Eigen::Matrix<double, kBelievedClasses, kBeliefTerms> weights;
};

/// How a track moves, as far as its class is concerned.
struct BeliefMotion {
  Eigen::Vector2d position_m = Eigen::Vector2d::Zero();
  double speed_m_per_s = 0;
  double sigma_m_per_s = 1;
};

/// What one detection adds to it.
struct Sighting {
  ClassProbabilities class_probability{};
  ShapeCues cues;
  Eigen::Vector2d position_m = Eigen::Vector2d::Zero();
  Time stamp;
};

/// What is believed of the class of one track. Bounded: with n detections a second the sums never
/// exceed memory_s / full_s + 1 detections' worth.
struct ClassBelief {
  std::array<double, 3> sum{};  ///< of ln p(c) / prior(c) - ln p(other) / prior(other), faded
  double evidence = 0;          ///< detections that the sum is worth
  double sought = 0;            ///< and would be worth had every scan seen it
  std::array<double, kShapeSums> shape{};  ///< sums of cues, faded alike
  Eigen::Vector2d born_m = Eigen::Vector2d::Zero();
  Time born, last;

  [[nodiscard]] bool is_empty() const { return evidence <= 0; }
  void add(const Sighting& sighting, const BeliefModel& model);
  [[nodiscard]] std::array<double, kBeliefCues> cues(const BeliefMotion& motion) const;
  [[nodiscard]] BeliefTerms terms(const BeliefMotion& motion) const;
  [[nodiscard]] ClassProbabilities probabilities(const BeliefMotion& motion,
                                                 const BeliefModel& model) const;
};

}  // namespace scanfuse::track
