#include "scanfuse/shape/rectangle_search.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "scanfuse/geometry/angles.hpp"

namespace scanfuse::shape {
namespace {

/// The nearer of the two sides as a whole: distances to max or to min, whichever sum is smaller.
/// sign * (edge - c) >= 0.
struct NearSide {
  float edge = 0;
  float sign = 1;
};

NearSide near_side(const Along& c) {
  const float high = c.maxCoeff(), low = c.minCoeff();
  return c.mean() > (high + low) / 2 ? NearSide{high, 1.0f} : NearSide{low, -1.0f};
}

}  // namespace

float AreaCriterion::operator()(const Along& c1, const Along& c2) const {
  return -(c1.maxCoeff() - c1.minCoeff()) * (c2.maxCoeff() - c2.minCoeff());
}

float ClosenessCriterion::operator()(const Along& c1, const Along& c2) const {
  const NearSide s1 = near_side(c1), s2 = near_side(c2);
  const auto d1 = s1.sign * (s1.edge - c1), d2 = s2.sign * (s2.edge - c2);
  return d1.min(d2).max(floor_m).inverse().sum();
}

float VarianceCriterion::operator()(const Along& c1, const Along& c2) const {
  const NearSide s1 = near_side(c1), s2 = near_side(c2);
  std::array<float, 2> sum{}, squares{}, count{};
  for (Eigen::Index i = 0; i < c1.size(); ++i) {
    const float d1 = s1.sign * (s1.edge - c1[i]), d2 = s2.sign * (s2.edge - c2[i]);
    const std::size_t side = d1 < d2 ? 0 : 1;
    const float d = std::min(d1, d2);
    sum[side] += d;
    squares[side] += d * d;
    count[side] += 1;
  }
  float total = 0;
  for (const std::size_t side : {0, 1}) {
    if (count[side] > 0) total += squares[side] - sum[side] * sum[side] / count[side];
  }
  return -total;
}

template <class Score>
double RectangleSearch::best_heading(std::span<const double> headings_rad, const Score& score) {
  double best = 0;
  float highest = -std::numeric_limits<float>::infinity();
  for (const double heading : headings_rad) {
    const auto c = static_cast<float>(std::cos(heading)), s = static_cast<float>(std::sin(heading));
    c1_ = c * x_ + s * y_;
    c2_ = c * y_ - s * x_;
    const float value = score(c1_, c2_);
    if (value > highest) {
      highest = value;
      best = heading;
    }
  }
  return best;
}

/// Thins the points into the buffers; the greatest distance from the first.
double RectangleSearch::gather(std::span<const Eigen::Vector2d> points) {
  const auto count = static_cast<Eigen::Index>(points.size());
  const Eigen::Index stride = (count + max_points_ - 1) / max_points_;
  const Eigen::Index kept = (count + stride - 1) / stride;
  for (auto* buffer : {&x_, &y_, &c1_, &c2_}) buffer->resize(kept);
  const Eigen::Vector2d& origin = points.front();
  double reach = 0;
  for (Eigen::Index i = 0; i < kept; ++i) {
    const Eigen::Vector2d d = points[static_cast<std::size_t>(i * stride)] - origin;
    x_[i] = static_cast<float>(d.x());
    y_[i] = static_cast<float>(d.y());
    reach = std::max(reach, d.squaredNorm());
  }
  return std::sqrt(reach);
}

double RectangleSearch::operator()(std::span<const Eigen::Vector2d> points, double sigma_range_m) {
  return among(grid_, points, sigma_range_m);
}

double RectangleSearch::among(std::span<const double> headings_rad,
                              std::span<const Eigen::Vector2d> points, double sigma_range_m) {
  const double reach = gather(points);
  if (!(reach > 0)) return 0;
  switch (criterion_) {
    case Criterion::kArea:
      return best_heading(headings_rad, AreaCriterion{});
    case Criterion::kVariance:
      return best_heading(headings_rad, VarianceCriterion{});
    case Criterion::kCloseness:
      break;
  }
  const double half_step = kPi / 4 / static_cast<double>(std::max<std::size_t>(grid_.size(), 1));
  const double floor = std::max(2 * sigma_range_m, reach / 2 * half_step);
  return best_heading(headings_rad, ClosenessCriterion{static_cast<float>(floor)});
}

}  // namespace scanfuse::shape
