#include "scanfuse/classify/vehicle_rules.hpp"

#include <algorithm>
#include <cmath>

namespace scanfuse::classify {
namespace {

/// Of a single face. A cut one may be any part of a vehicle that is not too small to tell; many
/// points in a line tell sooner.
double score_of_single(const Outline& outline, const RecognizerOptions& o) {
  const double face = outline.box.length_m;
  const bool left = outline.left_end_occluded, right = outline.right_end_occluded;
  const double slack = o.size_slack_m;
  constexpr int kManyPoints = 20;
  constexpr double kVeryStraight = 0.97;
  const bool sure = outline.points >= kManyPoints && outline.inlier_share >= kVeryStraight;
  const double shortest = sure ? 0.7 * o.min_cut_m : o.min_cut_m;
  if (left && right) return o.both_cut_score * membership(face, shortest, o.max_length_m, slack);
  if (left || right) return membership(face, shortest, o.max_length_m, slack);
  return std::max(membership(face, o.min_width_m, o.max_width_m, slack),
                  membership(face, o.min_length_m, o.max_length_m, slack));
}

double score_of_corner(const Outline& outline, const RecognizerOptions& o) {
  const double slack = o.size_slack_m;
  const double longer = outline.box.length_m, shorter = outline.box.width_m;
  return std::min(membership(longer, o.min_width_m, o.max_length_m, slack),
                  membership(shorter, 0, o.max_width_m, slack));
}

/// One stray point is forgiven: of five points it is already a fifth.
double straightness(const Outline& outline, const RecognizerOptions& o) {
  const double share =
      (outline.inlier_share * outline.points + 1) / (static_cast<double>(outline.points) + 1);
  return membership(std::min(share, 1.0), o.min_inlier_share, 1, 0.15);
}

double score_of_lines(std::size_t lines) {
  if (lines <= 2) return 1;
  return lines == 3 ? 0.6 : 0;
}

}  // namespace

double membership(double x, double low, double high, double slack) {
  if (x < low) return std::max(0.0, 1 - (low - x) / slack);
  if (x > high) return std::max(0.0, 1 - (x - high) / slack);
  return 1;
}

double vehicle_score(const Outline& outline, const RecognizerOptions& options) {
  if (outline.points < options.min_points) return 0;
  const double size = outline.faces_seen == 2 ? score_of_corner(outline, options)
                                              : score_of_single(outline, options);
  const double straight = straightness(outline, options);
  const double covered = membership(outline.coverage, options.min_coverage, 1, 0.2);
  const double enough = std::min(1.0, 0.5 + 0.1 * outline.points);
  return size * straight * covered * enough * score_of_lines(outline.lines.size());
}

bool is_vehicle_lu2018(const Outline& outline, const RecognizerOptions& o) {
  if (outline.points < o.min_points || outline.lines.empty() || outline.lines.size() > 2) {
    return false;
  }
  const auto within = [](double x, double low, double high) { return x >= low && x <= high; };
  const double first = outline.lines[0].length_m();
  if (outline.lines.size() == 1) {
    return within(first, o.min_width_m, o.max_width_m) ||
           within(first, o.min_length_m, o.max_length_m);
  }
  const double second = outline.lines[1].length_m();
  const double angle =
      wrap_half_pi(outline.lines[0].direction_rad() - outline.lines[1].direction_rad());
  return std::abs(std::abs(angle) - kPi / 2) <= o.right_angle_tolerance_rad &&
         std::min(first, second) <= o.max_width_m &&
         within(std::max(first, second), o.min_width_m, o.max_length_m);
}

}  // namespace scanfuse::classify
