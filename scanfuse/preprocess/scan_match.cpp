#include "scanfuse/preprocess/scan_match.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <array>
#include <bitset>
#include <cmath>
#include <numbers>

#include "scanfuse/geometry/angles.hpp"

namespace scanfuse::preprocess {
namespace {

constexpr int kNeighbours = 3;  ///< to either side, for the line through a point
constexpr int kLeastOnLine = 4;
constexpr double kFarthestMatch_m = 1;
/// Residuals are bounded softly by this at first, by `kTightest` deviations at last.
constexpr double kWidest_m = 0.5;
constexpr double kTightest = 3;
constexpr double kNarrowing = 0.7;
constexpr int kMostSteps = 25;
constexpr double kStepDone_m = 1e-3, kStepDone_rad = 2e-4;
constexpr double kTryOthersBelow = 0.6;
constexpr std::array kOtherTurns_rad{-0.12, 0.12, -0.3, 0.3};
constexpr int kMatchSectors = 24;
/// Neighbouring points err alike (one surface, one line through it): each counts as a part of one.
constexpr double kCorrelation = 3;
/// What lies on no line is placed so much worse.
constexpr double kPointFactor = 3;

std::size_t stride_of(const VirtualScan& scan) {
  return scan.points.size() / ScanMatcher::kMostCompared + 1;
}

/// Offsets from a point of those around it on the same surface.
struct Surroundings {
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  Eigen::Matrix2d squares = Eigen::Matrix2d::Zero();
  int count = 0;

  void add(const Eigen::Vector2d& offset) {
    sum += offset;
    squares += offset * offset.transpose();
    ++count;
  }
};

Surroundings surroundings(const VirtualScan& scan, std::size_t of) {
  const auto at = scan.position(static_cast<std::uint32_t>(of));
  const double gap_m = 0.15 + 0.05 * at.norm();
  const auto size = static_cast<int>(scan.points.size());
  const auto middle = static_cast<int>(of);
  Surroundings around;
  around.add(Eigen::Vector2d::Zero());
  for (const int side : {-1, 1}) {
    Eigen::Vector2d last = at;
    for (int n = 1; n <= kNeighbours; ++n) {
      const int k = middle + side * n;
      if (k < 0 || k >= size) break;
      const auto p = scan.position(static_cast<std::uint32_t>(k));
      if ((p - last).norm() > gap_m) break;
      around.add(p - at);
      last = p;
    }
  }
  return around;
}

/// Normal equations of the change (x, y, turn about `origin`) that takes residuals away.
struct Equations {
  Eigen::Matrix3d H = Eigen::Matrix3d::Zero();
  Eigen::Vector3d g = Eigen::Vector3d::Zero();

