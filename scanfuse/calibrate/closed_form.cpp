#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <Eigen/SVD>
#include <algorithm>

#include "scanfuse/calibrate/middle.hpp"
#include "scanfuse/calibrate/motion.hpp"

namespace scanfuse::calibrate {
namespace {

using Eigen::AngleAxisd;
using Eigen::Matrix3d;
using Eigen::Quaterniond;
using Eigen::Vector3d;
using Poses = std::span<const TurnedPose>;

Vector3d log_of(const Quaterniond& q) {
  const AngleAxisd turn(q);
  return wrap_pi(turn.angle()) * turn.axis();
}

/// A pair of poses: which, how far apart in commanded angle, and the turn that was seen.
struct Pair {
  std::size_t i = 0;
  std::size_t j = 0;
  double apart_rad = 0;
  Vector3d turn = Vector3d::Zero();
};

/// All pairs, or for many poses those at a few strides; none so far apart that turns wrap.
std::vector<Pair> pairs_of(Poses poses) {
  std::vector<Pair> pairs;
  const std::size_t n = poses.size();
  const std::size_t skip = std::max<std::size_t>(1, n / 200);
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = i + 1; j < n; j += skip) {
      const double apart = poses[j].turntable_rad - poses[i].turntable_rad;
      if (std::abs(apart) > radians(150) || apart == 0) continue;
      pairs.push_back({i, j, apart,
                       log_of(poses[j].camera_from_lidar.rotation *
                              poses[i].camera_from_lidar.rotation.conjugate())});
    }
  }
  return pairs;
}

/// Coordinate by coordinate the middle of what pairs far apart say of the axis.
Vector3d middle_axis(const std::vector<Pair>& pairs) {
  double widest = 0;
  for (const auto& pair : pairs) widest = std::max(widest, std::abs(pair.apart_rad));
  std::array<std::vector<double>, 3> parts;
  for (const auto& pair : pairs) {
    if (std::abs(pair.apart_rad) < widest / 3) continue;
    for (int k = 0; k < 3; ++k) {
      parts[static_cast<std::size_t>(k)].push_back(pair.turn[k] / pair.apart_rad);
    }
  }
  return Vector3d(middle_of(parts[0]), middle_of(parts[1]), middle_of(parts[2])).normalized();
}

Vector3d mean_axis(const std::vector<Pair>& pairs, const std::vector<double>& weights,
                   double& ratio) {
  Vector3d sum = Vector3d::Zero();
  double squares = 0;
  for (const auto& pair : pairs) {
    const double w = weights[pair.i] * weights[pair.j];
    sum += w * pair.apart_rad * pair.turn;
    squares += w * pair.apart_rad * pair.apart_rad;
  }
  ratio = sum.norm() / squares;
  return sum.normalized();
}

Matrix3d mean_rotation(Poses poses, const Vector3d& n, const std::vector<double>& weights) {
  Matrix3d sum = Matrix3d::Zero();
  for (std::size_t i = 0; i < poses.size(); ++i) {
    sum += weights[i] * (AngleAxisd(-poses[i].turntable_rad, n) *
                         poses[i].camera_from_lidar.rotation.toRotationMatrix());
  }
  const Eigen::JacobiSVD<Matrix3d> svd(sum, Eigen::ComputeFullU | Eigen::ComputeFullV);
  const double sign = (svd.matrixU() * svd.matrixV().transpose()).determinant();
  return svd.matrixU() * Vector3d(1, 1, sign).asDiagonal() * svd.matrixV().transpose();
}

/// O_i = B g + Rot(n, psi_i) a: fills in the axis point B g and the centre B g + a.
void fit_centres(Poses poses, const std::vector<double>& weights, Rig& rig) {
  using Vector5d = Eigen::Matrix<double, 5, 1>;
  const auto basis = axis_basis(rig.axis_direction);
  Eigen::Matrix<double, 5, 5> N = Eigen::Matrix<double, 5, 5>::Zero();
  Vector5d right = Vector5d::Zero();
  for (std::size_t i = 0; i < poses.size(); ++i) {
    Eigen::Matrix<double, 3, 5> A;
    A << basis, AngleAxisd(poses[i].turntable_rad, rig.axis_direction).toRotationMatrix();
    N += weights[i] * A.transpose() * A;
    right += weights[i] * A.transpose() * poses[i].camera_from_lidar.translation_m;
  }
  const Vector5d x = N.ldlt().solve(right);
  rig.axis_point_m = basis * x.head<2>();
  rig.camera_from_lidar.translation_m = rig.axis_point_m + x.tail<3>();
}

/// Weight 1, or 0 for what lies beyond five deviations of the middle of all.
std::vector<double> trusted(const MotionFit& fit) {
  std::vector<double> weights;
  for (std::size_t i = 0; i < fit.rotation_rad.size(); ++i) {
    const bool near = fit.rotation_rad[i] <= 5 * fit.rotation_median_rad + 1e-7 &&
                      fit.centre_m[i] <= 5 * fit.centre_median_m + 1e-7;
    weights.push_back(near ? 1 : 0);
  }
  return weights;
}

void measure_misfits(Poses poses, MotionFit& fit) {
  fit.rotation_rad.clear();
  fit.centre_m.clear();
  for (const auto& pose : poses) {
    const Pose3 model = fit.rig.pose(pose.turntable_rad);
    fit.rotation_rad.push_back(model.rotation.angularDistance(pose.camera_from_lidar.rotation));
    fit.centre_m.push_back((model.translation_m - pose.camera_from_lidar.translation_m).norm());
  }
  fit.rotation_median_rad = middle_of(fit.rotation_rad);
  fit.centre_median_m = middle_of(fit.centre_m);
}

}  // namespace

Result<MotionFit> rig_closed_form(Poses poses) {
  const auto pairs = pairs_of(poses);
  double widest = 0;
  for (const auto& pair : pairs) widest = std::max(widest, std::abs(pair.apart_rad));
  if (poses.size() < 2 || widest < 1e-4) {
    return fail(Error::Code::kOutOfRange,
                "the turntable's angles do not differ; are they in the session, in degrees?");
  }
  MotionFit fit;
  std::vector<double> weights(poses.size(), 1);
  fit.rig.axis_direction = middle_axis(pairs);
  for (int round = 0; round < 6; ++round) {
    if (round > 0) fit.rig.axis_direction = mean_axis(pairs, weights, fit.turn_ratio);
    if (!fit.rig.axis_direction.allFinite()) break;
    fit.rig.camera_from_lidar.rotation =
        Quaterniond(mean_rotation(poses, fit.rig.axis_direction, weights)).normalized();
    fit_centres(poses, weights, fit.rig);
    measure_misfits(poses, fit);
    weights = trusted(fit);
  }
  if (!fit.rig.axis_direction.allFinite() || !fit.rig.axis_point_m.allFinite()) {
    return fail(Error::Code::kOutOfRange, "the lidar's poses show no common axis of turning");
  }
  const auto [low, high] = std::minmax_element(
      poses.begin(), poses.end(),
      [](const auto& a, const auto& b) { return a.turntable_rad < b.turntable_rad; });
  fit.rig.first_turntable_rad = low->turntable_rad;
  fit.rig.last_turntable_rad = high->turntable_rad;
  return fit;
}

}  // namespace scanfuse::calibrate
