#pragma once

#include <array>
#include <span>
#include <utility>
#include <variant>

#include "scanfuse/triangulate/line_of_sight.hpp"
#include "scanfuse/types/gaussian.hpp"

/// A moving point seen by bearings. State x, y, z, vx, vy, vz (m, m/s), world frame; what is
/// measured is the direction in each line's tangent plane (line_of_sight.hpp).
namespace scanfuse::triangulate {

/// Constant velocity with white acceleration [BarShalom2001, eq. 6.2.2-4]: velocity gains
/// `sigma_accel` m/s of standard deviation in a second, height's `sigma_accel_z`. dt_s >= 0.
[[nodiscard]] Gaussian<6> predict_point(const Gaussian<6>& point, double dt_s, double sigma_accel,
                                        double sigma_accel_z);

/// Position and its covariance alone.
[[nodiscard]] Gaussian<3> place_of(const Gaussian<6>& point);

/// All lines at once, iterated: each pass takes the slope where the last one ended, so that the
/// mean is the most likely state and the covariance that of the last slope. A line that has the
/// point behind its sensor takes no part.
struct EkfUpdate {
  [[nodiscard]] Gaussian<6> operator()(const Gaussian<6>& point,
                                       std::span<const LineOfSight> lines) const;
};

/// Third-degree cubature [Arasaratnam2009]: 12 points sqrt(6) sigmas from the mean go through the
/// measurement. Where one of them lies behind a sensor, EkfUpdate.
struct CubatureUpdate {
  [[nodiscard]] Gaussian<6> operator()(const Gaussian<6>& point,
                                       std::span<const LineOfSight> lines) const;
};

enum class PointUpdateMethod { kEkf, kCubature };

constexpr auto choices(PointUpdateMethod) {
  using enum PointUpdateMethod;
  return std::array{std::pair{"ekf", kEkf}, std::pair{"cubature", kCubature}};
}

using PointUpdate = std::variant<EkfUpdate, CubatureUpdate>;
[[nodiscard]] PointUpdate make_point_update(PointUpdateMethod method);

}  // namespace scanfuse::triangulate
