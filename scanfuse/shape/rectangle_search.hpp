#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <span>
#include <utility>
#include <vector>

#include "scanfuse/geometry/angles.hpp"

namespace scanfuse::shape {

/// Which number says how well points lie on the sides of a rectangle of some heading [Zhang2017].
enum class Criterion { kCloseness, kArea, kVariance };

constexpr auto choices(Criterion) {
  return std::array{std::pair{"closeness", Criterion::kCloseness},
                    std::pair{"area", Criterion::kArea},
                    std::pair{"variance", Criterion::kVariance}};
}

/// Coordinates of the points along the two axes of one heading.
using Along = Eigen::Ref<const Eigen::ArrayXf>;

/// Smallest rectangle: score = -(max c1 - min c1)(max c2 - min c2).
struct AreaCriterion {
  [[nodiscard]] float operator()(const Along& c1, const Along& c2) const;
};

/// Points near the sides: score = sum 1 / max(distance to the nearest side, floor_m).
struct ClosenessCriterion {
  float floor_m = 0.1f;
  [[nodiscard]] float operator()(const Along& c1, const Along& c2) const;
};

/// Points of each side in line: score = -(variance of the distances to side 1 + that to side 2).
struct VarianceCriterion {
  [[nodiscard]] float operator()(const Along& c1, const Along& c2) const;
};

/// Finds the heading of the rectangle through a cluster by search over [0, 90 deg) [Zhang2017,
/// algorithm 2]. The floor of closeness follows from the step and the cluster's size, so that no
/// peak hides between two steps; a finer second pass is left to `fit_faces`.
class RectangleSearch {
 public:
  explicit RectangleSearch(Criterion criterion = Criterion::kCloseness, int steps = 18,
                           int max_points = 48)
      : criterion_(criterion), max_points_(std::min(max_points, kMostPoints)) {
    for (int k = 0; k < steps; ++k) grid_.push_back(kPi / 2 * k / steps);
  }

  /// The best of the given headings, for when lines already tell which come into question.
  [[nodiscard]] double among(std::span<const double> headings_rad,
                             std::span<const Eigen::Vector2d> points, double sigma_range_m);

  /// Heading in [0, pi/2). More than max_points points are thinned evenly. `points` not empty.
  [[nodiscard]] double operator()(std::span<const Eigen::Vector2d> points, double sigma_range_m);

 private:
  double gather(std::span<const Eigen::Vector2d> points);
  template <class Score>
  double best_heading(std::span<const double> headings_rad, const Score& score);

  Criterion criterion_;
  std::vector<double> grid_;
  int max_points_;
  static constexpr int kMostPoints = 64;
  using Buffer = Eigen::Array<float, Eigen::Dynamic, 1, 0, kMostPoints, 1>;
  Buffer x_, y_, c1_, c2_;
};

}  // namespace scanfuse::shape
