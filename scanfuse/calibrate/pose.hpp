#pragma once

#include <array>
#include <span>
#include <vector>

#include "scanfuse/calibrate/board_plane.hpp"
#include "scanfuse/calibrate/v_lines.hpp"
#include "scanfuse/core/result.hpp"
#include "scanfuse/types/turntable.hpp"

/// Where a 2D lidar is, from one scan of a V of two boards and one image of the stripe on it
/// [Liu2023, sec. 1]. Camera frame, metres.
namespace scanfuse::calibrate {

/// Which board the lidar meets first, as its scan angle grows. The two orders give two rigs, turned
/// into each other by half a turn about the V's bisector; one position cannot tell them apart.
enum class BoardOrder { kAscending, kDescending };

/// The returns of a scan that lie on each board, in order of angle.
struct BoardReturns {
  std::array<std::vector<BeamReturn>, 2> on_board;
};

/// The lidar's pose at one position.
struct FixedPose {
  Pose3 camera_from_lidar;
  Plane scan_plane;        ///< normal along the lidar's z
  double v_angle_rad = 0;  ///< between the two stripes, as the camera saw it
  double stripe_px = 0;    ///< rms distance of stripe points from the projected lines
  double lidar_m = 0;      ///< rms of the returns, along their rays
};

/// By the paper, literally: plane a x + b y + c z = 1 through points of both stripes (eq. 4), both
/// lines in slope form with the angle known (eqs. 7-11), directions from end points (eq. 12),
/// matrix inverse (eq. 13). The sign of the normal, which the print leaves open, is that of l1 x l2
/// in both frames. Fails where the print does: lines along the lidar's y, camera in the scan plane.
[[nodiscard]] Result<FixedPose> pose_liu2023(const Camera& camera,
                                             const std::array<BoardSpec, 2>& specs,
                                             const std::array<BoardPose, 2>& boards,
                                             const std::array<StripeLine, 2>& stripes,
                                             const BoardReturns& returns);

/// Exact: the plane of least distance in pixels between stripe points and projected lines; the two
/// lines in the scan as the smallest eigenvector of S1 + R(-a) S2 R(a), a being the known angle
/// with the sign that fits better; rotation by SVD. Has no forbidden directions.
[[nodiscard]] Result<FixedPose> pose_exact(const Camera& camera,
                                           const std::array<BoardSpec, 2>& specs,
                                           const std::array<BoardPose, 2>& boards,
                                           const std::array<StripeLine, 2>& stripes,
                                           const BoardReturns& returns);

/// Fills in how far a pose is from the stripes and returns that it should explain.
void describe_fit(const Camera& camera, const std::array<BoardPose, 2>& boards,
                  const std::array<StripeLine, 2>& stripes, const BoardReturns& returns,
                  FixedPose& pose);

/// Finds the returns of both boards in a whole scan: two straight runs that meet at the angle and
/// with the lengths that the camera saw. `first` says which board has the lower scan angles. An
/// error says why there are none, and if ranges of another unit would fit.
[[nodiscard]] Result<BoardReturns> find_board_returns(const VLines& seen,
                                                      std::span<const BeamReturn> scan,
                                                      BoardOrder first = BoardOrder::kAscending);

/// The stripes of a position as lines. An error says on which board there is none.
[[nodiscard]] Result<std::array<StripeLine, 2>> stripe_lines(const Camera& camera,
                                                             const TurntablePosition& position);

enum class PoseMethod { kLiu2023, kExact };

/// Where both boards of a session stand.
[[nodiscard]] Result<std::array<BoardPose, 2>> board_poses(const TurntableFeatures& features,
                                                           PoseMethod method);

/// All of it for one position of a session: boards, returns, pose. Errors name the position.
[[nodiscard]] Result<FixedPose> fixed_pose(const TurntableFeatures& features, std::size_t position,
                                           PoseMethod method = PoseMethod::kExact,
                                           BoardOrder first = BoardOrder::kAscending);

}  // namespace scanfuse::calibrate
