#include "scanfuse/calibrate/cloud/surfaces.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "scanfuse/calibrate/cloud/assemble.hpp"
#include "scanfuse/calibrate/rig_error.hpp"

namespace scanfuse::calibrate {
namespace {

/// tan of 75 degrees: ranges of neighbours on one surface differ by less than this times their gap.
constexpr double kSteepest = 3.7;
constexpr double kRangeSlack_m = 0.006;

std::vector<Eigen::Vector3d> places(const Cloud& cloud, const std::vector<std::size_t>& points) {
  std::vector<Eigen::Vector3d> found;
  found.reserve(points.size());
  for (const std::size_t k : points) found.push_back(cloud.points[k].position_m);
  return found;
}

bool same_surface(const BeamGrid& grid, const CloudPoint& a, const CloudPoint& b) {
  const Eigen::Vector3d from_a = a.position_m - grid.origin(a.profile);
  const Eigen::Vector3d from_b = b.position_m - grid.origin(b.profile);
  const double range = std::min(from_a.norm(), from_b.norm());
  const double gap =
      range * std::acos(std::clamp(from_a.normalized().dot(from_b.normalized()), -1.0, 1.0));
  return std::abs(from_a.norm() - from_b.norm()) <= kSteepest * gap + kRangeSlack_m;
}

/// The surface that holds `seed`, by flooding from beam to beam.
std::vector<std::size_t> flood(const Cloud& cloud, const BeamGrid& grid, std::size_t seed,
                               std::vector<char>& open) {
  std::vector<std::size_t> surface{seed};
  open[seed] = 0;
  for (std::size_t at = 0; at < surface.size(); ++at) {
    const CloudPoint& point = cloud.points[surface[at]];
    for (const auto& [dp, db] : {std::pair{0, 1}, {0, -1}, {1, 0}, {-1, 0}}) {
      const auto next = grid.index(point.profile + dp, point.beam + db);
      if (!next || open[*next] == 0) continue;
      if (!same_surface(grid, point, cloud.points[*next])) continue;
      open[*next] = 0;
      surface.push_back(*next);
    }
  }
  std::ranges::sort(surface);
  return surface;
}

}  // namespace

std::vector<std::size_t> cropped(const Cloud& cloud, const CropBox& box) {
  std::vector<std::size_t> inside;
  for (std::size_t k = 0; k < cloud.points.size(); ++k) {
    if (box.holds(cloud.points[k].position_m)) inside.push_back(k);
  }
  return inside;
}

Result<FlatPart> flat_part(const Cloud& cloud, std::vector<std::size_t> points,
                           const MeasureOptions& options) {
  if (points.size() < static_cast<std::size_t>(options.min_points)) {
    return fail(Error::Code::kOutOfRange,
                "{} points are too few to measure (min_points is {}); widen --crop", points.size(),
                options.min_points);
  }
  FlatPart part{std::move(points), {}};
  auto plane =
      fit_plane(places(cloud, part.points), rays_of(cloud, part.points), options.thickness_m);
  if (!plane) {
    return fail(Error::Code::kOutOfRange,
                "the {} points make no plane: they lie in a line or too far apart",
                part.points.size());
  }
  part.plane = std::move(*plane);
  return part;
}

std::optional<FlatPart> moved_part(const Cloud& moved, const FlatPart& part) {
  FlatPart there{part.points, {}};
  auto plane = refine_plane(places(moved, part.points), rays_of(moved, part.points), part.plane);
  if (!plane) return std::nullopt;
  there.plane = std::move(*plane);
  return there;
}

std::vector<std::vector<std::size_t>> surfaces(const Cloud& cloud, const BeamGrid& grid,
                                               const std::vector<std::size_t>& points) {
  if (!cloud.has_profiles()) return {points};
  std::vector<char> open(cloud.points.size(), 0);
  for (const std::size_t k : points) open[k] = cloud.points[k].profile >= 0 ? 1 : 0;
  std::vector<std::vector<std::size_t>> found;
  for (const std::size_t k : points) {
    if (open[k] != 0) found.push_back(flood(cloud, grid, k, open));
  }
  std::ranges::stable_sort(found, [](const auto& a, const auto& b) { return a.size() > b.size(); });
  return found;
}

std::vector<double> rig_sigmas(const Cloud& cloud, const std::optional<Rig>& rig,
                               const std::vector<double>& values, const MeasureOf& measure) {
  std::vector<double> squares(values.size(), 0);
  if (!rig || rig->covariance.isZero(0)) return squares;
  const Eigen::SelfAdjointEigenSolver<decltype(Rig::covariance)> eigen(rig->covariance);
  for (int k = 0; k < Rig::kParameters; ++k) {
    const double sigma = std::sqrt(std::max(eigen.eigenvalues()[k], 0.0));
    if (!(sigma > 0)) continue;
    const RigVector along = eigen.eigenvectors().col(k) * sigma;
    const auto more = measure(reassembled(cloud, *rig, changed(*rig, along)));
    const auto less = measure(reassembled(cloud, *rig, changed(*rig, -along)));
    if (more.size() != values.size() || less.size() != values.size()) continue;
    for (std::size_t v = 0; v < values.size(); ++v) {
      const double half = (more[v] - less[v]) / 2;
      squares[v] += half * half;
    }
  }
  for (double& square : squares) square = std::sqrt(square);
  return squares;
}

Result<void> check_rig(const Cloud& cloud, const std::optional<Rig>& rig) {
  if (!rig) return {};
  if (!cloud.has_profiles() || cloud.frame == CloudFrame::kUnknown) {
    return fail(Error::Code::kUnsupported,
                "the cloud does not say from which scans it was assembled, so that the rig's "
                "uncertainty cannot be carried over; measure without --rig, or assemble it anew");
  }
  return {};
}

PlaneMeasure plane_measure(const FlatPart& part) {
  PlaneMeasure measure;
  const PlaneFit& plane = part.plane;
  measure.normal = plane.normal();
  measure.centre_m = plane.centre_m;
  measure.rms_m = plane.rms_m;
  measure.points = plane.inliers.size();
  measure.left_out = part.points.size() - plane.inliers.size();
  const Eigen::Vector2d foot = plane.flat(Eigen::Vector3d::Zero());
  const Eigen::Vector3d at(1, foot.x(), foot.y());
  measure.distance_m.value = std::abs(plane.height(Eigen::Vector3d::Zero()));
  measure.distance_m.sigma_points = std::sqrt(at.dot(plane.covariance * at));
  measure.tilt_rad.sigma_points = std::sqrt(plane.covariance.bottomRightCorner<2, 2>().trace() / 2);
  return measure;
}

}  // namespace scanfuse::calibrate
