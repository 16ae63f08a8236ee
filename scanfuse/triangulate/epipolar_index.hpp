#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "scanfuse/triangulate/line_of_sight.hpp"

namespace scanfuse::triangulate {

/// The lines of one sensor sorted by the half plane through the baseline to another sensor: two
/// lines of the two sensors can only meet where these planes agree. Finds partners without looking
/// at all pairs: for n lines each, the work grows with n log n and what is found.
///
/// Lines without elevation, near the baseline's own direction, or of sensors at one place (closer
/// than a millimetre) have no such plane; they are partners of all.
class EpipolarIndex {
 public:
  /// Partners among `lines` (of one sensor) for lines of a sensor at `other_origin_m`.
  EpipolarIndex(const Eigen::Vector3d& other_origin_m, std::span<const LineOfSight> lines);

  /// Calls visit(place in `lines`) for every line whose plane is within `sigmas` of that of `line`;
  /// in an order that depends on nothing but the input.
  template <class Visit>
  void for_partners(const LineOfSight& line, double sigmas, Visit&& visit) const {
    const Plane mine = plane_of(line);
    for (const std::int32_t i : everywhere_) visit(i);
    if (mine.sigma_rad > kWide) {
      for (const Plane& plane : sorted_) visit(plane.line);
      return;
    }
    const double reach = sigmas * (mine.sigma_rad + widest_rad_);
    const auto take = [&](double low, double high) {
      for (std::size_t k = first_at(low); k < sorted_.size() && sorted_[k].angle_rad <= high; ++k) {
        visit(sorted_[k].line);
      }
    };
    if (reach >= kPi) {
      take(-kPi, kPi);
      return;
    }
    take(mine.angle_rad - reach, mine.angle_rad + reach);
    if (mine.angle_rad - reach < -kPi) take(mine.angle_rad - reach + 2 * kPi, kPi);
    if (mine.angle_rad + reach > kPi) take(-kPi, mine.angle_rad + reach - 2 * kPi);
  }

 private:
  static constexpr double kWide = 0.3;  ///< rad: a plane this unsure is no plane
  struct Plane {
    double angle_rad = 0;
    double sigma_rad = 0;
    std::int32_t line = 0;
  };
  [[nodiscard]] Plane plane_of(const LineOfSight& line) const;
  [[nodiscard]] std::size_t first_at(double angle_rad) const;

  Eigen::Vector3d along_ = Eigen::Vector3d::Zero();  ///< zero for sensors at one place
  Eigen::Vector3d across_ = Eigen::Vector3d::UnitX();
  Eigen::Vector3d up_ = Eigen::Vector3d::UnitY();
  double widest_rad_ = 0;
  std::vector<Plane> sorted_;
  std::vector<std::int32_t> everywhere_;
};

/// The lines of one sensor sorted by azimuth, to find those near a predicted direction.
class AzimuthIndex {
 public:
  AzimuthIndex() = default;
  AzimuthIndex(const PassiveSensor& sensor, std::span<const LineOfSight> lines);

  /// Calls visit(place in `lines`) for the lines within `reach_rad` of the azimuth under which the
  /// sensor sees `point_m`; all of them for a point within `reach_rad` of the zenith.
  template <class Visit>
  void for_near(const Eigen::Vector3d& point_m, double reach_rad, Visit&& visit) const {
    const Eigen::Vector3d p = sensor_from_world_ * point_m;
    const double flat = std::hypot(p.x(), p.y());
    const double reach = reach_rad * p.norm() / std::max(flat, 1e-9);
    const double azimuth = std::atan2(p.y(), p.x());
    const auto take = [&](double low, double high) {
      for (std::size_t k = first_at(low); k < sorted_.size() && sorted_[k].first <= high; ++k) {
        visit(sorted_[k].second);
      }
    };
    if (!(reach < kPi)) {
      take(-kPi, kPi);
      return;
    }
    take(azimuth - reach, azimuth + reach);
    if (azimuth - reach < -kPi) take(azimuth - reach + 2 * kPi, kPi);
    if (azimuth + reach > kPi) take(-kPi, azimuth + reach - 2 * kPi);
  }

 private:
  [[nodiscard]] std::size_t first_at(double azimuth_rad) const;

  Pose3 sensor_from_world_;
  std::vector<std::pair<double, std::int32_t>> sorted_;
};

}  // namespace scanfuse::triangulate
