#include "scanfuse/track/heading.hpp"

#include <algorithm>
#include <cmath>

#include "scanfuse/estimate/kalman.hpp"

namespace scanfuse::track {
namespace {

constexpr double kSlowest_m_per_s = 0.5;   ///< below, noise and motion look alike
constexpr double kFast_m_per_s = 2;        ///< no vehicle slides sideways like this
constexpr double kSureRatio = 4.0;         ///< speed over its deviation
constexpr double kCourseSigma_rad = 0.05;  ///< side slip, and a box that is not quite straight
constexpr double kYawAccel = 0.4;          ///< rad/s gained in one second when moving
constexpr double kYawAccelAtRest = 0.02;
constexpr double kYawRateDecay_s = 1.0;
constexpr double kBackwards_m = 0.5;  ///< way gone against the heading that turns it round
constexpr double kForwardMemory_m = 3.0;

using HeadingRow = Eigen::Matrix<double, 1, 2>;

void fold(Gaussian<2>& heading, double measured_rad, double variance) {
  Gaussian<1> z;
  z.mean(0) = heading.mean(0) + wrap_pi(measured_rad - heading.mean(0));
  z.covariance(0) = variance;
  heading = estimate::update(heading, z, HeadingRow(1, 0));
  heading.mean(0) = wrap_pi(heading.mean(0));
}

/// Fast and straight enough to overrule a box: a quarter turn must not follow from noise.
bool surely_across(const Course& course) {
  return course.speed_m_per_s > kFast_m_per_s && course.variance_rad2 < radians(10) * radians(10);
}

void turn_to(Target& target, const Course& course) {
  target.heading.mean << course.direction_rad, 0;
  target.heading.covariance = Eigen::Vector2d(course.variance_rad2 + 0.1, 0.25).asDiagonal();
  target.forward_m = 0;
}

}  // namespace

Course course_of(const Gaussian<kStates>& state) {
  const Eigen::Vector2d v(state.mean(kVx), state.mean(kVy));
  const double variance = 0.5 * (state.covariance(kVx, kVx) + state.covariance(kVy, kVy));
  Course course;
  course.speed_m_per_s = v.norm();
  course.direction_rad = std::atan2(v.y(), v.x());
  course.variance_rad2 = variance / std::max(v.squaredNorm(), 1e-6);
  course.reliable = course.speed_m_per_s > kSlowest_m_per_s &&
                    course.speed_m_per_s > kSureRatio * std::sqrt(variance);
  return course;
}

bool follows_its_course(const Target& target) {
  const ObjectClass kind = class_of(target);
  return kind == ObjectClass::kPedestrian || kind == ObjectClass::kUnknown;
}

void predict_heading(Target& target, double dt_s) {
  const double sigma = course_of(target.state).reliable ? kYawAccel : kYawAccelAtRest;
  const double q = sigma * sigma, keep = std::exp(-dt_s / kYawRateDecay_s);
  Eigen::Matrix2d F, Q;
  F << 1, dt_s, 0, keep;
  Q << q * dt_s * dt_s * dt_s / 3, q * dt_s * dt_s / 2, q * dt_s * dt_s / 2, q * dt_s;
  target.heading = estimate::predict(target.heading, F, Q);
  target.heading.mean(0) = wrap_pi(target.heading.mean(0));
}

void update_heading(Target& target, const Measurement& measurement) {
  if (follows_its_course(target)) return;
  const double sigma_floor = radians(2);
  fold(target.heading, measurement.heading_rad,
       measurement.var_heading_rad2 + sigma_floor * sigma_floor);
}

bool align_heading_with_course(Target& target, double dt_s) {
  const Course course = course_of(target.state);
  if (!course.reliable) return false;
  const double along = std::cos(course.direction_rad - target.heading_rad());
  target.forward_m =
      std::min(target.forward_m + along * course.speed_m_per_s * dt_s, kForwardMemory_m);
  if (target.forward_m < -kBackwards_m) {
    target.heading.mean(0) = wrap_pi(target.heading_rad() + kPi);
    target.forward_m = -target.forward_m;
  }
  const double off = std::abs(wrap_pi(course.direction_rad - target.heading_rad()));
  if (off < radians(45)) {
    // The course is itself filtered, so its error lasts: counted at a quarter of its weight.
    fold(target.heading, course.direction_rad,
         4 * course.variance_rad2 + kCourseSigma_rad * kCourseSigma_rad);
  } else if (follows_its_course(target)) {
    turn_to(target, course);
  } else if (off < radians(135) && surely_across(course)) {
    turn_to(target, course);
    return true;
  }
  return false;
}

}  // namespace scanfuse::track
