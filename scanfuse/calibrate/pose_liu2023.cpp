#include <Eigen/LU>
#include <Eigen/QR>

#include "scanfuse/calibrate/pose.hpp"

namespace scanfuse::calibrate {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector2d;
using Eigen::Vector3d;

/// a x + b y + c z = 1 by least squares [Liu2023, eq. 4].
Plane plane_through(const std::array<BoardPose, 2>& boards,
                    const std::array<StripeLine, 2>& stripes) {
  Matrix3d N = Matrix3d::Zero();
  Vector3d right = Vector3d::Zero();
  for (std::size_t b = 0; b < 2; ++b) {
    const Plane board = boards[b].plane();
    for (const auto& at : stripes[b].normalised) {
      const Vector3d p = seen_on(board, at);
      N += p * p.transpose();
      right += p;
    }
  }
  const Vector3d abc = N.inverse() * right;
  return {abc.normalized(), 1 / abc.norm()};
}

std::vector<Vector2d> points_of(const std::vector<BeamReturn>& returns) {
  std::vector<Vector2d> points;  // eq. 6
  for (const auto& r : returns) {
    points.push_back(r.range_m * Vector2d(std::cos(r.angle_rad), std::sin(r.angle_rad)));
  }
  return points;
}

/// lambda_0: slope of y = lambda x + eta through the first board's points.
double first_slope(const std::vector<Vector2d>& points) {
  Vector2d mean = Vector2d::Zero();
  for (const auto& p : points) mean += p / static_cast<double>(points.size());
  double xx = 0, xy = 0;
  for (const auto& p : points) {
    xx += (p.x() - mean.x()) * (p.x() - mean.x());
    xy += (p.x() - mean.x()) * (p.y() - mean.y());
  }
  return xy / xx;
}

struct SlopeLine {
  double slope = 0;
  double intercept = 0;
  [[nodiscard]] Vector2d foot(const Vector2d& p) const {
    const double x = (p.x() + slope * (p.y() - intercept)) / (1 + slope * slope);
    return {x, slope * x + intercept};
  }
};

struct LidarLines {
  SlopeLine first;
  SlopeLine second;
  double misfit = std::numeric_limits<double>::infinity();
};

/// eqs. 7-11: lambda, eta_1, eta_2 by linear least squares. The print takes the second line at
/// beta - alpha, which holds where the V is concave and the first board has the lower angles; for
/// the other order `alpha` is negative.
LidarLines lines_with_angle(const std::vector<Vector2d>& P, const std::vector<Vector2d>& Q,
                            double alpha) {
  const double lambda0 = first_slope(P);
  const double bottom = std::cos(alpha) + std::sin(alpha) * lambda0;
  const double slope2 = (std::cos(alpha) * lambda0 - std::sin(alpha)) / bottom;
  const double phi = std::sqrt(1 + slope2 * slope2), norm = std::sqrt(1 + lambda0 * lambda0);
  const auto rows = static_cast<Eigen::Index>(P.size() + Q.size());
  Eigen::MatrixXd A = Eigen::MatrixXd::Zero(rows, 3);
  Eigen::VectorXd y(rows);
  Eigen::Index row = 0;
  for (const auto& p : P) {  // eq. 10
    A.row(row) << p.x() / norm, 1 / norm, 0;
    y[row++] = p.y() / norm;
  }
  for (const auto& q : Q) {  // eq. 11, as printed: its factor of lambda is half the derivative
    A.row(row) << std::cos(alpha) / bottom * q.x() / phi, 0, 1 / phi;
    y[row++] = (q.y() + std::sin(alpha) / bottom * q.x()) / phi;
  }
  const Vector3d x = A.colPivHouseholderQr().solve(y);
  const double second =
      (std::cos(alpha) * x[0] - std::sin(alpha)) / (std::cos(alpha) + std::sin(alpha) * x[0]);
  return {{x[0], x[1]}, {second, x[2]}, (A * x - y).squaredNorm()};
}

Vector2d meet(const SlopeLine& a, const SlopeLine& b) {
  const double x = (b.intercept - a.intercept) / (a.slope - b.slope);
  return {x, a.slope * x + a.intercept};
}

Matrix3d frame(const Vector3d& l1, const Vector3d& l2) {
  Matrix3d M;
  M << l1, l2, l1.cross(l2);
  return M;
}

}  // namespace

Result<FixedPose> pose_liu2023(const Camera& camera, const std::array<BoardSpec, 2>& specs,
                               const std::array<BoardPose, 2>& boards,
                               const std::array<StripeLine, 2>& stripes,
                               const BoardReturns& returns) {
  const Plane plane = plane_through(boards, stripes);
  if (!plane.normal.allFinite() || !std::isfinite(plane.distance_m)) {
    return fail(Error::Code::kOutOfRange,
                "the scan plane passes through the camera's centre, where eq. 4 has no answer; use "
                "the exact pose");
  }
  const auto seen = v_lines(specs, boards, stripes, plane);
  if (!seen) return tl::unexpected(seen.error());
  // The paper numbers the boards so that L1 is met at the lower angles.
  const auto P = points_of(returns.on_board[0]), Q = points_of(returns.on_board[1]);
  if (P.size() < 2 || Q.size() < 2) {
    return fail(Error::Code::kMalformed, "too few returns on a board");
  }
  const auto down = lines_with_angle(P, Q, seen->angle_rad);
  const auto up = lines_with_angle(P, Q, -seen->angle_rad);
  const LidarLines& lines = down.misfit <= up.misfit ? down : up;
  const Vector2d E = meet(lines.first, lines.second);
  const bool ascending =
      returns.on_board[0].front().angle_rad < returns.on_board[1].front().angle_rad;
  const Vector2d S1 = lines.first.foot(ascending ? P.front() : P.back());
  const Vector2d S2 = lines.second.foot(ascending ? Q.back() : Q.front());
  Vector3d l1 = Vector3d::Zero(), l2 = Vector3d::Zero();  // eq. 12
  l1.head<2>() = (S1 - E).normalized();
  l2.head<2>() = (S2 - E).normalized();
  const Matrix3d R = frame(seen->directions[0], seen->directions[1]) * frame(l1, l2).inverse();
  FixedPose pose;  // eqs. 13, 14
  pose.camera_from_lidar.rotation = Eigen::Quaterniond(R).normalized();
  pose.camera_from_lidar.translation_m = seen->meet_m - R * Vector3d(E.x(), E.y(), 0);
  pose.scan_plane = seen->scan_plane;
  if (pose.scan_plane.normal.dot(R.col(2)) < 0) {
    pose.scan_plane = {-pose.scan_plane.normal, -pose.scan_plane.distance_m};
  }
  pose.v_angle_rad = seen->angle_rad;
  if (!R.allFinite() || !pose.camera_from_lidar.translation_m.allFinite()) {
    return fail(Error::Code::kOutOfRange,
                "a board lies along the lidar's y axis, where eqs. 7-11 have no answer; use the "
                "exact pose");
  }
  describe_fit(camera, boards, stripes, returns, pose);
  return pose;
}

}  // namespace scanfuse::calibrate
