#pragma once

#include <Eigen/Core>
#include <span>
#include <string_view>

#include "scanfuse/core/result.hpp"
#include "scanfuse/types/turntable.hpp"

namespace scanfuse::calibrate {

/// The plane normal . X = distance_m of a unit normal.
struct Plane {
  Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();
  double distance_m = 0;
};

/// Where a chessboard stands before the camera.
struct BoardPose {
  Pose3 camera_from_board;
  double rms_px = 0;  ///< of one coordinate of the corners, raw pixels

  /// The board's plane in the camera frame, its normal facing the camera [Liu2023, eq. 3].
  [[nodiscard]] Plane plane() const;
};

/// From corners in row-major order (raw pixels) by the paper: homography, rotation by SVD,
/// translation by least squares [Liu2023, eqs. 1-3]. An error names what is wrong with the corners
/// of `name`: their number, points that are no numbers, rows and columns swapped.
[[nodiscard]] Result<BoardPose> board_pose_liu2023(const Camera& camera, const BoardSpec& board,
                                                   std::span<const Eigen::Vector2d> corners_px,
                                                   std::string_view name = "board");

/// The same, then refined to the least sum of squared distances in the raw image.
[[nodiscard]] Result<BoardPose> board_pose(const Camera& camera, const BoardSpec& board,
                                           std::span<const Eigen::Vector2d> corners_px,
                                           std::string_view name = "board");

}  // namespace scanfuse::calibrate
