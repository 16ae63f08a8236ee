#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "scanfuse/geometry/pose.hpp"
#include "scanfuse/types/virtual_scan.hpp"

namespace scanfuse::preprocess {

/// How well a pose lays a scan on the reference.
struct ScanFit {
  double share = 0;       ///< of the points compared, those that lie on the reference
  double cost = 0;        ///< sum of bounded squared residuals, in their deviations
  double spread_rad = 0;  ///< of the full circle, the bearings in which such points lie
  int compared = 0;
};

struct ScanMatch {
  Pose2 reference_from_scan;
  ScanFit fit;
  bool converged = false;
};

/// Where a match is expected, and how surely.
struct ScanPrior {
  Pose2 reference_from_scan;
  double sigma_m = 0.1;
  double sigma_rad = 0.1;
};

/// Finds how a sensor has moved between two scans of a world that stands: iterated closest points,
/// the distance taken to the line through the reference's neighbours where they lie on one
/// [Censi2008]; closest by bearing, residuals bounded by weights that tighten from step to step, so
/// that what moves on its own has no say; regularised by a prior, which decides where the scene
/// says nothing (along a corridor). Where a match is poor, it is begun anew turned to either side,
/// and from other starts given, until one is good. At most `kMostCompared` points are compared.
class ScanMatcher {
 public:
  static constexpr int kMostCompared = 360;

  void refer_to(const VirtualScan& scan);
  [[nodiscard]] bool has_reference() const { return !facets_.empty(); }
  /// `others`: more starts, seen from the expected pose.
  [[nodiscard]] ScanMatch operator()(const VirtualScan& scan, const ScanPrior& prior,
                                     std::span<const Pose2> others = {}) const;
  [[nodiscard]] ScanFit fit_at(const VirtualScan& scan, const Pose2& reference_from_scan) const;

 private:
  /// A point of the reference; `normal` is zero where its neighbours lie on no line.
  struct Facet {
    Eigen::Vector2d point_m = Eigen::Vector2d::Zero();
    Eigen::Vector2d normal = Eigen::Vector2d::Zero();
    double bearing_rad = 0;

    [[nodiscard]] bool is_line() const { return !normal.isZero(); }
  };

  [[nodiscard]] const Facet* closest(const Eigen::Vector2d& p, double within_m) const;
  /// One step of the descent: by how much to move and turn.
  [[nodiscard]] Eigen::Vector3d change(const VirtualScan& scan, const ScanPrior& prior,
                                       const Pose2& pose, double bound_m) const;
  [[nodiscard]] ScanMatch descend(const VirtualScan& scan, const ScanPrior& prior,
                                  const Pose2& start) const;

  std::vector<Facet> facets_;  ///< increasing bearing
  double sigma_m_ = 0.03;
};

}  // namespace scanfuse::preprocess
