#include "scanfuse/classify/vehicle_box.hpp"

#include <algorithm>
#include <cmath>

namespace scanfuse::classify {
namespace {

/// One extent of the vehicle: what was seen of it, then what is believed of it.
struct Side {
  double seen_m = 0;
  double var_seen_m2 = 0;
  bool free_ends = false;  ///< both ends were seen
  double mean_m = 0;
  double variance_m2 = 0;
  bool seen = false;
};

/// Weighs the seen extent against the prior; what is hidden can only be longer. So can what was
/// seen at grazing incidence: beams are far apart there, and the farthest return weakest.
void weigh(Side& side, double prior_mean_m, double prior_sigma_m, double least_m,
           double most_sigma_m) {
  const double prior_variance = prior_sigma_m * prior_sigma_m;
  const bool sharp = side.var_seen_m2 <= most_sigma_m * most_sigma_m;
  side.seen = side.free_ends && sharp && side.seen_m >= least_m;
  if (!side.seen) {
    side.mean_m = std::max(prior_mean_m, side.seen_m);
    side.variance_m2 = prior_variance;
    return;
  }
  const double rounding = 0.05 * side.seen_m / 3;  // bumpers are not flat
  const double variance = side.var_seen_m2 + rounding * rounding;
  const double gain = prior_variance / (prior_variance + variance);
  side.mean_m = prior_mean_m + gain * (side.seen_m - prior_mean_m);
  side.variance_m2 = gain * variance;
}

/// The outline's box with its length along the vehicle's, and whether each extent is bounded.
struct Oriented {
  Box2 box;
  Side length, width;
  bool face_is_length = false;  ///< of a single face
};

/// A face too long for a rear is a side. A short one of which an end is hidden may be either:
/// traffic runs mostly along the sensor's x axis. A short one seen whole is a rear or front.
bool is_side(const Outline& outline, const RecognizerOptions& options) {
  if (outline.box.length_m > options.max_width_m) return true;
  const bool cut = outline.left_end_occluded || outline.right_end_occluded;
  if (outline.faces_seen == 2) return outline.box.length_m > 0.9 * options.max_width_m;
  return cut && std::abs(std::cos(outline.box.heading_rad)) > std::sqrt(0.5);
}

Oriented orient(const Outline& outline, const RecognizerOptions& options) {
  Oriented o;
  o.box = outline.box;
  o.face_is_length = is_side(outline, options);
  const bool cut = outline.left_end_occluded || outline.right_end_occluded;
  Side face{outline.box.length_m, outline.var_length_m2, !cut, 0, 0, false};
  Side depth{outline.box.width_m, outline.var_width_m2, !cut, 0, 0, false};
  if (outline.faces_seen < 2) depth = Side{};
  o.length = o.face_is_length ? face : depth;
  o.width = o.face_is_length ? depth : face;
  if (!o.face_is_length) {
    o.box.heading_rad += kPi / 2;
    std::swap(o.box.length_m, o.box.width_m);
  }
  o.box.heading_rad = wrap_half_pi(o.box.heading_rad);
  return o;
}

/// How far the middle of a single face moves along it when it grows from what was seen to `mean_m`.
Eigen::Vector2d growth_along_face(const Outline& outline, double mean_m) {
  if (outline.left_end_occluded == outline.right_end_occluded) return Eigen::Vector2d::Zero();
  const double heading = outline.box.heading_rad;
  Eigen::Vector2d to_left(std::cos(heading), std::sin(heading));
  const Eigen::Vector2d& at = outline.box.centre_m;
  if (at.x() * to_left.y() - at.y() * to_left.x() < 0) to_left = -to_left;
  const double growth = (mean_m - outline.box.length_m) / 2;
  return outline.left_end_occluded ? Eigen::Vector2d(to_left * growth)
                                   : Eigen::Vector2d(-to_left * growth);
}

/// The point that outline.covariance is about: nearest corner, or middle of the single face.
Eigen::Vector2d reference_point(const Outline& outline) {
  const Pose2 pose = outline.box.pose();
  const Eigen::Vector2d viewer = pose.inverse() * Eigen::Vector2d::Zero();
  const double y = std::copysign(outline.box.width_m / 2, viewer.y());
  if (outline.faces_seen < 2) return pose * Eigen::Vector2d(0, y);
  return pose * Eigen::Vector2d(std::copysign(outline.box.length_m / 2, viewer.x()), y);
}

/// Variance along a single face that an unseen end adds to the place of its middle.
double hidden_end_variance(const Outline& outline, double mean_m) {
  const bool left = outline.left_end_occluded, right = outline.right_end_occluded;
  if (left && right) {
    const double play = std::max(mean_m - outline.box.length_m, 0.0);
    return play * play / 12;
  }
  return left || right ? 0.75 * outline.var_length_m2 : 0;
}

/// centre = reference + arm(heading): J = [I, arm turned by 90 degrees].
Eigen::Matrix3d centre_covariance(const Outline& outline, const Eigen::Vector2d& centre,
                                  double hidden_variance) {
  const Eigen::Vector2d arm = centre - reference_point(outline);
  Eigen::Matrix3d jacobian = Eigen::Matrix3d::Identity();
  jacobian(0, 2) = -arm.y();
  jacobian(1, 2) = arm.x();
  Eigen::Matrix3d covariance = outline.covariance;
  const double heading = outline.box.heading_rad;
  const Eigen::Vector2d along(std::cos(heading), std::sin(heading));
  covariance.topLeftCorner<2, 2>() += hidden_variance * along * along.transpose();
  covariance = jacobian * covariance * jacobian.transpose();
  return (covariance + covariance.transpose()) / 2;
}

void fill_common(const Outline& outline, Detection& detection) {
  detection.z_m = (outline.z_low_m + outline.z_high_m) / 2;
  detection.faces_seen = outline.faces_seen;
  detection.left_end_occluded = outline.left_end_occluded;
  detection.right_end_occluded = outline.right_end_occluded;
  detection.points = outline.points;
  detection.time_offset_s = outline.time_offset_s;
  const LineSegment* longest = nullptr;
  for (const LineSegment& line : outline.lines) {
    if (!longest || line.length_m() > longest->length_m()) longest = &line;
  }
  detection.visible_middle_m =
      longest ? Eigen::Vector2d((longest->first_m + longest->last_m) / 2) : outline.box.centre_m;
}

}  // namespace

Detection complete_vehicle(const Outline& outline, const RecognizerOptions& options) {
  Oriented o = orient(outline, options);
  weigh(o.length, options.mean_length_m, options.sigma_length_m, options.min_length_m,
        options.max_end_sigma_m);
  weigh(o.width, options.mean_width_m, options.sigma_width_m, options.min_width_m,
        options.max_end_sigma_m);
  const Eigen::Vector2d origin = Eigen::Vector2d::Zero();
  Detection detection;
  fill_common(outline, detection);
  double hidden = 0;
  if (outline.faces_seen == 2) {
    detection.box = resize_about_seen_side(o.box, o.length.mean_m, o.width.mean_m, origin);
  } else {
    const double face = o.face_is_length ? o.length.mean_m : o.width.mean_m;
    Box2 grown = o.box;  // along the face about its middle, then away from the sensor
    grown.centre_m += growth_along_face(outline, face);
    (o.face_is_length ? grown.length_m : grown.width_m) = face;
    detection.box = resize_about_seen_side(grown, o.length.mean_m, o.width.mean_m, origin);
    hidden = hidden_end_variance(outline, face);
  }
  detection.covariance = centre_covariance(outline, detection.box.centre_m, hidden);
  detection.var_length_m2 = o.length.variance_m2;
  detection.var_width_m2 = o.width.variance_m2;
  detection.length_seen = o.length.seen;
  detection.width_seen = o.width.seen;
  return detection;
}

namespace {

/// People and bicycles are no boxes: limbs swing, beams pass between spokes, and the side that was
/// fitted is another one in the next scan. Assumed, not fitted to data: 0.1 m across the sides, and
/// a fifth of the length along them.
Eigen::Matrix2d loose_shape_covariance(const Box2& box) {
  constexpr double kSigma_m = 0.1, kShareOfLength = 0.2;
  const Eigen::Vector2d along(std::cos(box.heading_rad), std::sin(box.heading_rad));
  const double reach = kShareOfLength * box.length_m;
  return kSigma_m * kSigma_m * Eigen::Matrix2d::Identity() +
         reach * reach * along * along.transpose();
}

}  // namespace

Detection as_seen(const Outline& outline) {
  Detection detection;
  fill_common(outline, detection);
  detection.box = outline.box;
  detection.box.heading_rad = wrap_half_pi(outline.box.heading_rad);
  detection.covariance = centre_covariance(outline, outline.box.centre_m, 0);
  detection.covariance.topLeftCorner<2, 2>() += loose_shape_covariance(outline.box);
  detection.var_length_m2 = outline.var_length_m2 + 0.01;
  detection.var_width_m2 = outline.var_width_m2 + 0.25;
  return detection;
}

}  // namespace scanfuse::classify
