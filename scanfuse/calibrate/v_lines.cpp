#include "scanfuse/calibrate/v_lines.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/LU>

namespace scanfuse::calibrate {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector2d;
using Eigen::Vector3d;

/// From how far along `direction`, starting at `from`, to how far a line runs over the squares.
std::array<double, 2> over_squares(const BoardSpec& spec, const Pose3& board_from_camera,
                                   const Vector3d& from, const Vector3d& direction) {
  const Vector2d start = (board_from_camera * from).head<2>();
  const Vector2d along = (board_from_camera.rotation * direction).head<2>();
  const double high[] = {spec.columns * spec.square_m, spec.rows * spec.square_m};
  double enter = 0, leave = 1e9;
  for (int k = 0; k < 2; ++k) {
    const double a = (-spec.square_m - start[k]) / along[k], b = (high[k] - start[k]) / along[k];
    if (!std::isfinite(a) || !std::isfinite(b)) continue;
    enter = std::max(enter, std::min(a, b));
    leave = std::min(leave, std::max(a, b));
  }
  return {enter, leave};
}

Plane through(const std::array<BoardPose, 2>& boards, const std::array<StripeLine, 2>& stripes) {
  std::vector<Vector3d> points;
  for (std::size_t b = 0; b < 2; ++b) {
    const Plane board = boards[b].plane();
    for (const auto& at : stripes[b].normalised) points.push_back(seen_on(board, at));
  }
  Vector3d mean = Vector3d::Zero();
  for (const auto& p : points) mean += p / static_cast<double>(points.size());
  Matrix3d S = Matrix3d::Zero();
  for (const auto& p : points) S += (p - mean) * (p - mean).transpose();
  const Vector3d normal = Eigen::SelfAdjointEigenSolver<Matrix3d>(S).eigenvectors().col(0);
  return {normal, normal.dot(mean)};
}

Plane changed(const Plane& plane, const Vector3d& delta) {
  const Vector3d n = (plane.normal + axis_basis(plane.normal) * delta.head<2>()).normalized();
  return {n, plane.distance_m + delta.z()};
}

Eigen::Vector4d misfit(const Camera& camera, const std::array<BoardPose, 2>& boards,
                       const std::array<StripeLine, 2>& stripes, const Plane& scan_plane) {
  Eigen::Vector4d r;
  for (const Eigen::Index b : {0, 1}) {
    const auto k = static_cast<std::size_t>(b);
    const Vector2d e = stripe_misfit(camera, stripes[k], scan_plane, boards[k].plane());
    r[2 * b] = std::sqrt(stripes[k].weight) * e[0];
    r[2 * b + 1] = std::sqrt(stripes[k].moment) * e[1];
  }
  return r;
}

}  // namespace

Vector2d stripe_misfit(const Camera& camera, const StripeLine& stripe, const Plane& scan_plane,
                       const Plane& board) {
  // Of all planes through the line, n_s d_b - n_b d_s is the one through the camera's centre.
  const Vector3d l = scan_plane.normal * board.distance_m - board.normal * scan_plane.distance_m;
  const double a = l.x() / camera.fx_px, b = l.y() / camera.fy_px;
  const double c = l.z() - a * camera.cx_px - b * camera.cy_px;
  const Vector2d normal = stripe.normal();
  const double across = a * normal.x() + b * normal.y();
  return {-(a * stripe.centre_px.x() + b * stripe.centre_px.y() + c) / across,
          -(a * stripe.along.x() + b * stripe.along.y()) / across};
}

Result<VLines> v_lines(const std::array<BoardSpec, 2>& specs,
                       const std::array<BoardPose, 2>& boards,
                       const std::array<StripeLine, 2>& stripes, const Plane& scan_plane) {
  VLines v;
  v.scan_plane = scan_plane;
  const Plane first = boards[0].plane(), second = boards[1].plane();
  Matrix3d planes;
  planes << first.normal.transpose(), second.normal.transpose(), scan_plane.normal.transpose();
  if (!(std::abs(planes.determinant()) > 1e-3)) {
    return fail(
        Error::Code::kOutOfRange,
        "the scan plane and the two boards do not meet in a point; set the boards up as a V, "
        "across the scan plane");
  }
  v.meet_m =
      planes.inverse() * Vector3d(first.distance_m, second.distance_m, scan_plane.distance_m);
  for (std::size_t b = 0; b < 2; ++b) {
    const Plane board = boards[b].plane();
    Vector2d mean = Vector2d::Zero();
    for (const auto& at : stripes[b].normalised) {
      mean += at / static_cast<double>(stripes[b].normalised.size());
    }
    const Vector3d seen = seen_on(board, mean) - v.meet_m;
    const Vector3d line = scan_plane.normal.cross(board.normal).normalized();
    v.directions[b] = line.dot(seen) < 0 ? Vector3d(-line) : line;
    v.reach_m[b] =
        over_squares(specs[b], boards[b].camera_from_board.inverse(), v.meet_m, v.directions[b]);
  }
  v.angle_rad = std::acos(std::clamp(v.directions[0].dot(v.directions[1]), -1.0, 1.0));
  if (v.directions[0].cross(v.directions[1]).dot(scan_plane.normal) < 0) {
    v.scan_plane = {-scan_plane.normal, -scan_plane.distance_m};
  }
  return v;
}

Result<VLines> v_lines(const Camera& camera, const std::array<BoardSpec, 2>& specs,
                       const std::array<BoardPose, 2>& boards,
                       const std::array<StripeLine, 2>& stripes) {
  Plane plane = through(boards, stripes);
  for (int round = 0; round < 8; ++round) {
    const Eigen::Vector4d r = misfit(camera, boards, stripes, plane);
    Eigen::Matrix<double, 4, 3> J;
    for (int k = 0; k < 3; ++k) {
      const Vector3d step = 1e-6 * Vector3d::Unit(k);
      J.col(k) = (misfit(camera, boards, stripes, changed(plane, step)) -
                  misfit(camera, boards, stripes, changed(plane, -step))) /
                 2e-6;
    }
    const Matrix3d N = J.transpose() * J;
    const Vector3d delta = -N.ldlt().solve(J.transpose() * r);
    if (!delta.allFinite() || delta.norm() > 0.2) break;  // the camera in the scan plane: keep
    plane = changed(plane, delta);
    if (delta.norm() < 1e-11) break;
  }
  return v_lines(specs, boards, stripes, plane);
}

}  // namespace scanfuse::calibrate
