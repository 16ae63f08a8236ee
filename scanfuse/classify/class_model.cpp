#include "scanfuse/classify/class_model.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace scanfuse::classify {
namespace {

constexpr double kFarthestDeviation = 4;

/// Hats over the knots: 1 at one's own, 0 at the neighbours', constant beyond the outermost.
void add_hats(double log_m, Terms& terms, int& at) {
  const double x = std::exp(log_m) - 0.1;
  const double place = std::log(std::max(x, 1e-3));
  for (int k = 0; k < kKnots; ++k) {
    const auto knot = [](int i) { return std::log(kLengthKnots_m[i]); };
    double hat = 1;
    if (place < knot(k) && k > 0) {
      hat = 1 - (knot(k) - place) / (knot(k) - knot(k - 1));
    } else if (place > knot(k) && k + 1 < kKnots) {
      hat = 1 - (place - knot(k)) / (knot(k + 1) - knot(k));
    }
    terms[at++] = std::max(hat, 0.0);
  }
}

/// Distance from the middle in half widths; above 1 outside.
double normalised(double value, const Interval& interval) {
  if (interval.is_empty()) return 1e9;
  const double half = std::max((interval.high - interval.low) / 2, 1e-6);
  return std::abs(value - (interval.high + interval.low) / 2) / half;
}

}  // namespace

std::vector<std::string> term_names() {
  const auto& names = feature_names();
  std::vector<std::string> all{"one"};
  for (const auto& name : names) all.emplace_back(name);
  for (int i = 0; i < kFeatures; ++i) {
    for (int j = i; j < kFeatures; ++j) {
      all.push_back(std::string(names[i]) + "-x-" + std::string(names[j]));
    }
  }
  for (const char* side : {"length", "width"}) {
    for (int k = 0; k < kKnots; ++k) all.push_back(side + ("-hat-" + std::to_string(k)));
  }
  return all;
}

Terms SoftmaxModel::terms(const Features& x) const {
  Features z{};
  for (int i = 0; i < kFeatures; ++i) {
    z[i] = std::clamp((x[i] - mean[i]) / scale[i], -kFarthestDeviation, kFarthestDeviation);
  }
  Terms terms;
  int at = 0;
  terms[at++] = 1;
  for (int i = 0; i < kFeatures; ++i) terms[at++] = z[i];
  for (int i = 0; i < kFeatures; ++i) {
    for (int j = i; j < kFeatures; ++j) terms[at++] = z[i] * z[j] / 2;
  }
  add_hats(x[kLogLength], terms, at);
  add_hats(x[kLogWidth], terms, at);
  return terms;
}

ClassProbabilities SoftmaxModel::operator()(const Features& x) const {
  const Eigen::Matrix<double, kLearnedClasses, 1> logits = weights * terms(x) / temperature;
  const double top = logits.maxCoeff();
  ClassProbabilities p{};
  double sum = 0;
  for (int c = 0; c < kLearnedClasses; ++c) sum += p[c + 1] = std::exp(logits[c] - top);
  for (double& value : p) value /= sum;
  return p;
}

std::optional<ObjectClass> class_by_intervals(const Outline& outline, const Intervals& intervals,
                                              double scale) {
  if (outline.lines.empty() || outline.lines.size() > 2) return std::nullopt;
  const double variance = outline.var_range_m2 / (scale * scale);
  double l1 = outline.lines.front().length_m() / scale;
  double l2 = outline.lines.back().length_m() / scale;
  if (l1 < l2) std::swap(l1, l2);
  std::optional<ObjectClass> best;
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t c = 0; c < intervals.size(); ++c) {
    const ClassIntervals& of = intervals[c];
    const bool one = outline.lines.size() == 1;
    const std::array<double, 3> apart{
        normalised(l1, one ? of.l : of.l1), one ? 0.0 : normalised(l2, of.l2),
        normalised(variance, one ? of.var_r_of_one : of.var_r_of_two)};
    if (*std::max_element(apart.begin(), apart.end()) > 1) continue;
    const double distance = std::hypot(apart[0], apart[1], apart[2]);
    if (distance >= nearest) continue;
    nearest = distance;
    best = static_cast<ObjectClass>(c + 1);
  }
  return best;
}

}  // namespace scanfuse::classify
