#include "scanfuse/calibrate/board_plane.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <Eigen/SVD>
#include <vector>

#include "scanfuse/calibrate/undistort.hpp"

namespace scanfuse::calibrate {
namespace {

using Eigen::Matrix3d;
using Eigen::Quaterniond;
using Eigen::Vector2d;
using Eigen::Vector3d;
using Corners = std::span<const Vector2d>;

Vector3d corner_board(const BoardSpec& board, std::size_t i) {
  const auto columns = static_cast<std::size_t>(board.columns);
  return {static_cast<double>(i % columns) * board.square_m,
          static_cast<double>(i / columns) * board.square_m, 0};
}

/// Moves points to their mean and scales them to unit spread: p' = scale (p - mean).
struct Normaliser {
  Vector2d mean = Vector2d::Zero();
  double scale = 1;

  explicit Normaliser(Corners points) {
    for (const auto& p : points) mean += p / static_cast<double>(points.size());
    double spread = 0;
    for (const auto& p : points) spread += (p - mean).squaredNorm();
    scale = std::sqrt(static_cast<double>(points.size()) / spread);
  }
  [[nodiscard]] Vector2d operator()(const Vector2d& p) const { return scale * (p - mean); }
  [[nodiscard]] Matrix3d matrix() const {
    Matrix3d m;
    m << scale, 0, -scale * mean.x(), 0, scale, -scale * mean.y(), 0, 0, 1;
    return m;
  }
};

/// H with t (u, v, 1) = H (x, y, 1), the least singular vector of the usual linear system.
Matrix3d homography(Corners from, Corners to) {
  const Normaliser norm_from(from), norm_to(to);
  Eigen::MatrixXd A(2 * from.size(), 9);
  for (std::size_t i = 0; i < from.size(); ++i) {
    const Vector2d p = norm_from(from[i]), q = norm_to(to[i]);
    const auto row = static_cast<Eigen::Index>(2 * i);
    A.row(row) << p.x(), p.y(), 1, 0, 0, 0, -q.x() * p.x(), -q.x() * p.y(), -q.x();
    A.row(row + 1) << 0, 0, 0, p.x(), p.y(), 1, -q.y() * p.x(), -q.y() * p.y(), -q.y();
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(A.transpose() * A);
  const Eigen::VectorXd h = solver.eigenvectors().col(0);
  Matrix3d H;
  H << h[0], h[1], h[2], h[3], h[4], h[5], h[6], h[7], h[8];
  return norm_to.matrix().inverse() * H * norm_from.matrix();
}

Matrix3d nearest_rotation(const Matrix3d& M) {
  const Eigen::JacobiSVD<Matrix3d> svd(M, Eigen::ComputeFullU | Eigen::ComputeFullV);
  Vector3d signs(1, 1, (svd.matrixU() * svd.matrixV().transpose()).determinant());
  return svd.matrixU() * signs.asDiagonal() * svd.matrixV().transpose();
}

/// T of least squares in x/z (r3 . X + Tz) = r1 . X + Tx, and for y alike.
Vector3d translation_of(const Matrix3d& R, const BoardSpec& board, Corners normalised) {
  Matrix3d N = Matrix3d::Zero();
  Vector3d right = Vector3d::Zero();
  for (std::size_t i = 0; i < normalised.size(); ++i) {
    const Vector3d p = R * corner_board(board, i);
    for (int k = 0; k < 2; ++k) {
      const Vector3d a = Vector3d::Unit(k) - normalised[i][k] * Vector3d::UnitZ();
      N += a * a.transpose();
      right -= a * a.dot(p);
    }
  }
  return N.ldlt().solve(right);
}

double rms_of(const Camera& camera, const BoardSpec& board, Corners corners, const Pose3& pose) {
  double sum = 0;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    sum += (camera.project(pose * corner_board(board, i)) - corners[i]).squaredNorm();
  }
  return std::sqrt(sum / (2.0 * static_cast<double>(corners.size())));
}

Result<void> check(const BoardSpec& board, Corners corners, std::string_view name) {
  if (board.rows < 2 || board.columns < 2 || !(board.square_m > 0)) {
    return fail(Error::Code::kOutOfRange,
                "{}: a chessboard needs at least 2 x 2 inner corners and a square size above 0",
                name);
  }
  const auto wanted =
      static_cast<std::size_t>(board.rows) * static_cast<std::size_t>(board.columns);
  if (corners.size() != wanted) {
    return fail(Error::Code::kMalformed,
                "{}: {} corners where {} x {} = {} are expected; count the inner corners, where "
                "four squares meet",
                name, corners.size(), board.rows, board.columns, wanted);
  }
  for (const auto& corner : corners) {
    if (!corner.allFinite()) {
      return fail(Error::Code::kMalformed, "{}: a corner's coordinates are not numbers", name);
    }
  }
  return {};
}

/// One step of Gauss-Newton on the raw image; the length of the step.
double refine_once(const Camera& camera, const BoardSpec& board, Corners corners, Pose3& pose) {
  Eigen::Matrix<double, 6, 6> N = Eigen::Matrix<double, 6, 6>::Zero();
  Eigen::Matrix<double, 6, 1> right = Eigen::Matrix<double, 6, 1>::Zero();
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vector3d turned = pose.rotation * corner_board(board, i);
    const Vector3d p = turned + pose.translation_m;
    const Eigen::Matrix<double, 2, 3> by_point = projection_jacobian(camera, p);
    Eigen::Matrix<double, 2, 6> J;
    for (int k = 0; k < 3; ++k) J.col(k) = by_point * Vector3d::Unit(k).cross(turned);
    J.rightCols<3>() = by_point;
    N += J.transpose() * J;
    right += J.transpose() * (corners[i] - camera.project(p));
  }
  const Eigen::Matrix<double, 6, 1> step = N.ldlt().solve(right);
  const Vector3d w = step.head<3>();
  if (!step.allFinite() || w.norm() == 0) return 0;
  pose.rotation = (Quaterniond(Eigen::AngleAxisd(w.norm(), w.normalized())) * pose.rotation);
  pose.rotation.normalize();
  pose.translation_m += step.tail<3>();
  return step.norm();
}

/// Corners whose order is not that of a grid of this size miss it by a good part of a square.
Result<BoardPose> accept(const Camera& camera, const BoardSpec& board, Corners corners,
                         const Pose3& pose, std::string_view name) {
  BoardPose found{pose, rms_of(camera, board, corners, pose)};
  const double square_px = camera.fx_px * board.square_m / std::abs(pose.translation_m.z());
  if (std::isfinite(found.rms_px) && pose.translation_m.z() > 0 &&
      found.rms_px < 0.15 * square_px) {
    return found;
  }
  return fail(
      Error::Code::kMalformed,
      "{}: the corners do not form a grid of {} rows and {} columns ({:.3g} px off); are rows "
      "and columns swapped, corners out of order, or is the camera's focal length wrong?",
      name, board.rows, board.columns, found.rms_px);
}

}  // namespace