  /// `p` has the distance `r` along `n` from where it should be.
  void add(double r, const Eigen::Vector2d& n, const Eigen::Vector2d& arm, double weight) {
    const Eigen::Vector3d J(n.x(), n.y(), n.y() * arm.x() - n.x() * arm.y());
    H.noalias() += weight * J * J.transpose();
    g += weight * r * J;
  }
};

Equations from_prior(const ScanPrior& prior, const Pose2& pose) {
  const double place = 1 / (prior.sigma_m * prior.sigma_m);
  const double turn = 1 / (prior.sigma_rad * prior.sigma_rad);
  const Pose2& expected = prior.reference_from_scan;
  Equations equations;
  equations.H.diagonal() << place, place, turn;
  equations.g << place * (pose.x_m - expected.x_m), place * (pose.y_m - expected.y_m),
      turn * wrap_pi(pose.heading_rad - expected.heading_rad);
  return equations;
}

}  // namespace

void ScanMatcher::refer_to(const VirtualScan& scan) {
  facets_.clear();
  sigma_m_ = std::max(scan.sigma_range_m, 0.02);
  for (std::size_t i = 0; i < scan.points.size(); ++i) {
    Facet facet;
    facet.point_m = scan.position(static_cast<std::uint32_t>(i));
    facet.bearing_rad = std::atan2(facet.point_m.y(), facet.point_m.x());
    const auto around = surroundings(scan, i);
    const Eigen::Vector2d mean = around.sum / around.count;
    const Eigen::Matrix2d C = around.squares / around.count - mean * mean.transpose();
    const double half = 0.5 * (C(0, 0) - C(1, 1));
    const double root = std::hypot(half, C(0, 1)), centre = 0.5 * C.trace();
    const double along_m2 = centre + root, across_m2 = std::max(centre - root, 0.0);
    const bool is_line = around.count >= kLeastOnLine && along_m2 > 4 * across_m2 &&
                         across_m2 < 4 * sigma_m_ * sigma_m_;
    if (is_line) {
      const double angle = 0.5 * std::atan2(2 * C(0, 1), 2 * half);
      facet.normal = {-std::sin(angle), std::cos(angle)};
      facet.point_m += facet.normal.dot(mean) * facet.normal;
    }
    facets_.push_back(facet);
  }
  std::sort(facets_.begin(), facets_.end(),
            [](const Facet& a, const Facet& b) { return a.bearing_rad < b.bearing_rad; });
}

const ScanMatcher::Facet* ScanMatcher::closest(const Eigen::Vector2d& p, double within_m) const {
  const double range_m = p.norm();
  const double bearing = std::atan2(p.y(), p.x());
  const auto from =
      std::lower_bound(facets_.begin(), facets_.end(), bearing,
                       [](const Facet& facet, double value) { return facet.bearing_rad < value; });
  const auto size = static_cast<int>(facets_.size());
  const auto start = static_cast<int>(from - facets_.begin());
  const Facet* best = nullptr;
  double least_m2 = within_m * within_m;
  for (const int side : {-1, 1}) {
    int k = side > 0 ? start : start - 1;
    for (int steps = 0; steps <= size / 2; ++steps, k += side) {
      if (k < 0) k += size;
      if (k >= size) k -= size;
      const Facet& facet = facets_[static_cast<std::size_t>(k)];
      // No facet farther round comes nearer than the ray at this bearing.
      const double apart = std::abs(wrap_pi(facet.bearing_rad - bearing));
      const double reach_m = apart < std::numbers::pi / 2 ? range_m * std::sin(apart) : range_m;
      if (reach_m * reach_m >= least_m2) break;
      const double d2 = (facet.point_m - p).squaredNorm();
      if (d2 >= least_m2) continue;
      least_m2 = d2;
      best = &facet;
    }
  }
  return best;
}

ScanFit ScanMatcher::fit_at(const VirtualScan& scan, const Pose2& reference_from_scan) const {
  ScanFit fit;
  if (facets_.empty() || scan.points.empty()) return fit;
  std::bitset<kMatchSectors> sectors;
  int inliers = 0;
  for (std::size_t i = 0; i < scan.points.size(); i += stride_of(scan)) {
    ++fit.compared;
    const Eigen::Vector2d p = reference_from_scan * scan.position(static_cast<std::uint32_t>(i));
    const Facet* facet = closest(p, 2 * kTightest * sigma_m_ + 0.02 * p.norm());
    double away = kTightest;
    if (facet != nullptr) {
      const Eigen::Vector2d d = p - facet->point_m;
      away = facet->is_line() ? std::abs(facet->normal.dot(d)) : d.norm() / kPointFactor;
      away = std::min(away / sigma_m_, kTightest);
    }
    fit.cost += away * away / kCorrelation;
    if (away >= kTightest) continue;
    ++inliers;
    const double turn = scan.points[i].bearing_rad / (2 * std::numbers::pi) + 0.5;
    const auto sector = static_cast<int>(turn * kMatchSectors);
    sectors.set(static_cast<std::size_t>(std::clamp(sector, 0, kMatchSectors - 1)));
  }
  fit.share = static_cast<double>(inliers) / fit.compared;
  fit.spread_rad = static_cast<double>(sectors.count()) * 2 * std::numbers::pi / kMatchSectors;
  return fit;
}

Eigen::Vector3d ScanMatcher::change(const VirtualScan& scan, const ScanPrior& prior,
                                    const Pose2& pose, double bound_m) const {
  Equations equations = from_prior(prior, pose);
  const Eigen::Vector2d origin(pose.x_m, pose.y_m);
  for (std::size_t i = 0; i < scan.points.size(); i += stride_of(scan)) {
    const Eigen::Vector2d p = pose * scan.position(static_cast<std::uint32_t>(i));
    const Facet* facet = closest(p, std::min(3 * bound_m + 0.02 * p.norm(), kFarthestMatch_m));
    if (facet == nullptr) continue;
    const Eigen::Vector2d d = p - facet->point_m;
    const double sigma_m = facet->is_line() ? sigma_m_ : kPointFactor * sigma_m_;
    const auto weight = [&](double r) {  // of Geman and McClure
      const double soft = 1 + r * r / (bound_m * bound_m);
      return 1 / (soft * soft * kCorrelation * sigma_m * sigma_m);
    };
    if (facet->is_line()) {
      const double r = facet->normal.dot(d);
      equations.add(r, facet->normal, p - origin, weight(r));
    } else {
      equations.add(d.x(), Eigen::Vector2d::UnitX(), p - origin, weight(d.norm()));
      equations.add(d.y(), Eigen::Vector2d::UnitY(), p - origin, weight(d.norm()));
    }
  }
  return -equations.H.ldlt().solve(equations.g);
}

ScanMatch ScanMatcher::descend(const VirtualScan& scan, const ScanPrior& prior,
                               const Pose2& start) const {
  ScanMatch match;
  Pose2& pose = match.reference_from_scan = start;
  double bound_m = kWidest_m;
  for (int step = 0; step < kMostSteps && !match.converged; ++step) {
    const Eigen::Vector3d by = change(scan, prior, pose, bound_m);
    if (!by.allFinite()) break;
    pose.x_m += by.x();
    pose.y_m += by.y();
    pose.heading_rad = wrap_pi(pose.heading_rad + by.z());
    match.converged = bound_m <= kTightest * sigma_m_ && by.head<2>().norm() < kStepDone_m &&
                      std::abs(by.z()) < kStepDone_rad;
    bound_m = std::max(kNarrowing * bound_m, kTightest * sigma_m_);
  }
  match.fit = fit_at(scan, pose);
  return match;
}

ScanMatch ScanMatcher::operator()(const VirtualScan& scan, const ScanPrior& prior,
                                  std::span<const Pose2> others) const {
  const Pose2& expected = prior.reference_from_scan;
  ScanMatch best;
  best.reference_from_scan = expected;
  if (facets_.empty() || scan.points.empty()) return best;
  best = descend(scan, prior, expected);
  const auto try_from = [&](const Pose2& start) {
    if (best.fit.share >= kTryOthersBelow) return;
    const ScanMatch other = descend(scan, prior, expected * start);
    if (other.fit.share > best.fit.share) best = other;
  };
  for (const Pose2& start : others) try_from(start);
  for (const double turn : kOtherTurns_rad) try_from({0, 0, turn});
  return best;
}

}  // namespace scanfuse::preprocess
