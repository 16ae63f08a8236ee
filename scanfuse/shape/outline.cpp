#include "scanfuse/shape/outline.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <utility>

#include "scanfuse/shape/face_box.hpp"
#include "scanfuse/shape/line_fit.hpp"

namespace scanfuse::shape {
namespace {

/// Ascending indices are ascending bearings, but for a cluster across the seam at +-pi: there the
/// order starts behind the widest gap between neighbours.
std::size_t first_behind_seam(const VirtualScan& scan, std::span<const std::uint32_t> indices) {
  const auto& points = scan.points;
  const float span = points[indices.back()].bearing_rad - points[indices.front()].bearing_rad;
  if (!scan.full_circle || span < 4.0f) return 0;
  std::size_t first = 0;
  float widest = static_cast<float>(2 * kPi) - span;
  for (std::size_t i = 1; i < indices.size(); ++i) {
    const float gap = points[indices[i]].bearing_rad - points[indices[i - 1]].bearing_rad;
    if (gap > widest) {
      widest = gap;
      first = i;
    }
  }
  return first;
}

/// Columns between two successive points of an object in which something nearer stopped the beam.
int hidden_columns(const VirtualScan& scan, std::uint32_t from, std::uint32_t to,
                   double nearer_by_m) {
  const PlanarPoint &a = scan.points[from], &b = scan.points[to];
  const float limit = std::min(a.range_m, b.range_m) - static_cast<float>(nearer_by_m);
  int hidden = 0;
  std::int32_t column = a.column;
  for (std::uint32_t i = from + 1; i < to; ++i) {
    const PlanarPoint& p = scan.points[i];
    if (p.range_m >= limit || p.column == column || p.column == b.column) continue;
    column = p.column;
    ++hidden;
  }
  return hidden;
}

void set_summary(const VirtualScan& scan, std::span<const std::uint32_t> order, double nearer_by_m,
                 Outline& outline) {
  const PlanarPoint& front = scan.points[order.front()];
  outline.z_low_m = front.z_low_m;
  outline.z_high_m = front.z_high_m;
  double sum = 0, squares = 0, offsets = 0, support = 0, layered = 0, layer_depth = 0;
  for (const std::uint32_t i : order) {
    const PlanarPoint& p = scan.points[i];
    offsets += p.time_offset_s;
    outline.z_low_m = std::min<double>(outline.z_low_m, p.z_low_m);
    outline.z_high_m = std::max<double>(outline.z_high_m, p.z_high_m);
    const double d = p.range_m - front.range_m;
    sum += d;
    squares += d * d;
    support += p.support;
    layered += p.support > 1 ? 1 : 0;
    layer_depth += p.depth_m;
  }
  const auto count = static_cast<double>(order.size());
  outline.mean_support = support / count;
  outline.layered_share = layered / count;
  outline.layer_depth_m = layer_depth / std::max(layered, 1.0);
  outline.beam_gap_m = scan.step_rad * (front.range_m + sum / count);
  outline.time_offset_s = offsets / count;
  outline.var_range_m2 = std::max(squares / count - (sum / count) * (sum / count), 0.0);
  double span = scan.points[order.back()].bearing_rad - front.bearing_rad;
  if (span < 0) span += 2 * kPi;
  if (scan.step_rad <= 0) return;
  int hidden = 0;
  for (std::size_t i = 1; i < order.size(); ++i) {
    hidden += hidden_columns(scan, order[i - 1], order[i], nearer_by_m);
  }
  const double columns = std::round(span / scan.step_rad) + 1 - hidden;
  outline.coverage = std::min(count / std::max(columns, 1.0), 1.0);
}

/// Of the points about their middle: 0 for a line, 1 where no direction is longer.
double roundness_of(std::span<const Eigen::Vector2d> points) {
  Eigen::Vector2d middle = Eigen::Vector2d::Zero();
  for (const auto& p : points) middle += p;
  middle /= static_cast<double>(points.size());
  double xx = 0, xy = 0, yy = 0;
  for (const auto& p : points) {
    const Eigen::Vector2d d = p - middle;
    xx += d.x() * d.x();
    xy += d.x() * d.y();
    yy += d.y() * d.y();
  }
  const double half = (xx + yy) / 2, apart = std::hypot((xx - yy) / 2, xy);
  return half + apart > 0 ? std::sqrt(std::max(half - apart, 0.0) / (half + apart)) : 0;
}

double column_step(const VirtualScan& scan, std::span<const std::uint32_t> order) {
  if (scan.step_rad > 0 || order.size() < 2) return scan.step_rad;
  const double span =
      scan.points[order.back()].bearing_rad - scan.points[order.front()].bearing_rad;
  return std::max(span, 0.0) / static_cast<double>(order.size() - 1);
}

Outline blank(Outline&& old, std::uint32_t cluster) {
  Outline fresh;
  fresh.lines = std::move(old.lines);
  fresh.lines.clear();
  fresh.cluster = cluster;
  return fresh;
}

}  // namespace

OutlineExtractor::OutlineExtractor(const ShapeOptions& options)
    : options_(options),
      iepf_(options_.iepf),
      join_(options_.join, options_.occlusion, options_.faces),
      search_(options.outline.criterion, options.outline.search_steps,
              options.outline.search_points) {}

std::span<const Outline> OutlineExtractor::operator()(const VirtualScan& scan,
                                                      const Clusters& clusters,
                                                      std::span<const Expected> expected) {
  clusters_ = &join_(scan, clusters, expected);
  const Clusters& joined = *clusters_;
  if (outlines_.size() < joined.size()) outlines_.resize(joined.size());
  for (std::size_t k = 0; k < joined.size(); ++k) {
    outlines_[k] = blank(std::move(outlines_[k]), static_cast<std::uint32_t>(k));
    outlines_[k].expected = join_.expected_of()[k];
    if (!joined[k].empty()) outline_of(scan, joined[k], outlines_[k]);
  }
  return std::span(outlines_).first(joined.size());
}

void OutlineExtractor::outline_of(const VirtualScan& scan, std::span<const std::uint32_t> indices,
                                  Outline& outline) {
  gather(scan, indices);
  outline.points = static_cast<int>(points_.size());
  set_summary(scan, order_, options_.occlusion.nearer_by_m, outline);
  outline.roundness = roundness_of(points_);
  find_lines(scan, outline);
  find_box(scan, outline);
}

void OutlineExtractor::gather(const VirtualScan& scan, std::span<const std::uint32_t> indices) {
  points_.clear();
  order_.clear();
  const std::size_t first = first_behind_seam(scan, indices);
  for (std::size_t i = 0; i < indices.size(); ++i) {
    order_.push_back(indices[(first + i) % indices.size()]);
    points_.push_back(scan.position(order_.back()));
  }
}

void OutlineExtractor::find_lines(const VirtualScan& scan, Outline& outline) {
  if (options_.outline.lines == LineMethod::kIepfLiteral) {
    outline.lines = iepf_literal(points_, options_.iepf.threshold_m);
    return;
  }
  const auto lines = iepf_(points_, scan.sigma_range_m);
  outline.lines.assign(lines.begin(), lines.end());
}

/// The first three lines and the chord bring the headings; more lines make no car. That of a track
/// which expects something here does not: it would confirm itself.
double OutlineExtractor::find_heading(const Outline& outline, double sigma_range_m) {
  if (options_.outline.search == Search::kFull) return search_(points_, sigma_range_m);
  constexpr std::size_t kMostSeeds = 4;
  std::array<double, kMostSeeds> seeds{};
  std::size_t count = 0;
  for (const LineSegment& line : outline.lines) {
    if (count + 1 < kMostSeeds && line.points > 2) seeds[count++] = line.direction_rad();
  }
  const Eigen::Vector2d chord_m = points_.back() - points_.front();
  if (outline.lines.size() != 1) seeds[count++] = std::atan2(chord_m.y(), chord_m.x());
  if (count == 0) return outline.lines.front().direction_rad();
  if (count == 1) return seeds[0];
  return search_.among(std::span(seeds).first(count), points_, sigma_range_m);
}

void OutlineExtractor::find_box(const VirtualScan& scan, Outline& outline) {
  const CutEnds cut = find_cut_ends(scan, order_.front(), order_.back(), options_.occlusion);
  const double sigma = std::max(scan.sigma_range_m, 1e-4);
  const double slack = 4 * std::hypot(sigma, options_.faces.surface_sigma_m);
  const BeamSpacing beams{column_step(scan, order_), options_.outline.max_end_gap_m, slack};
  FaceFitOptions faces = options_.faces;
  double heading = 0;
  if ((points_.back() - points_.front()).norm() > options_.outline.max_extent_m) {
    faces.min_face_points = std::numeric_limits<int>::max();
    faces.iterations = 1;
    sums_.reset(points_);
    heading = sums_.fit(0, points_.size() - 1).direction_rad();
  } else {
    if (std::ssize(outline.lines) > options_.outline.max_lines) faces.iterations = 1;
    heading = find_heading(outline, sigma);
  }
  set_box(fit_faces(points_, heading, sigma, faces), points_, cut, beams, outline);
}

}  // namespace scanfuse::shape
