#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <Eigen/SVD>

#include "scanfuse/calibrate/pose.hpp"
#include "scanfuse/calibrate/v_lines.hpp"

namespace scanfuse::calibrate {
namespace {

using Eigen::Matrix2d;
using Eigen::Matrix3d;
using Eigen::Rotation2Dd;
using Eigen::Vector2d;
using Eigen::Vector3d;

struct Cloud {
  Vector2d centre = Vector2d::Zero();
  Matrix2d scatter = Matrix2d::Zero();
};

Cloud cloud_of(const std::vector<BeamReturn>& returns) {
  Cloud cloud;
  std::vector<Vector2d> points;
  for (const auto& r : returns) {
    points.push_back(r.range_m * Vector2d(std::cos(r.angle_rad), std::sin(r.angle_rad)));
    cloud.centre += points.back() / static_cast<double>(returns.size());
  }
  for (const auto& p : points) {
    cloud.scatter += (p - cloud.centre) * (p - cloud.centre).transpose();
  }
  return cloud;
}

struct LidarV {
  Vector2d meet = Vector2d::Zero();
  std::array<Vector2d, 2> directions;
  double misfit = std::numeric_limits<double>::infinity();
};

/// Two lines whose normals are u and R(turn) u: u is the least eigenvector of S1 + R(-turn) S2
/// R(turn), which is the exact least-squares answer where eqs. 7-11 of the paper linearise.
LidarV lines_with_turn(const std::array<Cloud, 2>& clouds, double turn) {
  const Matrix2d R = Rotation2Dd(turn).toRotationMatrix();
  const Matrix2d S = clouds[0].scatter + R.transpose() * clouds[1].scatter * R;
  const Eigen::SelfAdjointEigenSolver<Matrix2d> solver(S);
  const Vector2d u = solver.eigenvectors().col(0), w = R * u;
  Matrix2d normals;
  normals << u.transpose(), w.transpose();
  LidarV v;
  v.misfit = solver.eigenvalues()[0];
  v.meet = normals.inverse() * Vector2d(u.dot(clouds[0].centre), w.dot(clouds[1].centre));
  const Vector2d lines[] = {{-u.y(), u.x()}, {-w.y(), w.x()}};
  for (std::size_t b = 0; b < 2; ++b) {
    // Only the sign is taken from the returns; the paper's end points (eq. 12) may lie on edges.
    const bool back = lines[b].dot(clouds[b].centre - v.meet) < 0;
    v.directions[b] = back ? Vector2d(-lines[b]) : lines[b];
  }
  return v;
}

}  // namespace

Result<FixedPose> pose_exact(const Camera& camera, const std::array<BoardSpec, 2>& specs,
                             const std::array<BoardPose, 2>& boards,
                             const std::array<StripeLine, 2>& stripes,
                             const BoardReturns& returns) {
  const auto seen = v_lines(camera, specs, boards, stripes);
  if (!seen) return tl::unexpected(seen.error());
  const std::array clouds{cloud_of(returns.on_board[0]), cloud_of(returns.on_board[1])};
  const LidarV one = lines_with_turn(clouds, seen->angle_rad);
  const LidarV other = lines_with_turn(clouds, -seen->angle_rad);
  const LidarV& best = one.misfit <= other.misfit ? one : other;
  if (!best.meet.allFinite()) {
    return fail(Error::Code::kOutOfRange, "the returns of the two boards form no V");
  }
  Matrix3d camera_side, lidar_side;
  for (int b = 0; b < 2; ++b) {
    const auto k = static_cast<std::size_t>(b);
    camera_side.col(b) = seen->directions[k];
    lidar_side.col(b) << best.directions[k], 0;
  }
  camera_side.col(2) = camera_side.col(0).cross(camera_side.col(1));
  lidar_side.col(2) = lidar_side.col(0).cross(lidar_side.col(1));
  const Eigen::JacobiSVD<Matrix3d> svd(camera_side * lidar_side.transpose(),
                                       Eigen::ComputeFullU | Eigen::ComputeFullV);
  const double sign = (svd.matrixU() * svd.matrixV().transpose()).determinant();
  const Matrix3d R = svd.matrixU() * Vector3d(1, 1, sign).asDiagonal() * svd.matrixV().transpose();
  FixedPose pose;
  pose.camera_from_lidar.rotation = Eigen::Quaterniond(R).normalized();
  pose.camera_from_lidar.translation_m =
      seen->meet_m - R * Vector3d(best.meet.x(), best.meet.y(), 0);
  pose.scan_plane = seen->scan_plane;
  if (pose.scan_plane.normal.dot(R.col(2)) < 0) {
    pose.scan_plane = {-pose.scan_plane.normal, -pose.scan_plane.distance_m};
  }
  pose.v_angle_rad = seen->angle_rad;
  describe_fit(camera, boards, stripes, returns, pose);
  return pose;
}

}  // namespace scanfuse::calibrate
