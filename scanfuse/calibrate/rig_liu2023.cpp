#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <algorithm>

#include "scanfuse/calibrate/motion.hpp"

namespace scanfuse::calibrate {
namespace {

using Eigen::AngleAxisd;
using Eigen::Matrix3d;
using Eigen::Vector2d;
using Eigen::Vector3d;

Vector3d mean_of(const std::vector<Vector3d>& points) {
  Vector3d mean = Vector3d::Zero();
  for (const auto& p : points) mean += p / static_cast<double>(points.size());
  return mean;
}

/// Unit normal of the plane of total least squares.
Vector3d plane_normal(const std::vector<Vector3d>& points) {
  const Vector3d mean = mean_of(points);
  Matrix3d S = Matrix3d::Zero();
  for (const auto& p : points) S += (p - mean) * (p - mean).transpose();
  return Eigen::SelfAdjointEigenSolver<Matrix3d>(S).eigenvectors().col(0);
}

/// Least-squares circle in the plane across n: x^2 + y^2 = 2 a x + 2 b y + c.
std::pair<Vector3d, double> circle(const std::vector<Vector3d>& points, const Vector3d& n,
                                   double offset) {
  const auto basis = axis_basis(n);
  const Vector3d mean = mean_of(points);
  Matrix3d N = Matrix3d::Zero();
  Vector3d right = Vector3d::Zero();
  for (const auto& p : points) {
    const Vector2d q = basis.transpose() * (p - mean);
    const Vector3d a(2 * q.x(), 2 * q.y(), 1);
    N += a * a.transpose();
    right += a * q.squaredNorm();
  }
  const Vector3d x = N.ldlt().solve(right);
  Vector3d centre = mean + basis * x.head<2>();
  centre += n * (offset - n.dot(centre));
  return {centre, std::sqrt(x.z() + x.head<2>().squaredNorm())};
}

/// A point that turns about an axis through `centre`: its place on the circle at the first angle,
/// the shift of eqs. 19 and 22, and the direction p_L or p_Z of the axis.
struct Turning {
  Vector3d start = Vector3d::Zero();
  double shift_rad = 0;
  Vector3d axis = Vector3d::UnitZ();
};

Turning turning(std::span<const TurnedPose> poses, const std::vector<Vector3d>& points,
                const Vector3d& centre, double radius) {
  Turning t;
  const Vector3d first = points.front() - centre;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Vector3d arm = points[i] - centre;
    const double seen =
        std::acos(std::clamp(arm.dot(first) / (arm.norm() * first.norm()), -1.0, 1.0));
    t.shift_rad += (poses[i].turntable_rad - poses.front().turntable_rad - seen) /
                   static_cast<double>(points.size());
  }
  t.start = radius * first.normalized();
  t.axis = first.cross(points.back() - centre).normalized();
  return t;
}

/// The vector at turntable angle psi (eqs. 20, 23).
Vector3d at(const Turning& t, double psi, double first) {
  const double phi = psi - first - t.shift_rad;
  return t.axis.cross(t.start) * std::sin(phi) + t.start * std::cos(phi);
}

/// Both solutions of eq. 25: n_w . x = d, n_z . x = 0, |x| = 1.
std::array<Vector3d, 2> x_axes(const Vector3d& n_w, const Vector3d& n_z, double d) {
  const Vector3d across = (n_w - n_z * n_z.dot(n_w)).normalized();  // within the scan plane
  const double part = d / n_w.dot(across);
  const double rest = std::sqrt(std::max(0.0, 1 - part * part));
  const Vector3d side = n_z.cross(across);
  return {part * across + rest * side, part * across - rest * side};
}

}  // namespace

Result<PaperFit> rig_liu2023(std::span<const TurnedPose> unsorted) {
  if (unsorted.size() < 3) {
    return fail(Error::Code::kOutOfRange, "the paper's method needs 3 positions");
  }
  std::vector<TurnedPose> poses(unsorted.begin(), unsorted.end());
  std::stable_sort(poses.begin(), poses.end(),
                   [](const auto& a, const auto& b) { return a.turntable_rad < b.turntable_rad; });
  std::vector<Vector3d> centres, z_tips, x_tips;
  for (const auto& pose : poses) {
    centres.push_back(pose.camera_from_lidar.translation_m);
    z_tips.push_back(pose.camera_from_lidar.rotation * Vector3d::UnitZ());
    x_tips.push_back(pose.camera_from_lidar.rotation * Vector3d::UnitX());
  }
  const Vector3d n = plane_normal(z_tips);  // eq. 16
  const double d_z = n.dot(mean_of(z_tips)), d_l = n.dot(mean_of(centres)),
               d_x = n.dot(mean_of(x_tips));
  const auto on_plane = [&](std::vector<Vector3d> points, double d) {
    for (auto& p : points) p += n * (d - n.dot(p));
    return points;
  };
  const double first = poses.front().turntable_rad;
  const auto flat = on_plane(centres, d_l);
  const auto [G, radius] = circle(flat, n, d_l);
  const Turning centre = turning(poses, flat, G, radius);
  const double r_z = std::sqrt(std::max(0.0, 1 - d_z * d_z));
  const Turning z_axis = turning(poses, on_plane(z_tips, d_z), d_z * n, r_z);

  const auto z_at = [&](double psi) -> Vector3d {
    return (d_z * n + at(z_axis, psi, first)).normalized();
  };
  double likeness[] = {0, 0};
  for (std::size_t i = 0; i < poses.size(); ++i) {
    const auto both = x_axes(n, z_at(poses[i].turntable_rad), d_x);
    for (std::size_t k = 0; k < 2; ++k) likeness[k] += both[k].dot(x_tips[i]);
  }
  const Vector3d z0 = z_at(0);
  const Vector3d x0 = x_axes(n, z0, d_x)[likeness[1] > likeness[0] ? 1 : 0].normalized();
  Matrix3d R;
  R << x0, z0.cross(x0), z0;  // eq. 26
  PaperFit fit;
  fit.contradiction = centre.axis.dot(z_axis.axis) < 0;
  fit.rig.axis_direction = z_axis.axis.dot(n) < 0 ? Vector3d(-n) : n;
  fit.rig.axis_point_m = G - n * n.dot(G);
  fit.rig.camera_from_lidar = {Eigen::Quaterniond(R).normalized(), G + at(centre, 0, first)};
  fit.rig.first_turntable_rad = first;
  fit.rig.last_turntable_rad = poses.back().turntable_rad;
  if (!R.allFinite() || !fit.rig.camera_from_lidar.translation_m.allFinite()) {
    return fail(
        Error::Code::kOutOfRange,
        "the paper's method has no answer here: centres that do not move, z or x axes along "
        "the axis; use closed_form or joint");
  }
  return fit;
}

}  // namespace scanfuse::calibrate
