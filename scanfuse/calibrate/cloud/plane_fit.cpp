#include "scanfuse/calibrate/cloud/plane_fit.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "scanfuse/core/random.hpp"

namespace scanfuse::calibrate {
namespace {

constexpr int kTriples = 300;
constexpr int kRounds = 12;
constexpr double kInlierSigmas = 3.5;
constexpr double kLeastSigma_m = 1e-5;
/// A ray closer to the plane than this tells nothing of its height.
constexpr double kLeastSine = 0.05;

using Vectors = std::span<const Eigen::Vector3d>;

/// u, v, normal with the normal against the mean ray (towards +z of the cloud without rays).
Eigen::Matrix3d axes_of(Eigen::Vector3d normal, Vectors rays) {
  Eigen::Vector3d towards = Eigen::Vector3d::UnitZ();
  if (!rays.empty()) {
    towards.setZero();
    for (const auto& ray : rays) towards -= ray;
  }
  if (normal.dot(towards) < 0) normal = -normal;
  Eigen::Index smallest = 0;
  normal.cwiseAbs().minCoeff(&smallest);
  const Eigen::Vector3d u = Eigen::Vector3d::Unit(smallest).cross(normal).normalized();
  Eigen::Matrix3d axes;
  axes << u, normal.cross(u), normal;
  return axes;
}

/// How much longer a height above the plane is along the ray.
double stretch(const PlaneFit& plane, Vectors rays, std::size_t k) {
  if (rays.empty()) return 1;
  return 1 / std::max(std::abs(plane.normal().dot(rays[k])), kLeastSine);
}

/// Inliers within 3.5 robust standard deviations, but never within less than rounding.
void choose_inliers(PlaneFit& plane, Vectors points, Vectors rays, double within_m) {
  plane.inliers.clear();
  for (std::size_t k = 0; k < points.size(); ++k) {
    if (std::abs(plane.height(points[k])) * stretch(plane, rays, k) <= within_m) {
      plane.inliers.push_back(k);
    }
  }
}

double robust_sigma(const PlaneFit& plane, Vectors points, Vectors rays) {
  std::vector<double> off;
  for (const std::size_t k : plane.inliers) {
    off.push_back(std::abs(plane.height(points[k])) * stretch(plane, rays, k));
  }
  const auto middle = off.begin() + static_cast<std::ptrdiff_t>(off.size() / 2);
  std::ranges::nth_element(off, middle);
  return std::max(1.4826 * *middle, kLeastSigma_m);
}

/// One step of least squares over the inliers; false where they do not make a plane.
bool improve(PlaneFit& plane, Vectors points, Vectors rays) {
  Eigen::Matrix3d normal_matrix = Eigen::Matrix3d::Zero();
  Eigen::Vector3d right = Eigen::Vector3d::Zero(), mean = Eigen::Vector3d::Zero();
  for (const std::size_t k : plane.inliers) mean += points[k];
  mean /= static_cast<double>(plane.inliers.size());
  plane.centre_m = mean - plane.normal() * plane.height(mean);
  double squares = 0;
  for (const std::size_t k : plane.inliers) {
    const double g = stretch(plane, rays, k);
    const Eigen::Vector2d q = plane.flat(points[k]);
    const Eigen::Vector3d row = Eigen::Vector3d(1, q.x(), q.y()) * g;
    const double off = plane.height(points[k]) * g;
    normal_matrix += row * row.transpose();
    right += row * off;
    squares += off * off;
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen(normal_matrix);
  if (!(eigen.eigenvalues()[0] > 1e-12 * eigen.eigenvalues()[2])) return false;
  const Eigen::Vector3d step = normal_matrix.ldlt().solve(right);
  const double freedom = std::max<double>(static_cast<double>(plane.inliers.size()) - 3, 1);
  plane.rms_m = std::sqrt(squares / static_cast<double>(plane.inliers.size()));
  plane.covariance = normal_matrix.inverse() * std::max(squares / freedom, 1e-14);
  plane.centre_m += plane.normal() * step[0];
  const Eigen::Vector3d turned = plane.axes * Eigen::Vector3d(-step[1], -step[2], 1).normalized();
  plane.axes = axes_of(turned, rays);
  return plane.centre_m.allFinite() && plane.axes.allFinite();
}

}  // namespace

std::optional<PlaneFit> refine_plane(Vectors points, Vectors rays, PlaneFit start) {
  PlaneFit plane = std::move(start);
  for (int round = 0; round < kRounds; ++round) {
    if (plane.inliers.size() < 4) return std::nullopt;
    if (!improve(plane, points, rays)) return std::nullopt;
    if (round + 1 == kRounds) break;
    choose_inliers(plane, points, rays, kInlierSigmas * robust_sigma(plane, points, rays));
  }
  return plane;
}

std::optional<PlaneFit> fit_plane(Vectors points, Vectors rays, double thickness_m) {
  if (points.size() < 4) return std::nullopt;
  RandomStream random(1);
  PlaneFit best;
  for (int t = 0; t < kTriples; ++t) {
    const auto& a = points[random.below(points.size())];
    const auto& b = points[random.below(points.size())];
    const auto& c = points[random.below(points.size())];
    const Eigen::Vector3d across = (b - a).cross(c - a);
    if (!(across.norm() > 1e-9)) continue;
    PlaneFit plane;
    plane.centre_m = a;
    plane.axes.col(2) = across.normalized();
    choose_inliers(plane, points, {}, thickness_m);
    if (plane.inliers.size() > best.inliers.size()) best = std::move(plane);
  }
  if (best.inliers.size() < 4) return std::nullopt;
  best.axes = axes_of(best.normal(), rays);
  return refine_plane(points, rays, std::move(best));
}

}  // namespace scanfuse::calibrate
