#include "scanfuse/calibrate/rig_error.hpp"

namespace scanfuse::calibrate {
namespace {

using Eigen::AngleAxisd;
using Eigen::Matrix3d;
using Eigen::Quaterniond;
using Eigen::Vector3d;

constexpr int kAxis = 0, kPoint = 2, kRotation = 4, kTranslation = 7, kBias = 10, kScale = 11;

Matrix3d cross_matrix(const Vector3d& v) {
  Matrix3d m;
  m << 0, -v.z(), v.y(), v.z(), 0, -v.x(), -v.y(), v.x(), 0;
  return m;
}

Quaterniond turn_by(const Vector3d& w) {
  const double angle = w.norm();
  return angle > 0 ? Quaterniond(AngleAxisd(angle, w / angle)) : Quaterniond::Identity();
}

Vector3d ray_of(double beam_angle_rad) {
  return {std::cos(beam_angle_rad), std::sin(beam_angle_rad), 0};
}

/// d(Rot(n, psi) v) / d(direction along the basis): n = n0 + B a, |n| = 1 to first order.
Eigen::Matrix<double, 3, 2> turn_by_axis(const Vector3d& n, double psi, const Vector3d& v,
                                         const Eigen::Matrix<double, 3, 2>& basis) {
  const double c = std::cos(psi), s = std::sin(psi);
  const Matrix3d d =
      -s * cross_matrix(v) + (1 - c) * (n.dot(v) * Matrix3d::Identity() + n * v.transpose());
  return d * basis;
}

}  // namespace

Rig changed(const Rig& rig, const RigVector& delta) {
  Rig out = rig;
  const auto basis = axis_basis(rig.axis_direction);
  out.axis_direction = (rig.axis_direction + basis * delta.segment<2>(kAxis)).normalized();
  const Vector3d through = rig.axis_point_m + basis * delta.segment<2>(kPoint);
  out.axis_point_m = through - out.axis_direction * out.axis_direction.dot(through);
  const Quaterniond turn = turn_by(delta.segment<3>(kRotation));
  out.camera_from_lidar.rotation = (turn * rig.camera_from_lidar.rotation).normalized();
  out.camera_from_lidar.translation_m += delta.segment<3>(kTranslation);
  out.range_bias_m += delta[kBias];
  out.angle_scale += delta[kScale];
  return out;
}

RigVector difference(const Rig& from, const Rig& to) {
  RigVector delta;
  const auto basis = axis_basis(from.axis_direction);
  const Vector3d n = to.axis_direction / to.axis_direction.dot(from.axis_direction);
  delta.segment<2>(kAxis) = basis.transpose() * n;
  // Where the other axis meets the plane through this one's point, across this one.
  const Vector3d apart = to.axis_point_m - from.axis_point_m;
  const Vector3d met = apart - n * from.axis_direction.dot(apart);
  delta.segment<2>(kPoint) = basis.transpose() * met;
  const AngleAxisd turn(to.camera_from_lidar.rotation *
                        from.camera_from_lidar.rotation.conjugate());
  delta.segment<3>(kRotation) = wrap_pi(turn.angle()) * turn.axis();
  delta.segment<3>(kTranslation) =
      to.camera_from_lidar.translation_m - from.camera_from_lidar.translation_m;
  delta[kBias] = to.range_bias_m - from.range_bias_m;
  delta[kScale] = to.angle_scale - from.angle_scale;
  return delta;
}

Eigen::Matrix<double, 6, Rig::kParameters> pose_jacobian(const Rig& rig, double turntable_rad) {
  const auto basis = axis_basis(rig.axis_direction);
  const Vector3d n = rig.axis_direction;
  const double psi = rig.angle_scale * turntable_rad;
  const Matrix3d turn = AngleAxisd(psi, n).toRotationMatrix();
  const Vector3d arm = rig.camera_from_lidar.translation_m - rig.axis_point_m;
  Eigen::Matrix<double, 6, Rig::kParameters> J;
  J.setZero();
  // exp(w) turn R = Rot(n + da, psi) R, from how the turn moves the three axes.
  for (int k = 0; k < 3; ++k) {
    const Vector3d e = Vector3d::Unit(k);
    J.block<3, 2>(0, kAxis) += 0.5 * cross_matrix(turn * e) * turn_by_axis(n, psi, e, basis);
  }
  J.block<3, 2>(3, kAxis) = turn_by_axis(n, psi, arm, basis);
  // Moving the axis along itself moves nothing; its nearest point may lie anywhere on it.
  J.block<3, 2>(3, kPoint) = (Matrix3d::Identity() - turn) * basis;
  J.block<3, 3>(0, kRotation) = turn;
  J.block<3, 3>(3, kTranslation) = turn;
  J.block<3, 1>(0, kScale) = turntable_rad * n;
  J.block<3, 1>(3, kScale) = turntable_rad * n.cross(turn * arm);
  return J;
}

Eigen::Matrix<double, 6, 6> pose_covariance(const Rig& rig, double turntable_rad) {
  const auto J = pose_jacobian(rig, turntable_rad);
  return J * rig.covariance * J.transpose();
}

Vector3d point_camera(const Rig& rig, double turntable_rad, double beam_angle_rad, double range_m) {
  return rig.pose(turntable_rad) * ((range_m - rig.range_bias_m) * ray_of(beam_angle_rad));
}

Eigen::Matrix<double, 3, Rig::kParameters> point_jacobian(const Rig& rig, double turntable_rad,
                                                          double beam_angle_rad, double range_m) {
  const auto pose = pose_jacobian(rig, turntable_rad);
  const Vector3d ray = rig.pose(turntable_rad).rotation * ray_of(beam_angle_rad);
  const Vector3d along = (range_m - rig.range_bias_m) * ray;
  Eigen::Matrix<double, 3, Rig::kParameters> J =
      pose.bottomRows<3>() - cross_matrix(along) * pose.topRows<3>();
  J.col(kBias) -= ray;
  return J;
}

Eigen::Matrix3d point_covariance(const Rig& rig, double turntable_rad, double beam_angle_rad,
                                 double range_m, const PointNoise& own) {
  const auto J = point_jacobian(rig, turntable_rad, beam_angle_rad, range_m);
  const Vector3d ray = rig.pose(turntable_rad).rotation * ray_of(beam_angle_rad);
  const Vector3d point = point_camera(rig, turntable_rad, beam_angle_rad, range_m);
  const Vector3d turned = rig.angle_scale * rig.axis_direction.cross(point - rig.axis_point_m);
  return J * rig.covariance * J.transpose() + std::pow(own.range_m, 2) * ray * ray.transpose() +
         std::pow(own.turntable_rad, 2) * turned * turned.transpose();
}

}  // namespace scanfuse::calibrate