Plane BoardPose::plane() const {
  const Vector3d r3 = camera_from_board.rotation * Vector3d::UnitZ();
  const double d = r3.dot(camera_from_board.translation_m);
  // Facing the camera: the camera's centre lies on the side that the normal points to.
  return d > 0 ? Plane{-r3, -d} : Plane{r3, d};
}

Result<BoardPose> board_pose_liu2023(const Camera& camera, const BoardSpec& board, Corners corners,
                                     std::string_view name) {
  if (auto fine = check(board, corners, name); !fine) return tl::unexpected(fine.error());
  std::vector<Vector2d> on_board, normalised;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    on_board.emplace_back(corner_board(board, i).head<2>());
    normalised.push_back(undistort(camera, corners[i]));
    if (!normalised.back().allFinite()) {
      return fail(Error::Code::kOutOfRange,
                  "{}: a corner lies where the camera's distortion cannot be undone; check k1, k2",
                  name);
    }
  }
  const Matrix3d H = homography(on_board, normalised);  // K taken out: H = (r1 r2 T), scaled
  const double sign = H(2, 2) < 0 ? -1 : 1;             // the board stands before the camera
  const double scale = sign * 2 / (H.col(0).norm() + H.col(1).norm());
  Matrix3d M;
  M << scale * H.col(0), scale * H.col(1), (scale * H.col(0)).cross(scale * H.col(1));
  if (!M.allFinite()) return accept(camera, board, corners, {}, name);
  const Matrix3d R = nearest_rotation(M);
  return accept(camera, board, corners, {Quaterniond(R), translation_of(R, board, normalised)},
                name);
}

Result<BoardPose> board_pose(const Camera& camera, const BoardSpec& board, Corners corners,
                             std::string_view name) {
  auto start = board_pose_liu2023(camera, board, corners, name);
  if (!start) return start;
  Pose3 pose = start->camera_from_board;
  for (int k = 0; k < 20 && refine_once(camera, board, corners, pose) > 1e-12; ++k) {
  }
  return accept(camera, board, corners, pose, name);
}

}  // namespace scanfuse::calibrate
