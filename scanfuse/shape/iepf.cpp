#include "scanfuse/shape/iepf.hpp"

#include <algorithm>
#include <cmath>

namespace scanfuse::shape {
namespace {

struct Farthest {
  std::size_t index = 0;
  double distance_m = 0;
};

/// Of the points strictly between first and last, the one farthest from their chord [Lu2018, eq.
/// 4]:
///   d = |(q - p) x (x - p)| / |q - p|, or |x - p| where q = p
Farthest farthest_from_chord(std::span<const Eigen::Vector2d> points, std::size_t first,
                             std::size_t last) {
  const Eigen::Vector2d& origin = points[first];
  const Eigen::Vector2d along = points[last] - origin;
  const double length = along.norm();
  Farthest best{first, 0};
  for (std::size_t i = first + 1; i < last; ++i) {
    const Eigen::Vector2d d = points[i] - origin;
    const double distance = length > 0 ? std::abs(along.x() * d.y() - along.y() * d.x()) : d.norm();
    if (distance > best.distance_m) best = {i, distance};
  }
  if (length > 0) best.distance_m /= length;
  return best;
}

/// Calls `emit(first, last)` for every straight run, in order.
template <class Emit>
void split_runs(std::span<const Eigen::Vector2d> points, double threshold_m,
                std::vector<std::pair<std::size_t, std::size_t>>& stack, const Emit& emit) {
  stack.clear();
  if (points.empty()) return;
  stack.emplace_back(0, points.size() - 1);
  while (!stack.empty()) {
    const auto [first, last] = stack.back();
    stack.pop_back();
    const Farthest far = farthest_from_chord(points, first, last);
    if (far.distance_m <= threshold_m) {
      emit(first, last);
      continue;
    }
    stack.emplace_back(far.index, last);
    stack.emplace_back(first, far.index);
  }
}

/// Of the angle between the two; 1 where one has no length.
double cos_between(const LineSegment& a, const LineSegment& b) {
  const Eigen::Vector2d u = a.last_m - a.first_m, v = b.last_m - b.first_m;
  const double lengths = u.squaredNorm() * v.squaredNorm();
  return lengths > 0 ? u.dot(v) / std::sqrt(lengths) : 1;
}

}  // namespace

std::span<const LineSegment> Iepf::operator()(std::span<const Eigen::Vector2d> points,
                                              double sigma_range_m) {
  lines_.clear();
  if (points.empty()) return lines_;
  const double range = points[points.size() / 2].norm();
  split(points, std::max({options_.threshold_m, options_.sigma_factor * sigma_range_m,
                          options_.range_factor * range}));
  merge();
  drop_stubs();
  for (const Run& run : runs_) lines_.push_back(run.line);
  return lines_;
}

void Iepf::split(std::span<const Eigen::Vector2d> points, double threshold_m) {
  runs_.clear();
  sums_.reset(points);
  split_runs(points, threshold_m, stack_, [&](std::size_t first, std::size_t last) {
    runs_.push_back({first, last, sums_.fit(first, last)});
  });
}

void Iepf::merge() {
  std::size_t kept = 0;
  for (std::size_t k = 1; k < runs_.size(); ++k) {
    Run& before = runs_[kept];
    const Run& next = runs_[k];
    const bool joined = cos_between(before.line, next.line) > merge_cos_ &&
                        (next.line.first_m - before.line.last_m).norm() < options_.merge_gap_m;
    if (joined) {
      before.last = next.last;
      before.line = sums_.fit(before.first, before.last);
    } else {
      runs_[++kept] = next;
    }
  }
  runs_.resize(kept + 1);
}

void Iepf::drop_stubs() {
  const auto shorter = [](const Run& a, const Run& b) {
    return a.line.length_m() < b.line.length_m();
  };
  const Run longest = *std::max_element(runs_.begin(), runs_.end(), shorter);
  std::erase_if(runs_, [&](const Run& r) { return r.line.length_m() < options_.min_length_m; });
  if (runs_.empty()) runs_.push_back(longest);
}

std::vector<LineSegment> iepf_literal(std::span<const Eigen::Vector2d> points, double threshold_m) {
  std::vector<std::pair<std::size_t, std::size_t>> stack;
  std::vector<LineSegment> lines;
  split_runs(points, threshold_m, stack, [&](std::size_t first, std::size_t last) {
    lines.push_back(chord(points.subspan(first, last - first + 1)));
  });
  return lines;
}

}  // namespace scanfuse::shape
