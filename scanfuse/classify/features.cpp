#include "scanfuse/classify/features.hpp"

#include <algorithm>
#include <cmath>

namespace scanfuse::classify {
namespace {

/// How wide the box stands across the line of sight.
double breadth_m(const Box2& box) {
  const double turn = box.heading_rad - std::atan2(box.centre_m.y(), box.centre_m.x());
  return box.length_m * std::abs(std::sin(turn)) + box.width_m * std::abs(std::cos(turn));
}

/// How many points a full face of that breadth would have.
double points_expected(const Outline& outline, double metre) {
  const double gap = std::max(outline.beam_gap_m * metre, 0.005);
  return std::max(breadth_m(outline.box) * metre / gap, 1.0);
}

double log_within(double value, double low, double high) {
  return std::log(std::clamp(value, low, high));
}

}  // namespace

const std::array<std::string_view, kFeatures>& feature_names() {
  static constexpr std::array<std::string_view, kFeatures> kNames{
      "log_points",       "log_range",     "log_beam_gap", "log_fill",      "log_length",
      "log_width",        "height",        "log_support",  "log_residual",  "roundness",
      "log_range_spread", "coverage",      "line_count",   "inlier_share",  "hidden_ends",
      "free_ends",        "vehicle_score", "log_alone",    "layered_share", "log_layer_depth"};
  return kNames;
}

double alone_m(std::span<const Outline> outlines, std::size_t of, double limit_m) {
  constexpr std::size_t kAround = 64;
  const Eigen::Vector2d& place = outlines[of].box.centre_m;
  const std::size_t first = of > kAround ? of - kAround : 0;
  const std::size_t last = std::min(outlines.size(), of + kAround + 1);
  double nearest = limit_m;
  for (std::size_t i = first; i < last; ++i) {
    const Outline& other = outlines[i];
    if (i == of || other.points == 0) continue;
    const double reach = nearest + (other.box.length_m + other.box.width_m) / 2;
    if ((other.box.centre_m - place).squaredNorm() > reach * reach) continue;
    const Eigen::Vector2d local = other.box.pose().inverse() * place;
    const double x = std::max(std::abs(local.x()) - other.box.length_m / 2, 0.0);
    const double y = std::max(std::abs(local.y()) - other.box.width_m / 2, 0.0);
    nearest = std::min(nearest, std::hypot(x, y));
  }
  return nearest;
}

Features features_of(std::span<const Outline> outlines, std::size_t of, double vehicle_score,
                     double scale) {
  constexpr double kFarAway_m = 4, kUsualLayerDepth_m = 0.05;
  const Outline& outline = outlines[of];
  const double metre = 1 / scale;
  const double gap = std::max(outline.beam_gap_m * metre, 0.005);
  const bool cut = outline.left_end_occluded || outline.right_end_occluded;
  Features x{};
  x[kLogPoints] = log_within(outline.points, 1, 1000);
  x[kLogRange] = log_within(outline.box.centre_m.norm() * metre, 0.5, 200);
  x[kLogBeamGap] = log_within(gap, 0.005, 2);
  x[kLogFill] = log_within(outline.points / points_expected(outline, metre), 0.05, 20);
  x[kLogLength] = log_within(outline.box.length_m * metre + 0.1, 0.1, 15);
  x[kLogWidth] = log_within(outline.box.width_m * metre + 0.1, 0.1, 5);
  x[kHeight] = std::clamp((outline.z_high_m - outline.z_low_m) * metre, 0.0, 2.0);
  x[kLogSupport] = log_within(outline.mean_support, 1, 64);
  x[kLogResidual] = log_within(outline.residual_m * metre + 0.01, 0.01, 1);
  x[kRoundness] = std::clamp(outline.roundness, 0.0, 1.0);
  x[kLogRangeSpread] =
      log_within(std::sqrt(std::max(outline.var_range_m2, 0.0)) * metre + 0.02, 0.02, 4);
  x[kCoverage] = std::clamp(outline.coverage, 0.0, 1.0);
  x[kLineCount] = static_cast<double>(std::min<std::size_t>(outline.lines.size(), 4));
  x[kInlierShare] = std::clamp(outline.inlier_share, 0.0, 1.0);
  x[kHiddenEnds] = static_cast<double>(outline.left_end_occluded) +
                   static_cast<double>(outline.right_end_occluded);
  x[kFreeEnds] = outline.faces_seen == 2 && !cut ? 1 : 0;
  x[kVehicleScore] = vehicle_score;
  x[kLogAlone] = std::log(alone_m(outlines, of, kFarAway_m * scale) * metre + 0.1);
  x[kLayeredShare] = std::clamp(outline.layered_share, 0.0, 1.0);
  const double layer_depth =
      outline.layered_share > 0 ? outline.layer_depth_m * metre : kUsualLayerDepth_m;
  x[kLogLayerDepth] = log_within(layer_depth + 0.01, 0.01, 1);
  return x;
}

ShapeCues cues_of(const Outline& outline, double scale) {
  const double metre = 1 / scale;
  ShapeCues cues;
  cues.range_m = outline.box.centre_m.norm() * metre;
  cues.breadth_m = breadth_m(outline.box) * metre;
  cues.depth_m = std::sqrt(std::max(outline.var_range_m2, 0.0)) * metre;
  cues.fill = outline.points / points_expected(outline, metre);
  cues.height_m = (outline.z_high_m - outline.z_low_m) * metre;
  cues.layered_share = outline.layered_share;
  cues.layer_depth_m = outline.layer_depth_m * metre;
  return cues;
}

}  // namespace scanfuse::classify
