#include "scanfuse/track/measure.hpp"

#include <cmath>

#include "scanfuse/estimate/constant_velocity.hpp"

namespace scanfuse::track {
namespace {

constexpr double kFarthest_m = 1e7;
constexpr double kLargest_m = 1e3;

/// The detection's covariance where it is one, else one metre and half a radian.
Eigen::Matrix3d sound_covariance(const Eigen::Matrix3d& given) {
  Eigen::Matrix3d symmetric = 0.5 * (given + given.transpose());
  const bool positive = given.allFinite() && symmetric(0, 0) > 0 && symmetric(2, 2) > 0 &&
                        symmetric.topLeftCorner<2, 2>().determinant() > 0;
  if (positive) return symmetric;
  return Eigen::Vector3d(1, 1, 0.25).asDiagonal();
}

double sound_variance(double given) { return std::isfinite(given) && given > 0 ? given : 1.0; }

/// How many of the quarter turns the box allows bring its heading nearest to `reference_rad`. Which
/// of two faces is the longer one cannot be told when only a part of the side is in view.
int nearest_quarter(const Detection& detection, double reference_rad) {
  const double turn = wrap_pi(reference_rad - detection.box.heading_rad);
  const bool axes_known = detection.faces_seen == 0;
  if (axes_known) return 2 * static_cast<int>(std::lround(turn / kPi));
  return static_cast<int>(std::lround(turn / (kPi / 2)));
}

/// The end of a side that stood free: +1 or -1 along the axis, 0 for both or neither.
double free_end(const Detection& detection, const Eigen::Vector2d& axis) {
  if (detection.left_end_occluded == detection.right_end_occluded) return 0;
  const Eigen::Vector2d sight = detection.box.centre_m - detection.seen_from_m;
  const bool axis_points_left = sight.x() * axis.y() - sight.y() * axis.x() > 0;
  return axis_points_left == detection.right_end_occluded ? 1 : -1;
}

/// Where the placed point of the box lies: its corner for two faces, the middle or the free end of
/// a single one, never the end that was only believed.
Eigen::Vector2d seen_ends(const Detection& detection, const Box2& box, const Measurement& m) {
  const Eigen::Vector2d viewer = box.pose().inverse() * detection.seen_from_m;
  Eigen::Vector2d to_viewer(std::copysign(1.0, viewer.x()), std::copysign(1.0, viewer.y()));
  if (detection.faces_seen == 2) return to_viewer;
  if (detection.faces_seen == 0) {
    return {m.length.seen ? 0 : to_viewer.x(), m.width.seen ? 0 : to_viewer.y()};
  }
  const bool looks_along_length =
      std::abs(viewer.x()) - box.length_m / 2 > std::abs(viewer.y()) - box.width_m / 2;
  const Eigen::Vector2d axis(std::cos(box.heading_rad), std::sin(box.heading_rad));
  if (looks_along_length) {
    return {to_viewer.x(),
            m.width.seen ? 0 : free_end(detection, Eigen::Vector2d(-axis.y(), axis.x()))};
  }
  return {m.length.seen ? 0 : free_end(detection, axis), to_viewer.y()};
}

void measure_box(const Detection& detection, double sigma_position_m, Measurement& m) {
  const Box2 box{detection.box.centre_m, m.heading_rad, m.length.size_m, m.width.size_m};
  const Eigen::Vector2d ends = seen_ends(detection, box, m);
  const double c = std::cos(m.heading_rad), s = std::sin(m.heading_rad);
  Eigen::Matrix2d half_sides;
  half_sides << c * ends.x() / 2, -s * ends.y() / 2, s * ends.x() / 2, c * ends.y() / 2;
  m.H.rightCols<2>() = half_sides;
  m.position.mean = box.centre_m + half_sides * Eigen::Vector2d(box.length_m, box.width_m);
  m.position.covariance = sound_covariance(detection.covariance).topLeftCorner<2, 2>();
  m.position.covariance.diagonal().array() += sigma_position_m * sigma_position_m;
}

/// A side far shorter than believed is a part of it, whatever its ends looked like.
bool demote_part(MeasuredSide& side, const Gaussian<kStates>& state, int place) {
  const double missing = state.mean(place) - side.size_m;
  const double variance = state.covariance(place, place) + side.variance_m2 + 0.01;
  if (!side.seen || missing <= 0 || missing * missing < 9 * variance) return false;
  side.seen = false;
  return true;
}

/// Where a part lies along its side is not known when neither end is: uniform over what is left.
void add_play(Measurement& m, double length_play_m, double width_play_m) {
  const Eigen::Vector2d along(std::cos(m.heading_rad), std::sin(m.heading_rad));
  const Eigen::Vector2d across(-along.y(), along.x());
  const auto add = [&](const Eigen::Vector2d& axis, int place, double play_m) {
    if (!m.H.col(place).isZero()) return;
    m.position.covariance += play_m * play_m / 12 * axis * axis.transpose();
  };
  add(along, kLength, length_play_m);
  add(across, kWidth, width_play_m);
}

}  // namespace

bool is_usable(const Detection& detection) {
  const auto near = [](const Eigen::Vector2d& p) {
    return p.allFinite() && p.cwiseAbs().maxCoeff() < kFarthest_m;
  };
  const auto size = [](double value) { return value >= 0 && value < kLargest_m; };
  return near(detection.box.centre_m) && near(detection.seen_from_m) &&
         near(detection.visible_middle_m) && std::isfinite(detection.box.heading_rad) &&
         size(detection.box.length_m) && size(detection.box.width_m) &&
         std::isfinite(detection.z_m) && std::isfinite(detection.height_m) &&
         std::isfinite(detection.score);
}

Measurement measure(const Detection& detection, double heading_rad, const TrackerOptions& options) {
  Measurement m;
  m.H.setZero();
  m.H.leftCols<4>() = estimate::position_of_constant_velocity();
  m.H(0, kVx) = m.H(1, kVy) = detection.time_offset_s;
  const int quarters = nearest_quarter(detection, heading_rad);
  m.heading_rad = wrap_pi(detection.box.heading_rad + quarters * kPi / 2);
  m.var_heading_rad2 = sound_covariance(detection.covariance)(2, 2);
  m.length = {detection.box.length_m, sound_variance(detection.var_length_m2),
              detection.length_seen};
  m.width = {detection.box.width_m, sound_variance(detection.var_width_m2), detection.width_seen};
  if (quarters % 2 != 0) {
    std::swap(m.length, m.width);
    m.length.bounded = m.length.seen;
    m.width.bounded = m.width.seen;
  }

  switch (options.measurement) {
    case MeasuredAs::kBox:
      measure_box(detection, options.sigma_position_m, m);
      break;
    case MeasuredAs::kCentre:
      m.position.mean = detection.box.centre_m;
      m.position.covariance = sound_covariance(detection.covariance).topLeftCorner<2, 2>();
      m.position.covariance.diagonal().array() +=
          options.sigma_position_m * options.sigma_position_m;
      break;
    case MeasuredAs::kVisibleMiddle:
      m.position.mean = detection.visible_middle_m;
      m.position.covariance = Eigen::Matrix2d::Identity() * options.sigma_m_m * options.sigma_m_m;
      break;
  }
  return m;
}

Measurement measure(const Detection& detection, const Target& target,
                    const TrackerOptions& options) {
  Measurement m = measure(detection, target.heading_rad(), options);
  if (options.measurement != MeasuredAs::kBox) return m;
  const bool length_in_part = demote_part(m.length, target.state, kLength);
  const bool width_in_part = demote_part(m.width, target.state, kWidth);
  if (length_in_part || width_in_part) measure_box(detection, options.sigma_position_m, m);
  const Eigen::Vector2d grown =
      target.state.mean.tail<2>() - Eigen::Vector2d(m.length.size_m, m.width.size_m);
  add_play(m, length_in_part ? grown.x() : 0, width_in_part ? grown.y() : 0);
  const Eigen::Vector2d reach = m.H.rightCols<2>() * grown;
  const Eigen::Vector2d sideways(-reach.y(), reach.x());
  const double variance = std::min(m.var_heading_rad2, 0.25);
  m.position.covariance += variance * sideways * sideways.transpose();
  return m;
}

}  // namespace scanfuse::track
