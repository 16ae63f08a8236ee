#include "scanfuse/simulate/motion.hpp"

#include <algorithm>
#include <cmath>

#include "scanfuse/core/assert.hpp"

namespace scanfuse::simulate {

// Second derivatives of the natural spline: a tridiagonal system, solved by elimination.
Spline::Spline(std::vector<double> times_s, std::vector<double> values)
    : times_(std::move(times_s)), values_(std::move(values)), curvature_(times_.size(), 0.0) {
  SCANFUSE_ASSERT(times_.size() >= 2 && times_.size() == values_.size());
  const std::size_t n = times_.size();
  std::vector<double> upper(n, 0.0);
  for (std::size_t i = 1; i + 1 < n; ++i) {
    const double before = times_[i] - times_[i - 1], after = times_[i + 1] - times_[i];
    const double slopes =
        6 * ((values_[i + 1] - values_[i]) / after - (values_[i] - values_[i - 1]) / before);
    const double pivot = 2 * (before + after) - before * upper[i - 1];
    upper[i] = after / pivot;
    curvature_[i] = (slopes - before * curvature_[i - 1]) / pivot;
  }
  for (std::size_t i = n - 1; i-- > 1;) curvature_[i] -= upper[i] * curvature_[i + 1];
}

std::size_t Spline::interval(double t_s) const {
  const auto after = std::upper_bound(times_.begin() + 1, times_.end() - 1, t_s);
  return static_cast<std::size_t>(after - times_.begin()) - 1;
}

double Spline::operator()(double t_s) const {
  if (t_s <= times_.front()) return values_.front() + (t_s - times_.front()) * rate(t_s);
  if (t_s >= times_.back()) return values_.back() + (t_s - times_.back()) * rate(t_s);
  const std::size_t i = interval(t_s);
  const double h = times_[i + 1] - times_[i];
  const double b = (t_s - times_[i]) / h, a = 1 - b;
  return a * values_[i] + b * values_[i + 1] +
         ((a * a * a - a) * curvature_[i] + (b * b * b - b) * curvature_[i + 1]) * h * h / 6;
}

double Spline::rate(double t_s) const {
  const double t = std::clamp(t_s, times_.front(), times_.back());
  const std::size_t i = interval(t);
  const double h = times_[i + 1] - times_[i];
  const double b = (t - times_[i]) / h, a = 1 - b;
  return (values_[i + 1] - values_[i]) / h +
         ((3 * b * b - 1) * curvature_[i + 1] - (3 * a * a - 1) * curvature_[i]) * h / 6;
}

Pose2 PlanarMotion::pose(double t_s) const {
  const double heading =
      fixed_heading_rad ? *fixed_heading_rad : std::atan2(y.rate(t_s), x.rate(t_s));
  return {x(t_s), y(t_s), heading};
}

double PlanarMotion::yaw_rate(double t_s) const {
  constexpr double kHalfStep = 1e-3;
  const double turn =
      wrap_pi(pose(t_s + kHalfStep).heading_rad - pose(t_s - kHalfStep).heading_rad);
  return turn / (2 * kHalfStep);
}

PlanarMotion standing(const Pose2& pose) {
  return {Spline({0, 1}, {pose.x_m, pose.x_m}), Spline({0, 1}, {pose.y_m, pose.y_m}),
          pose.heading_rad};
}

PlanarMotion straight(const Pose2& start, double speed_m_per_s) {
  const Eigen::Vector2d end = start * Eigen::Vector2d(speed_m_per_s, 0);
  return {Spline({0, 1}, {start.x_m, end.x()}), Spline({0, 1}, {start.y_m, end.y()}),
          start.heading_rad};
}

Vibration::Vibration(double scale, RandomStream random) {
  const auto wave = [&](double amplitude, double hertz) {
    return Wave{scale * amplitude * random.uniform(0.7, 1.3),
                2 * kPi * hertz * random.uniform(0.85, 1.15), random.uniform(0, 2 * kPi)};
  };
  pitch_ = {wave(radians(0.25), 0.35), wave(radians(0.2), 1.4), wave(radians(0.08), 3.1)};
  roll_ = {wave(radians(0.2), 0.5), wave(radians(0.15), 1.7)};
  heave_ = {wave(0.01, 1.3), wave(0.004, 4.0)};
}

double Vibration::sum(const std::vector<Wave>& waves, double t_s) {
  double total = 0;
  for (const auto& w : waves) total += w.amplitude * std::sin(w.rate_rad_per_s * t_s + w.phase_rad);
  return total;
}

Pose3 Vibration::at(double t_s) const {
  const Eigen::AngleAxisd pitch(sum(pitch_, t_s), Eigen::Vector3d::UnitY());
  const Eigen::AngleAxisd roll(sum(roll_, t_s), Eigen::Vector3d::UnitX());
  return {Eigen::Quaterniond(pitch * roll), {0, 0, sum(heave_, t_s)}};
}

}  // namespace scanfuse::simulate
