#pragma once

#include <optional>
#include <span>
#include <vector>

#include "scanfuse/calibrate/cloud/plane_fit.hpp"
#include "scanfuse/types/cloud.hpp"

namespace scanfuse::calibrate {

/// A cloud's points by profile and beam, and the ray of every beam, whether it came back or not.
class BeamGrid {
 public:
  /// Needs a cloud with profiles, which must outlive the grid.
  explicit BeamGrid(const Cloud& cloud);

  [[nodiscard]] int profiles() const { return static_cast<int>(cloud_->profiles.size()); }
  [[nodiscard]] double step_rad() const { return step_rad_; }
  /// The point of a beam; nullptr where nothing came back or it was removed.
  [[nodiscard]] const CloudPoint* point(int profile, int beam) const;
  [[nodiscard]] std::optional<std::size_t> index(int profile, int beam) const;
  /// Unit vector of a beam in the cloud's frame, exact where it came back.
  [[nodiscard]] Eigen::Vector3d ray(int profile, int beam) const;
  [[nodiscard]] const Eigen::Vector3d& origin(int profile) const {
    return cloud_->profiles[static_cast<std::size_t>(profile)].cloud_from_lidar.translation_m;
  }
  /// Beams whose angle lies within `half_width_rad` of the direction of `p`, as [first, last].
  [[nodiscard]] std::pair<int, int> beams_around(int profile, const Eigen::Vector3d& p,
                                                 double half_width_rad) const;

  /// Where a beam meets a plane; nothing where it points away or runs along it.
  [[nodiscard]] std::optional<Eigen::Vector3d> meets(const PlaneFit& plane, int profile,
                                                     int beam) const;

 private:
  const Cloud* cloud_;
  std::vector<std::vector<std::pair<int, std::size_t>>> rows_;  ///< (beam, point), ascending
  double first_rad_ = 0;
  double step_rad_ = 0;
  int last_beam_ = 0;
};

/// Unit vectors from the lidar to each of the points; empty where the cloud has no profiles.
[[nodiscard]] std::vector<Eigen::Vector3d> rays_of(const Cloud& cloud,
                                                   std::span<const std::size_t> points);

}  // namespace scanfuse::calibrate
