#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "scanfuse/core/random.hpp"
#include "scanfuse/geometry/pose.hpp"

namespace scanfuse::simulate {

/// A natural cubic spline through (time, value): twice continuously differentiable, so that
/// accelerations have no steps. Straight beyond its ends.
class Spline {
 public:
  Spline() = default;
  /// At least two knots, times increasing.
  Spline(std::vector<double> times_s, std::vector<double> values);
  [[nodiscard]] double operator()(double t_s) const;
  [[nodiscard]] double rate(double t_s) const;

 private:
  [[nodiscard]] std::size_t interval(double t_s) const;
  std::vector<double> times_, values_, curvature_;
};

/// A path in the plane over time. The heading is that of the motion unless it is given (things that
/// stand).
struct PlanarMotion {
  Spline x;
  Spline y;
  std::optional<double> fixed_heading_rad;

  [[nodiscard]] Pose2 pose(double t_s) const;
  [[nodiscard]] Eigen::Vector2d velocity(double t_s) const { return {x.rate(t_s), y.rate(t_s)}; }
  [[nodiscard]] double yaw_rate(double t_s) const;
};

/// Stands at `pose` forever.
[[nodiscard]] PlanarMotion standing(const Pose2& pose);
/// Runs straight from `start` with constant speed.
[[nodiscard]] PlanarMotion straight(const Pose2& start, double speed_m_per_s);

/// What a car body does on its springs: a few incommensurate sines in pitch, roll and heave.
class Vibration {
 public:
  Vibration(double scale, RandomStream random);
  /// To be applied after the planar pose.
  [[nodiscard]] Pose3 at(double t_s) const;

 private:
  struct Wave {
    double amplitude, rate_rad_per_s, phase_rad;
  };
  [[nodiscard]] static double sum(const std::vector<Wave>& waves, double t_s);
  std::vector<Wave> pitch_, roll_, heave_;
};

}  // namespace scanfuse::simulate
