#include "scanfuse/shape/face_box.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace scanfuse::shape {
namespace {

/// Extent of points along a direction, with what the beam spacing adds at each end.
struct Stretch {
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();
  double gap_low = 0, gap_high = 0;  ///< to the next beam; 0 where cut off

  [[nodiscard]] double length() const { return high - low; }
  [[nodiscard]] double variance() const { return (gap_low * gap_low + gap_high * gap_high) / 12; }
};

/// Distance between neighbouring beams along a face at p.
double beam_gap(const Eigen::Vector2d& p, const Eigen::Vector2d& normal, const BeamSpacing& beams) {
  const double square = p.squaredNorm();
  const double slant = std::max(std::abs(normal.dot(p)), 1e-9);
  return std::min(square * beams.step_rad / slant, beams.max_gap_m);
}

/// Points on the face or near it; edge returns behind its ends do not lengthen it.
Stretch stretch_along(const Face& face, const Eigen::Vector2d& tangent, double slack_m,
                      std::span<const Eigen::Vector2d> points) {
  Stretch s;
  for (const auto& p : points) {
    if (std::abs(face.normal.dot(p) - face.offset_m) > slack_m) continue;
    const double t = tangent.dot(p);
    s.low = std::min(s.low, t);
    s.high = std::max(s.high, t);
  }
  if (s.low > s.high) s.low = s.high = tangent.dot(points.front());
  return s;
}

double depth_behind(const Face& face, std::span<const Eigen::Vector2d> points) {
  double depth = 0;
  for (const auto& p : points) depth = std::max(depth, face.offset_m - face.normal.dot(p));
  return depth;
}

/// Extents along a direction and along the one turned left of it.
struct Extent {
  double low = 0, high = 0;
  double variance = 0;

  [[nodiscard]] double length() const { return high - low; }
  [[nodiscard]] double middle() const { return (low + high) / 2; }
};

/// The box whose length lies along `axis`.
void assign_box(const Eigen::Vector2d& axis, const Extent& along, const Extent& across,
                Outline& outline) {
  const Eigen::Vector2d left(-axis.y(), axis.x());
  outline.box = {axis * along.middle() + left * across.middle(), std::atan2(axis.y(), axis.x()),
                 along.length(), across.length()};
  outline.var_length_m2 = along.variance;
  outline.var_width_m2 = across.variance;
}

/// m = pivot + n o + t s, and turning the face turns it about the pivot: dm/dh = -n s.
void set_single(const FaceFit& fit, std::span<const Eigen::Vector2d> points, const CutEnds& cut,
                const BeamSpacing& beams, Outline& outline) {
  const Face& face = fit.a;
  const Eigen::Vector2d tangent = face.tangent();  // towards smaller bearing: the normal faces us
  Stretch s = stretch_along(face, tangent, beams.slack_m, points);
  s.gap_low = cut.left ? 0 : beam_gap(points.back(), face.normal, beams);
  s.gap_high = cut.right ? 0 : beam_gap(points.front(), face.normal, beams);
  s.low -= s.gap_low / 2;
  s.high += s.gap_high / 2;
  const Extent depth{-face.offset_m, -face.offset_m + depth_behind(face, points), 0};
  assign_box(tangent, {s.low, s.high, s.variance()}, depth, outline);
  const double lever = (s.low + s.high) / 2 - tangent.dot(fit.pivot_m);
  Eigen::Matrix3d jacobian = Eigen::Matrix3d::Zero();  // by offset, place along the face, heading
  jacobian.block<2, 1>(0, 0) = face.normal;
  jacobian.block<2, 1>(0, 1) = tangent;
  jacobian.block<2, 1>(0, 2) = -face.normal * lever;
  jacobian(2, 2) = 1;
  Eigen::Matrix3d source = fit.covariance;
  source.row(1).setZero();
  source.col(1).setZero();
  source(1, 1) = s.variance() / 4;
  outline.covariance = jacobian * source * jacobian.transpose();
}

/// Length of a face from the corner to its far end, and the variance of that end.
struct Reach {
  double length_m = 0;
  double variance_m2 = 0;
};

/// `across` is the outward normal of the other face: the face runs from the corner along -across.
Reach reach_of(const Face& face, const Face& across, std::span<const Eigen::Vector2d> points,
               const CutEnds& cut, const BeamSpacing& beams) {
  const Stretch s = stretch_along(face, across.normal, beams.slack_m, points);
  const bool to_the_right = face.tangent().dot(across.normal) < 0;
  const bool is_cut = to_the_right ? cut.right : cut.left;
  const auto& end = to_the_right ? points.front() : points.back();
  const double gap = is_cut ? 0 : beam_gap(end, face.normal, beams);
  return {std::max(across.offset_m - s.low, 0.0) + gap / 2, gap * gap / 12};
}

/// corner = pivot + n_a o_a + n_b o_b, and turning moves it at right angles to its arm.
void set_corner(const FaceFit& fit, std::span<const Eigen::Vector2d> points, const CutEnds& cut,
                const BeamSpacing& beams, Outline& outline) {
  const Reach a = reach_of(fit.a, fit.b, points, cut, beams);
  const Reach b = reach_of(fit.b, fit.a, points, cut, beams);
  const Eigen::Vector2d left = fit.a.tangent();
  const bool b_left = left.dot(fit.b.normal) > 0;
  const double near_b = b_left ? fit.b.offset_m : -fit.b.offset_m;
  const double far_b = near_b + (b_left ? -a.length_m : a.length_m);
  const Extent along_a{std::min(near_b, far_b), std::max(near_b, far_b), a.variance_m2};
  const Extent along_b{fit.a.offset_m - b.length_m, fit.a.offset_m, b.variance_m2};
  if (a.length_m >= b.length_m) {  // the axis turned left of `left` is -n_a
    assign_box(left, along_a, {-along_b.high, -along_b.low, along_b.variance}, outline);
  } else {
    assign_box(fit.a.normal, along_b, along_a, outline);
  }
  const Eigen::Vector2d corner = fit.a.normal * fit.a.offset_m + fit.b.normal * fit.b.offset_m;
  const Eigen::Vector2d arm = corner - fit.pivot_m;
  Eigen::Matrix3d jacobian = Eigen::Matrix3d::Zero();
  jacobian.block<2, 1>(0, 0) = fit.a.normal;
  jacobian.block<2, 1>(0, 1) = fit.b.normal;
  jacobian.block<2, 1>(0, 2) = Eigen::Vector2d(-arm.y(), arm.x());
  jacobian(2, 2) = 1;
  outline.covariance = jacobian * fit.covariance * jacobian.transpose();
}

}  // namespace

void set_box(const FaceFit& fit, std::span<const Eigen::Vector2d> points, const CutEnds& cut,
             const BeamSpacing& beams, Outline& outline) {
  outline.faces_seen = fit.two() ? 2 : 1;
  outline.residual_m = fit.rms_m;
  outline.inlier_share = fit.inlier_share;
  outline.left_end_occluded = cut.left;
  outline.right_end_occluded = cut.right;
  if (fit.two()) {
    set_corner(fit, points, cut, beams, outline);
  } else {
    set_single(fit, points, cut, beams, outline);
  }
}

}  // namespace scanfuse::shape
