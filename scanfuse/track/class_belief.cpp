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

}  // namespace

std::vector<std::string> belief_term_names() {
  std::vector<std::string> names{"one"};
  for (const char* kind : {"sum", "mean"}) {
    for (const char* of : {"vehicle", "pedestrian", "cyclist"}) {
      names.push_back(std::string(kind) + "-" + of);
    }
  }
  names.emplace_back("log-evidence");
  for (int k = 0; k < kSpeeds; ++k) names.push_back("speed-" + std::to_string(k));
  for (int k = 0; k < kSpeeds; ++k) names.push_back("mean-speed-" + std::to_string(k));
  for (int k = 0; k < kSurenesses; ++k) names.push_back("speed-sureness-" + std::to_string(k));
  return names;
}

void ClassBelief::add(const ClassProbabilities& detected, const Eigen::Vector2d& position_m,
                      Time stamp, const BeliefModel& model) {
  double share = 1;
  if (is_empty()) {
    born = stamp;
    born_m = position_m;
  } else {
    const double dt_s = std::max(to_seconds(stamp - last), 0.0);
    const double fade = std::exp(-dt_s / model.memory_s);
    for (double& value : sum) value *= fade;
    evidence *= fade;
    share = std::min(dt_s / model.full_s, 1.0);
  }
  last = stamp;
  const auto likelihood = [&](int c) {
    return std::log(std::max(detected[c + 1], kLeastProbability) / model.prior[c]);
  };
  for (int c = 0; c < 3; ++c) sum[c] += share * (likelihood(c) - likelihood(3));
  evidence += share;
}

BeliefTerms ClassBelief::terms(const BeliefMotion& motion) const {
  BeliefTerms terms;
  int at = 0;
  terms[at++] = 1;
  for (const double value : sum) terms[at++] = value / 10;
  for (const double value : sum) terms[at++] = value / std::max(evidence, 1e-6) / 5;
  terms[at++] = std::log(std::max(evidence, 0.1));
  const double life_s = std::max(to_seconds(last - born), kLeastLife_s);
  const double mean_speed = (motion.position_m - born_m).norm() / life_s;
  add_hats(motion.speed_m_per_s, kSpeedKnots_m_per_s, terms, at);
  add_hats(mean_speed, kSpeedKnots_m_per_s, terms, at);
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
