#pragma once

#include <array>

#include "scanfuse/calibrate/board_plane.hpp"
#include "scanfuse/calibrate/lines.hpp"
#include "scanfuse/core/result.hpp"

/// The two lines that the scan plane draws on the boards, as the camera sees them.
namespace scanfuse::calibrate {

struct VLines {
  Plane scan_plane;  ///< camera frame, normal along directions[0] x [1]
  Eigen::Vector3d meet_m = Eigen::Vector3d::Zero();  ///< E, where the lines meet [Liu2023, fig. 2]
  std::array<Eigen::Vector3d, 2> directions;         ///< unit, from E towards what was seen
  double angle_rad = 0;                              ///< between them
  /// Where each line enters and leaves its board's squares, metres from E.
  std::array<std::array<double, 2>, 2> reach_m{};
};

/// The point of a plane that is seen at a normalised image point.
[[nodiscard]] inline Eigen::Vector3d seen_on(const Plane& plane, const Eigen::Vector2d& at) {
  const Eigen::Vector3d ray(at.x(), at.y(), 1);
  return ray * (plane.distance_m / plane.normal.dot(ray));
}

/// Stripe offset and slope against the image of the line in which two planes meet.
[[nodiscard]] Eigen::Vector2d stripe_misfit(const Camera& camera, const StripeLine& stripe,
                                            const Plane& scan_plane, const Plane& board);

/// E, directions, angle and reach for a scan plane found by whatever method. An error where the
/// three planes do not meet in a point.
[[nodiscard]] Result<VLines> v_lines(const std::array<BoardSpec, 2>& specs,
                                     const std::array<BoardPose, 2>& boards,
                                     const std::array<StripeLine, 2>& stripes,
                                     const Plane& scan_plane);

/// The plane of total least squares through the seen points, then of least distance in pixels
/// between stripes and projected lines.
[[nodiscard]] Result<VLines> v_lines(const Camera& camera, const std::array<BoardSpec, 2>& specs,
                                     const std::array<BoardPose, 2>& boards,
                                     const std::array<StripeLine, 2>& stripes);

}  // namespace scanfuse::calibrate
