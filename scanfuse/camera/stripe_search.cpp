#include "scanfuse/camera/stripe_search.hpp"

#include <algorithm>
#include <cmath>

#include "scanfuse/camera/gaussian.hpp"
#include "scanfuse/core/random.hpp"

namespace scanfuse::camera {
namespace {

using Eigen::Vector2d;

constexpr double kSigma_cells = 1.2;
constexpr double kNear_cells = 1.2;  ///< from the line
constexpr double kMostTurn = 0.90;   ///< cosine between a ridge's normal and the line's
constexpr std::size_t kMostPoints = 1500;
constexpr int kTrials = 600;
constexpr std::size_t kSeeds = 300;  ///< the strongest points, of which every second pair is drawn
constexpr int kFewestPoints = 6;

struct RidgePoint {
  Vector2d at;  ///< in cells
  Vector2d normal;
  double weight = 0;
};

/// All second-order derivatives of the smoothed plane, one value a cell.
struct Derivatives {
  std::vector<float> x, y, xx, xy, yy;
};

using Kernel = std::vector<float>;

std::vector<float> along_rows(const std::vector<float>& in, int width, int height,
                              const Kernel& kernel) {
  const int radius = static_cast<int>(kernel.size() / 2);
  std::vector<float> out(in.size());
  for (int r = 0; r < height; ++r) {
    const float* row = in.data() + static_cast<std::ptrdiff_t>(r) * width;
    float* to = out.data() + static_cast<std::ptrdiff_t>(r) * width;
    for (int c = radius; c + radius < width; ++c) {
      float sum = 0;
      for (int k = 0; k < 2 * radius + 1; ++k) {
        sum += kernel[static_cast<std::size_t>(k)] * row[c + k - radius];
      }
      to[c] = sum;
    }
  }
  return out;
}

std::vector<float> along_columns(const std::vector<float>& in, int width, int height,
                                 const Kernel& kernel) {
  const int radius = static_cast<int>(kernel.size() / 2);
  std::vector<float> out(in.size());
  for (int r = radius; r + radius < height; ++r) {
    float* to = out.data() + static_cast<std::ptrdiff_t>(r) * width;
    for (int k = 0; k < 2 * radius + 1; ++k) {
      const float weight = kernel[static_cast<std::size_t>(k)];
      const float* row = in.data() + static_cast<std::ptrdiff_t>(r + k - radius) * width;
      for (int c = 0; c < width; ++c) to[c] += weight * row[c];
    }
  }
  return out;
}

Derivatives derive(const CoarsePlane& plane, const GaussianKernels& kernels) {
  const auto rows = [&](const Kernel& k) {
    return along_rows(plane.values, plane.width, plane.height, k);
  };
  const auto columns = [&](const std::vector<float>& in, const Kernel& k) {
    return along_columns(in, plane.width, plane.height, k);
  };
  const auto smooth = rows(kernels.value), slope = rows(kernels.slope);
  return {columns(slope, kernels.value), columns(smooth, kernels.slope),
          columns(rows(kernels.curvature), kernels.value), columns(slope, kernels.slope),
          columns(smooth, kernels.curvature)};
}

/// The ridge point of one cell, where it has one: along the normal n (the eigenvector of the most
/// negative curvature) the slope vanishes at t = -(n . g) / (n' H n), within the cell.
std::optional<RidgePoint> ridge_at(const Derivatives& d, std::size_t i) {
  const double xx = d.xx[i], yy = d.yy[i], xy = d.xy[i];
  const double half_sum = (xx + yy) / 2, half_gap = std::hypot((xx - yy) / 2, xy);
  const double bend = half_sum - half_gap;
  if (!(bend < 0) || std::abs(half_sum + half_gap) > -0.7 * bend) return {};
  const double angle = 0.5 * std::atan2(2 * xy, xx - yy) + EIGEN_PI / 2;
  const Vector2d n(std::cos(angle), std::sin(angle));
  const double t = -(n.x() * d.x[i] + n.y() * d.y[i]) / bend;
  if (std::abs(t * n.x()) > 0.6 || std::abs(t * n.y()) > 0.6) return {};
  return RidgePoint{t * n, n, -bend};
}

/// The strongest ridge points, strongest first; of equal ones the first.
std::vector<RidgePoint> strongest(std::vector<RidgePoint> points) {
  std::stable_sort(points.begin(), points.end(),
                   [](const auto& a, const auto& b) { return a.weight > b.weight; });
  points.resize(std::min(points.size(), kMostPoints));
  return points;
}

std::vector<RidgePoint> ridge_points(const CoarsePlane& plane,
                                     std::span<const Vector2d> polygon_px) {
  const GaussianKernels kernels(kSigma_cells);
  const Derivatives d = derive(plane, kernels);
  std::vector<RidgePoint> points;
  for (int r = kernels.radius; r + kernels.radius < plane.height; ++r) {
    for (int c = kernels.radius; c + kernels.radius < plane.width; ++c) {
      const auto i = static_cast<std::size_t>(r) * static_cast<std::size_t>(plane.width) +
                     static_cast<std::size_t>(c);
      if (!(d.xx[i] + d.yy[i] < 0)) continue;
      auto point = ridge_at(d, i);
      if (!point) continue;
      point->at += Vector2d(c, r);
      if (!is_inside(polygon_px, plane.origin_px + plane.pitch_px * Vector2d(c, r))) continue;
      points.push_back(*point);
    }
  }
  return strongest(std::move(points));
}

struct Line {
  Vector2d at = Vector2d::Zero();
  Vector2d normal = Vector2d::UnitX();
};

bool supports(const RidgePoint& point, const Line& line) {
  return std::abs(line.normal.dot(point.at - line.at)) < kNear_cells &&
         std::abs(line.normal.dot(point.normal)) > kMostTurn;
}

/// The line through two of the points that the others support most, and its score.
std::pair<Line, double> best_line(const std::vector<RidgePoint>& points) {
  RandomStream random(0);
  std::pair<Line, double> best{{}, 0};
  for (int trial = 0; trial < kTrials; ++trial) {
    const std::size_t among = trial % 2 == 0 ? std::min(kSeeds, points.size()) : points.size();
    const RidgePoint& a = points[random.below(among)];
    const RidgePoint& b = points[random.below(among)];
    const Vector2d step = b.at - a.at;
    if (step.norm() < 4) continue;
    const Line line{a.at, Vector2d(-step.y(), step.x()).normalized()};
    if (!supports(a, line) || !supports(b, line)) continue;
    double score = 0;
    for (const auto& point : points) {
      if (supports(point, line)) score += point.weight;
    }
    if (score > best.second) best = {line, score};
  }
  return best;
}

StripeCurve straight(const Line& line) {
  StripeCurve curve;
  curve.upright = std::abs(line.normal.x()) >= std::abs(line.normal.y());
  const double along = curve.along_of(line.at), across = line.at.sum() - along;
  const double ratio =
      curve.upright ? -line.normal.y() / line.normal.x() : -line.normal.x() / line.normal.y();
  curve.middle_px = along;
  curve.c0 = across;
  curve.c1 = ratio;
  return curve;
}

}  // namespace

std::optional<RoughStripe> search_stripe(const CoarsePlane& plane,
                                         std::span<const Vector2d> polygon_px) {
  const auto points = ridge_points(plane, polygon_px);
  if (points.size() < kFewestPoints) return {};
  const auto [line, score] = best_line(points);
  if (!(score > 0)) return {};
  std::vector<Vector2d> supporters;
  for (const auto& point : points) {
    // A little wider than the line: the stripe may bend.
    if (std::abs(line.normal.dot(point.at - line.at)) > 2 * kNear_cells) continue;
    if (std::abs(line.normal.dot(point.normal)) < kMostTurn) continue;
    supporters.emplace_back(plane.origin_px + plane.pitch_px * point.at);
  }
  if (supporters.size() < kFewestPoints) return {};
  const Line line_px{plane.origin_px + plane.pitch_px * line.at, line.normal};
  const auto fit = fit_curve(supporters, straight(line_px), 0.5 * plane.pitch_px);
  if (!fit) return {};
  return RoughStripe{fit->curve, score, 2 * fit->curve.half_px};
}

}  // namespace scanfuse::camera
