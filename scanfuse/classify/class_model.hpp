#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "scanfuse/classify/features.hpp"
#include "scanfuse/types/object_class.hpp"

namespace scanfuse::classify {

/// The classes that are learned, in the order of rows: vehicle, pedestrian, cyclist, other.
inline constexpr int kLearnedClasses = 4;
[[nodiscard]] constexpr ObjectClass learned_class(int row) {
  return static_cast<ObjectClass>(row + 1);
}

/// Where the piecewise linear terms of length and width have their corners, in ln(m + 0.1).
inline constexpr std::array kLengthKnots_m{0.2, 0.35, 0.5, 0.75, 1.1, 1.5, 2.0, 2.6, 4.0, 6.0};
inline constexpr int kKnots = static_cast<int>(kLengthKnots_m.size());

/// Terms of the classifier: 1, every feature, every product of two (a feature with itself
/// included; those with ln range and ln beam gap make the others depend on range), hats of length
/// and width.
inline constexpr int kTerms = 1 + kFeatures + kFeatures * (kFeatures + 1) / 2 + 2 * kKnots;
[[nodiscard]] std::vector<std::string> term_names();

using Terms = Eigen::Matrix<double, kTerms, 1>;

/// Softmax regression: p(class) ~ exp(w_class' terms(x) / temperature), features standardised to
/// (x - mean) / scale and cut at +-4 first. Weights, and the temperature that makes it say how
/// often it is right, come from `scanfuse learn classes`.
struct SoftmaxModel {
  Features mean{};
  Features scale{};
  Eigen::Matrix<double, kLearnedClasses, Eigen::Dynamic> weights;  ///< kTerms columns
  double temperature = 1;
  std::array<double, kLearnedClasses> prior{0.25, 0.25, 0.25, 0.25};  ///< shares in training

  [[nodiscard]] Terms terms(const Features& x) const;
  [[nodiscard]] ClassProbabilities operator()(const Features& x) const;
};

/// [Guo]'s reference intervals of one class: the length l of one line, l1 >= l2 of two, and the
/// variance of the points' ranges.
struct Interval {
  double low = 0;
  double high = -1;  ///< below low: the class does not come so
  [[nodiscard]] bool is_empty() const { return high < low; }
};
struct ClassIntervals {
  Interval l, var_r_of_one;
  Interval l1, l2, var_r_of_two;
};
using Intervals = std::array<ClassIntervals, 3>;  ///< vehicle, pedestrian, cyclist

/// [Guo]: the class whose intervals hold l, or l1 and l2, and the variance of range. Where several
/// do, which is so for half of the objects and the paper leaves open, the one whose middle is
/// nearest, distances in half widths. None: no class, or more than two lines.
[[nodiscard]] std::optional<ObjectClass> class_by_intervals(const Outline& outline,
                                                            const Intervals& intervals,
                                                            double scale = 1);

/// What `scanfuse learn classes` gives to the recogniser.
struct ClassModel {
  SoftmaxModel softmax;
  Intervals intervals;
};

}  // namespace scanfuse::classify
