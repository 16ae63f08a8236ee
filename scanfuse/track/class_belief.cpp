#include "scanfuse/track/class_belief.hpp"

#include <algorithm>
#include <cmath>

namespace scanfuse::track {
namespace {

constexpr double kLeastProbability = 1e-4;  ///< no single detection is surer than this
constexpr double kLeastLife_s = 0.25;       ///< before that a mean speed is noise

/// Hats over the knots: 1 at one's own, 0 at the neighbours', constant beyond the outermost.
template <std::size_t N>
void add_hats(double x, const std::array<double, N>& knots, BeliefTerms& terms, int& at) {
  for (std::size_t k = 0; k < N; ++k) {
    double hat = 1;
    if (x < knots[k] && k > 0) hat = 1 - (knots[k] - x) / (knots[k] - knots[k - 1]);
    if (x > knots[k] && k + 1 < N) hat = 1 - (x - knots[k]) / (knots[k + 1] - knots[k]);
    terms[at++] = std::max(hat, 0.0);
  }
}

constexpr std::array<std::string_view, kBeliefCues> kCueNames{
    "sum-vehicle",  "sum-pedestrian", "sum-cyclist", "mean-vehicle", "mean-pedestrian",
    "mean-cyclist", "log-evidence",   "seen-share",  "log-life",     "log-range",
    "log-breadth",  "breadth-waver",  "log-depth",   "depth-waver",  "log-fill",
    "height",       "layered-share",  "layer-depth", "log-speed",    "log-mean-speed"};
constexpr double kFarthestCue = 4;

double mean_speed(const ClassBelief& belief, const BeliefMotion& motion) {
  const double life_s = std::max(to_seconds(belief.last - belief.born), kLeastLife_s);
  return (motion.position_m - belief.born_m).norm() / life_s;
}

void add_shape(const ShapeCues& cues, double share, std::array<double, kShapeSums>& shape) {
  const double breadth = std::log(cues.breadth_m + 0.1), depth = std::log(cues.depth_m + 0.02);
  shape[kOfRange] += share * std::log(std::clamp(cues.range_m, 0.5, 200.0));
  shape[kOfBreadth] += share * breadth;
  shape[kOfBreadth2] += share * breadth * breadth;
  shape[kOfDepth] += share * depth;
  shape[kOfDepth2] += share * depth * depth;
  shape[kOfFill] += share * std::log(std::clamp(cues.fill, 0.05, 20.0));
  shape[kOfHeight] += share * std::min(cues.height_m, 2.0);
  shape[kOfLayered] += share * cues.layered_share;
  shape[kOfLayerDepth] += share * cues.layered_share * std::log(cues.layer_depth_m + 0.01);
}

}  // namespace

std::vector<std::string> belief_term_names() {
  std::vector<std::string> names{"one"};
  for (const auto name : kCueNames) names.emplace_back(name);
  for (int i = 0; i < kBeliefCues; ++i) {
    for (int j = i; j < kBeliefCues; ++j) {
      names.push_back(std::string(kCueNames[i]) + "-x-" + std::string(kCueNames[j]));
    }
  }
  for (int k = 0; k < kSpeeds; ++k) names.push_back("speed-" + std::to_string(k));
  for (int k = 0; k < kSpeeds; ++k) names.push_back("mean-speed-" + std::to_string(k));
  for (int k = 0; k < kSurenesses; ++k) names.push_back("speed-sureness-" + std::to_string(k));
  return names;
}

void ClassBelief::add(const Sighting& sighting, const BeliefModel& model) {
  double share = 1, sought_now = 1;
  if (is_empty()) {
    born = sighting.stamp;
    born_m = sighting.position_m;
  } else {
    const double dt_s = std::max(to_seconds(sighting.stamp - last), 0.0);
    const double fade = std::exp(-dt_s / model.memory_s);
    for (double& value : sum) value *= fade;
    for (double& value : shape) value *= fade;
    evidence *= fade;
    sought *= fade;
    sought_now = dt_s / model.full_s;
    share = std::min(sought_now, 1.0);
  }
  last = sighting.stamp;
  const auto likelihood = [&](int c) {
    return std::log(std::max(sighting.class_probability[c + 1], kLeastProbability) /
                    model.prior[c]);
  };
  for (int c = 0; c < 3; ++c) sum[c] += share * (likelihood(c) - likelihood(3));
  add_shape(sighting.cues, share, shape);
  evidence += share;
  sought += sought_now;
}

std::array<double, kBeliefCues> ClassBelief::cues(const BeliefMotion& motion) const {
  std::array<double, kBeliefCues> z{};
  const double count = std::max(evidence, 1e-6);
  for (int c = 0; c < 3; ++c) {
    z[kSumVehicle + c] = sum[c] / 30;
    z[kMeanVehicle + c] = sum[c] / count / 4;
  }
  const auto mean = [&](ShapeSum of) { return shape[of] / count; };
  const auto waver = [&](ShapeSum of, ShapeSum squares) {
    return 4 * std::sqrt(std::max(mean(squares) - mean(of) * mean(of), 0.0));
  };
  z[kLogEvidence] = std::log(std::max(evidence, 0.1)) - 1.5;
  z[kSeenShare] = 4 * (evidence / std::max(sought, 1e-6) - 1) + 1;
  z[kLogLife] = std::log(std::max(to_seconds(last - born), 0.1));
  z[kCueRange] = 1.5 * (mean(kOfRange) - 3);
  z[kCueBreadth] = 1.5 * mean(kOfBreadth);
  z[kBreadthWaver] = waver(kOfBreadth, kOfBreadth2);
  z[kCueDepth] = mean(kOfDepth) + 2.5;
  z[kDepthWaver] = waver(kOfDepth, kOfDepth2);
  z[kCueFill] = 2 * mean(kOfFill);
  z[kCueHeight] = 2 * mean(kOfHeight) - 1;
  z[kCueLayered] = 2 * mean(kOfLayered) - 1;
  if (shape[kOfLayered] > 0) z[kLayerDepth] = 1.5 * (shape[kOfLayerDepth] / shape[kOfLayered] + 3);
  z[kCueSpeed] = std::log(motion.speed_m_per_s + 0.2);
  z[kCueMeanSpeed] = std::log(mean_speed(*this, motion) + 0.2);
  for (double& value : z) value = std::clamp(value, -kFarthestCue, kFarthestCue);
  return z;
}

BeliefTerms ClassBelief::terms(const BeliefMotion& motion) const {
  BeliefTerms terms;
  int at = 0;
  terms[at++] = 1;
  const auto z = cues(motion);
  for (const double value : z) terms[at++] = value;
  for (int i = 0; i < kBeliefCues; ++i) {
    for (int j = i; j < kBeliefCues; ++j) terms[at++] = z[i] * z[j] / 2;
  }
  add_hats(motion.speed_m_per_s, kSpeedKnots_m_per_s, terms, at);
  add_hats(mean_speed(*this, motion), kSpeedKnots_m_per_s, terms, at);
  add_hats(motion.speed_m_per_s / std::max(motion.sigma_m_per_s, 0.01), kSurenessKnots, terms, at);
  return terms;
}

ClassProbabilities ClassBelief::probabilities(const BeliefMotion& motion,
                                              const BeliefModel& model) const {
  const Eigen::Vector4d logits = model.weights * terms(motion);
  const Eigen::Vector4d p = (logits.array() - logits.maxCoeff()).exp();
  const double sum_of_all = p.sum();
  ClassProbabilities all{};
  for (int c = 0; c < kBelievedClasses; ++c) all[c + 1] = p[c] / sum_of_all;
  return all;
}

}  // namespace scanfuse::track
