#pragma once

#include <array>
#include <vector>

#include "scanfuse/calibrate/pose.hpp"
#include "scanfuse/types/turntable.hpp"

/// What the joint refinement works on and what it moves.
namespace scanfuse::calibrate {

/// One position that has both stripes and returns on both boards.
struct Sample {
  std::size_t index = 0;  ///< in the features' positions
  double turntable_rad = 0;
  std::array<StripeLine, 2> stripes;
  BoardReturns returns;
  std::array<LidarLine, 2> lines;
  FixedPose pose;
};

/// Every unknown. Changes are written as 12 numbers of the rig (its covariance's order), 6 of each
/// board (rotation, camera frame, left; translation), the square bias; and one angle a sample.
struct JointState {
  Rig rig;
  std::array<Pose3, 2> camera_from_board;
  double square_bias_m = 0;
  std::vector<double> correction_rad;  ///< of each sample's angle
};
inline constexpr int kBoardAt = Rig::kParameters;
inline constexpr int kSquareAt = kBoardAt + 12;
inline constexpr int kGlobal = kSquareAt + 1;
using GlobalVector = Eigen::Matrix<double, kGlobal, 1>;
using GlobalMatrix = Eigen::Matrix<double, kGlobal, kGlobal>;

/// Which systematic errors are unknowns.
struct JointUnknowns {
  bool range_bias = false;
  bool square_bias = false;
  bool angle_scale = false;
  [[nodiscard]] bool active(int parameter) const {
    if (parameter == 10) return range_bias;
    if (parameter == 11) return angle_scale;
    return parameter != kSquareAt || square_bias;
  }
};

/// Corners that are taken for good, of each board: index and place.
struct KeptCorner {
  Eigen::Vector3d board_m;
  Eigen::Vector2d seen_px;
};
using KeptCorners = std::array<std::vector<KeptCorner>, 2>;

/// Errors that all points of a line share, as they enter a row of its sample.
enum class LineEffect {
  kStripeOffset,
  kStripeTilt,
  kLidarOffset,
  kLidarTilt,
  kLidarBow,
  kTurntable,
  kNone
};
inline constexpr int kEffects = 6;

/// Variances of everything.
struct JointNoise {
  double corner_px2 = 0;
  double stripe_px2 = 0;
  double range_m2 = 0;
  double turntable_rad2 = 0;
  std::array<double, kEffects> effect{};  ///< in the order of LineEffect
};

}  // namespace scanfuse::calibrate
