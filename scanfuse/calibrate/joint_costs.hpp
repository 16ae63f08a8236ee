#pragma once

#include <Eigen/Geometry>
#include <cmath>

#include "scanfuse/calibrate/joint_state.hpp"

/// The observations of one line or corner as functions of all unknowns' changes. Private to the
/// room.
namespace scanfuse::calibrate::costs {

template <class T>
using Vector3 = Eigen::Matrix<T, 3, 1>;

/// exp(w) v, with the right derivatives at w = 0 too.
template <class T>
Vector3<T> turned(const T* w, const Eigen::Vector3d& v) {
  using std::cos, std::sin, std::sqrt;
  const Vector3<T> turn(w[0], w[1], w[2]);
  const Vector3<T> from(T(v.x()), T(v.y()), T(v.z()));
  const T squared = turn.squaredNorm();
  if (!(squared > T(1e-24))) return from + turn.cross(from);
  const T angle = sqrt(squared);
  const Vector3<T> n = turn / angle;
  return from * cos(angle) + n.cross(from) * sin(angle) + n * (n.dot(from) * (T(1) - cos(angle)));
}

/// The lidar's axes and centre at an angle of the turntable.
template <class T>
struct LidarFrame {
  Vector3<T> x, y, z, centre;
};

template <class T>
LidarFrame<T> lidar_frame(const Rig& base, double commanded_rad, const T* rig,
                          const T& correction_rad) {
  using std::cos, std::sin;
  const Eigen::Matrix<double, 3, 2> basis = axis_basis(base.axis_direction);
  const Vector3<T> n = (base.axis_direction.cast<T>() + basis.col(0).cast<T>() * rig[0] +
                        basis.col(1).cast<T>() * rig[1])
                           .normalized();
  const Vector3<T> point = base.axis_point_m.cast<T>() + basis.col(0).cast<T>() * rig[2] +
                           basis.col(1).cast<T>() * rig[3];
  const T psi = (base.angle_scale + rig[11]) * (commanded_rad + correction_rad);
  const T c = cos(psi), s = sin(psi);
  const auto about = [&](const Vector3<T>& v) -> Vector3<T> {
    return v * c + n.cross(v) * s + n * (n.dot(v) * (T(1) - c));
  };
  const Eigen::Matrix3d R = base.camera_from_lidar.rotation.toRotationMatrix();
  LidarFrame<T> frame;
  frame.x = about(turned(rig + 4, Eigen::Vector3d(R.col(0))));
  frame.z = about(turned(rig + 4, Eigen::Vector3d(R.col(2))));
  frame.y = frame.z.cross(frame.x);
  Vector3<T> arm = base.camera_from_lidar.translation_m.cast<T>() - point;
  for (int k = 0; k < 3; ++k) arm[k] += rig[7 + k];
  frame.centre = point + about(arm);
  return frame;
}

template <class T>
struct BoardPlane {
  Vector3<T> normal;
  T distance;
};

template <class T>
BoardPlane<T> board_plane(const Pose3& base, const T* board) {
  BoardPlane<T> plane;
  plane.normal = turned(board, Eigen::Vector3d(base.rotation * Eigen::Vector3d::UnitZ()));
  plane.distance = T(0);
  for (int k = 0; k < 3; ++k) {
    plane.distance += plane.normal[k] * (base.translation_m[k] + board[3 + k]);
  }
  return plane;
}

/// Offset and slope of the projected line against the stripe's, in units of one point's noise.
struct Stripe {
  const JointState& state;
  const Camera& camera;
  const Sample& sample;
  std::size_t board;
  std::size_t place;  ///< of the sample's angle correction
  Eigen::Vector2d scale = Eigen::Vector2d::Ones();

  template <class T>
  bool operator()(const T* rig, const T* board_change, const T* angle, T* residual) const {
    const StripeLine& line = sample.stripes[board];
    const auto lidar = lidar_frame<T>(state.rig, sample.turntable_rad, rig,
                                      state.correction_rad[place] + angle[0]);
    const auto plane = board_plane<T>(state.camera_from_board[board], board_change);
    const Vector3<T> l = lidar.z * plane.distance - plane.normal * lidar.z.dot(lidar.centre);
    const T a = l[0] / camera.fx_px, b = l[1] / camera.fy_px;
    const T c = l[2] - a * camera.cx_px - b * camera.cy_px;
    const Eigen::Vector2d normal = line.normal();
    const T across = a * normal.x() + b * normal.y();
    const T offset = -(a * line.centre_px.x() + b * line.centre_px.y() + c) / across;
    const T slope = -(a * line.along.x() + b * line.along.y()) / across;
    residual[0] = scale[0] * std::sqrt(line.weight) * offset;
    residual[1] = scale[1] * std::sqrt(line.moment) * slope;
    return true;
  }
};

/// z - R (offset, slope, bias, square bias) of a line of returns, in units of one range's noise:
/// offset and slope are those of the board's trace in the scan plane.
struct Lidar {
  const JointState& state;
  const Sample& sample;
  std::size_t board;
  std::size_t place;
  Eigen::Vector4d scale = Eigen::Vector4d::Ones();

  template <class T>
  bool operator()(const T* rig, const T* board_change, const T* angle, const T* square,
                  T* residual) const {
    const LidarLine& line = sample.lines[board];
    const auto lidar = lidar_frame<T>(state.rig, sample.turntable_rad, rig,
                                      state.correction_rad[place] + angle[0]);
    const auto plane = board_plane<T>(state.camera_from_board[board], board_change);
    const T mx = plane.normal.dot(lidar.x), my = plane.normal.dot(lidar.y);
    const T c = plane.distance - plane.normal.dot(lidar.centre);
    const Eigen::Vector2d along = line.along();
    const T across = mx * line.normal.x() + my * line.normal.y();
    const T e[] = {(c - mx * line.centre_m.x() - my * line.centre_m.y()) / across,
                   -(mx * along.x() + my * along.y()) / across, state.rig.range_bias_m + rig[10],
                   state.square_bias_m + square[0]};
    for (int i = 0; i < 4; ++i) {
      residual[i] = T(line.z[i]);
      for (int k = i; k < 4; ++k) residual[i] -= line.R(i, k) * e[k];
      residual[i] *= scale[i];
    }
    return true;
  }
};

/// A corner's distance in the raw image.
struct Corner {
  const JointState& state;
  const Camera& camera;
  const KeptCorner& corner;
  std::size_t board;
  double scale = 1;

  template <class T>
  bool operator()(const T* board_change, T* residual) const {
    const Pose3& base = state.camera_from_board[board];
    const Vector3<T> p = turned(board_change, Eigen::Vector3d(base.rotation * corner.board_m));
    const T X = p[0] + base.translation_m.x() + board_change[3];
    const T Y = p[1] + base.translation_m.y() + board_change[4];
    const T Z = p[2] + base.translation_m.z() + board_change[5];
    const T x = X / Z, y = Y / Z, r2 = x * x + y * y;
    const T q = 1.0 + r2 * (camera.k1 + r2 * (camera.k2 + r2 * camera.k3));
    residual[0] =
        scale * (camera.fx_px * (x * q + 2 * camera.p1 * x * y + camera.p2 * (r2 + 2.0 * x * x)) +
                 camera.cx_px - corner.seen_px.x());
    residual[1] =
        scale * (camera.fy_px * (y * q + camera.p1 * (r2 + 2.0 * y * y) + 2 * camera.p2 * x * y) +
                 camera.cy_px - corner.seen_px.y());
    return true;
  }
};

}  // namespace scanfuse::calibrate::costs
