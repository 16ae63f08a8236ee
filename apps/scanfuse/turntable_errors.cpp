#include "turntable_errors.hpp"

#include "scanfuse/calibrate/rig_error.hpp"

namespace scanfuse::app {
namespace {

using Eigen::Vector3d;
constexpr double kRange_m = 1.5;
constexpr int kSteps = 44;  ///< places on the arc

/// The arc's places, each with its share.
template <class Visit>
void over_arc(const Rig& rig, Visit&& visit) {
  for (int i = 0; i < kSteps; ++i) {
    const double share = static_cast<double>(i) / (kSteps - 1);
    visit(rig.first_turntable_rad + share * (rig.last_turntable_rad - rig.first_turntable_rad));
  }
}

Vector3d axis_of(const Rig& rig, double psi, const Vector3d& axis) {
  return rig.pose(psi).rotation * axis;
}

Vector3d point_at(const Rig& rig, double psi) {
  // The same thing in the world: what the truth measures there, with the true bias.
  return calibrate::point_camera(rig, psi, 0, kRange_m);
}

/// From the axis's point nearest to the camera to the foot of the lidar's centre.
double height_of_lidar(const Rig& rig) {
  const double middle = (rig.first_turntable_rad + rig.last_turntable_rad) / 2;
  return rig.axis_direction.dot(rig.pose(middle).translation_m - rig.axis_point_m);
}

TurntableErrors in_units(TurntableErrors squares) {
  for (std::size_t k = 0; k < squares.size(); ++k) {
    const double unit = kTurntableErrors[k].unit == std::string("deg") ? degrees(1) : 1e3;
    squares[k] *= unit * unit;
  }
  return squares;
}

}  // namespace

TurntableErrors squared_errors(const Rig& truth, const Rig& rig) {
  const auto delta = calibrate::difference(truth, rig);
  const double height = height_of_lidar(truth);
  TurntableErrors e{};
  e[0] = delta.segment<2>(0).squaredNorm();
  e[1] = (delta.segment<2>(2) + height * delta.segment<2>(0)).squaredNorm();
  over_arc(truth, [&](double psi) {
    const auto add = [&](std::size_t k, const Vector3d& a, const Vector3d& b) {
      e[k] += (a - b).squaredNorm() / kSteps;
    };
    add(2, truth.pose(psi).translation_m, rig.pose(psi).translation_m);
    add(3, axis_of(truth, psi, Vector3d::UnitZ()), axis_of(rig, psi, Vector3d::UnitZ()));
    add(4, axis_of(truth, psi, Vector3d::UnitX()), axis_of(rig, psi, Vector3d::UnitX()));
    add(5, point_at(truth, psi), point_at(rig, psi));
  });
  for (const double psi : {-kPi / 2, kPi / 2}) {
    e[6] += (point_at(truth, psi) - point_at(rig, psi)).squaredNorm() / 2;
  }
  return in_units(e);
}

TurntableErrors expected_squares(const Rig& truth, const calibrate::RigCovariance& C) {
  const double height = height_of_lidar(truth);
  Eigen::Matrix<double, 2, Rig::kParameters> at_lidar;
  at_lidar.setZero();
  at_lidar.block<2, 2>(0, 0).diagonal().setConstant(height);
  at_lidar.block<2, 2>(0, 2).setIdentity();
  TurntableErrors e{};
  e[0] = C.topLeftCorner<2, 2>().trace();
  e[1] = (at_lidar * C * at_lidar.transpose()).trace();
  over_arc(truth, [&](double psi) {
    const auto pose = calibrate::pose_jacobian(truth, psi);
    const Eigen::Matrix<double, 6, 6> P = pose * C * pose.transpose();
    const Eigen::Matrix3d W = P.topLeftCorner<3, 3>();
    e[2] += P.bottomRightCorner<3, 3>().trace() / kSteps;
    // |w x v|^2 = |w|^2 - (w . v)^2 for a unit vector.
    const Vector3d z = axis_of(truth, psi, Vector3d::UnitZ());
    const Vector3d x = axis_of(truth, psi, Vector3d::UnitX());
    e[3] += (W.trace() - z.dot(W * z)) / kSteps;
    e[4] += (W.trace() - x.dot(W * x)) / kSteps;
    const auto J = calibrate::point_jacobian(truth, psi, 0, kRange_m);
    e[5] += (J * C * J.transpose()).trace() / kSteps;
  });
  for (const double psi : {-kPi / 2, kPi / 2}) {
    const auto J = calibrate::point_jacobian(truth, psi, 0, kRange_m);
    e[6] += (J * C * J.transpose()).trace() / 2;
  }
  return in_units(e);
}

}  // namespace scanfuse::app
