#include "scanfuse/calibrate/pose.hpp"

namespace scanfuse::calibrate {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

double lidar_squares(const Plane& board, const Pose3& lidar,
                     const std::vector<BeamReturn>& returns) {
  double sum = 0;
  for (const auto& r : returns) {
    const Vector3d ray = lidar.rotation * Vector3d(std::cos(r.angle_rad), std::sin(r.angle_rad), 0);
    const Vector3d point = lidar.translation_m + r.range_m * ray;
    sum += std::pow((board.normal.dot(point) - board.distance_m) / board.normal.dot(ray), 2);
  }
  return sum;
}

}  // namespace

void describe_fit(const Camera& camera, const std::array<BoardPose, 2>& boards,
                  const std::array<StripeLine, 2>& stripes, const BoardReturns& returns,
                  FixedPose& pose) {
  double stripe = 0, weight = 0, lidar = 0, count = 0;
  for (std::size_t b = 0; b < 2; ++b) {
    const Vector2d e = stripe_misfit(camera, stripes[b], pose.scan_plane, boards[b].plane());
    stripe +=
        stripes[b].scatter + stripes[b].weight * e[0] * e[0] + stripes[b].moment * e[1] * e[1];
    weight += stripes[b].count;
    lidar += lidar_squares(boards[b].plane(), pose.camera_from_lidar, returns.on_board[b]);
    count += static_cast<double>(returns.on_board[b].size());
  }
  pose.stripe_px = std::sqrt(stripe / weight);
  pose.lidar_m = std::sqrt(lidar / count);
}

Result<std::array<StripeLine, 2>> stripe_lines(const Camera& camera,
                                               const TurntablePosition& position) {
  std::array<StripeLine, 2> lines;
  for (std::size_t b = 0; b < 2; ++b) {
    auto line = fit_stripe(camera, position.stripe_px[b]);
    if (!line) {
      return fail(Error::Code::kNotFound,
                  "no stripe on board {} ({} points; 8 make a line): longer exposure, darker room, "
                  "or the board is out of the scan plane here",
                  b + 1, position.stripe_px[b].size());
    }
    lines[b] = std::move(*line);
  }
  return lines;
}

Result<std::array<BoardPose, 2>> board_poses(const TurntableFeatures& features, PoseMethod method) {
  std::array<BoardPose, 2> boards;
  for (std::size_t b = 0; b < 2; ++b) {
    const auto locate = method == PoseMethod::kLiu2023 ? board_pose_liu2023 : board_pose;
    auto pose = locate(features.camera, features.boards[b], features.corners_px[b],
                       b == 0 ? "first board" : "second board");
    if (!pose) return tl::unexpected(pose.error());
    boards[b] = *pose;
  }
  return boards;
}

Result<FixedPose> fixed_pose(const TurntableFeatures& features, std::size_t position,
                             PoseMethod method, BoardOrder first) {
  if (position >= features.positions.size()) {
    return fail(Error::Code::kOutOfRange, "position {} of {}; they are counted from 0", position,
                features.positions.size());
  }
  const TurntablePosition& at = features.positions[position];
  const auto located = board_poses(features, method);
  if (!located) return tl::unexpected(located.error());
  const std::array<BoardPose, 2>& boards = *located;
  const auto named = [&](const Error& error) -> tl::unexpected<Error> {
    return tl::unexpected(Error{error.code, fmt::format("{}: {}", at.name, error.message)});
  };
  const auto stripes = stripe_lines(features.camera, at);
  if (!stripes) return named(stripes.error());
  const auto seen = v_lines(features.camera, features.boards, boards, *stripes);
  if (!seen) return named(seen.error());
  const auto returns = find_board_returns(*seen, at.scan, first);
  if (!returns) return named(returns.error());
  const bool literal = method == PoseMethod::kLiu2023;
  auto pose = literal ? pose_liu2023(features.camera, features.boards, boards, *stripes, *returns)
                      : pose_exact(features.camera, features.boards, boards, *stripes, *returns);
  if (!pose) return named(pose.error());
  return pose;
}

}  // namespace scanfuse::calibrate
