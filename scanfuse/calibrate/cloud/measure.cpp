#include "scanfuse/calibrate/cloud/measure.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <optional>

#include "scanfuse/calibrate/cloud/surfaces.hpp"

namespace scanfuse::calibrate {
namespace {

Result<FlatPart> cropped_part(const Cloud& cloud, const CropBox& box,
                              const MeasureOptions& options) {
  return flat_part(cloud, cropped(cloud, box), options);
}

/// Distance and normal of a plane: what a rig's error moves.
std::vector<double> plane_values(const FlatPart& part) {
  const Eigen::Vector3d n = part.plane.normal();
  return {plane_measure(part).distance_m.value, n.x(), n.y(), n.z()};
}

PlaneMeasure plane_with_rig(const Cloud& cloud, const FlatPart& part,
                            const std::optional<Rig>& rig) {
  PlaneMeasure measure = plane_measure(part);
  const auto sigmas = rig_sigmas(cloud, rig, plane_values(part), [&](const Cloud& moved) {
    const auto there = moved_part(moved, part);
    return there ? plane_values(*there) : std::vector<double>{};
  });
  measure.distance_m.sigma_rig = sigmas[0];
  measure.tilt_rad.sigma_rig =
      Eigen::Vector3d(sigmas[1], sigmas[2], sigmas[3]).norm() / std::sqrt(2);
  return measure;
}

/// From a plane to the middle of other points, across and straight.
std::vector<double> distance_values(const PlaneFit& from, const PlaneFit& to) {
  return {std::abs(from.height(to.centre_m)), (to.centre_m - from.centre_m).norm()};
}

/// Edges of a flat part along one way through the beams: midway between the last beam on it and the
/// first beyond it, in the plane.
struct EdgeMiddle {
  Eigen::Vector2d place_m;
  double gap_m;
};

constexpr int kMostMixedBeams = 6;
/// Neighbouring returns of a background differ by no more, beside this share of their ranges.
constexpr double kLevel_m = 0.01;
constexpr double kLevelShare = 0.005;

/// How many beams on, along (dp, db), the first shows the background: beams in between met both and
/// were removed, or lie between. 1 where none comes.
int beams_to_background(const BeamGrid& grid, int profile, int beam, int dp, int db) {
  const auto range = [&](int k) -> std::optional<double> {
    const int p = profile + k * dp;
    if (p < 0 || p >= grid.profiles()) return std::nullopt;
    const CloudPoint* point = grid.point(p, beam + k * db);
    if (point == nullptr) return std::nullopt;
    return (point->position_m - grid.origin(p)).norm();
  };
  for (int k = 1; k <= kMostMixedBeams; ++k) {
    const auto here = range(k), next = range(k + 1);
    if (!here || !next) continue;
    if (std::abs(*here - *next) <= kLevel_m + kLevelShare * *here) return k;
  }
  return 1;
}

std::vector<EdgeMiddle> edge_middles(const Cloud& cloud, const FlatPart& part) {
  const BeamGrid grid(cloud);
  std::vector<char> on(cloud.points.size(), 0);
  for (const std::size_t k : part.plane.inliers) on[part.points[k]] = 1;
  const auto is_on = [&](int profile, int beam) {
    const auto index = grid.index(profile, beam);
    return index && on[*index] != 0;
  };
  std::vector<EdgeMiddle> middles;
  for (const std::size_t k : part.plane.inliers) {
    const CloudPoint& point = cloud.points[part.points[k]];
    for (const auto& [dp, db] : {std::pair{0, 1}, {0, -1}, {1, 0}, {-1, 0}}) {
      const int p = point.profile + dp, b = point.beam + db;
      if (p < 0 || p >= grid.profiles() || is_on(p, b)) continue;
      // A hole of one beam is noise, not an edge.
      if (is_on(p + dp, b + db)) continue;
      const int on_to = beams_to_background(grid, point.profile, point.beam, dp, db);
      const auto beyond =
          grid.meets(part.plane, point.profile + on_to * dp, point.beam + on_to * db);
      const auto inside = grid.meets(part.plane, point.profile, point.beam);
      if (!beyond || !inside) continue;
      const Eigen::Vector2d in = part.plane.flat(*inside), out = part.plane.flat(*beyond);
      middles.push_back({(in + out) / 2, (out - in).norm()});
    }
  }
  return middles;
}

/// A rectangle: direction of one side, extents along it and across.
struct FlatRectangle {
  double angle_rad = 0;
  Eigen::Vector2d low = Eigen::Vector2d::Zero();
  Eigen::Vector2d high = Eigen::Vector2d::Zero();
  Eigen::Vector2d sigma = Eigen::Vector2d::Zero();  ///< of the two sides
};

Eigen::Rotation2Dd turned_back(double angle) { return Eigen::Rotation2Dd(-angle); }

FlatRectangle bounds_at(const std::vector<EdgeMiddle>& middles, double angle) {
  FlatRectangle box;
  box.angle_rad = angle;
  box.low.setConstant(1e9);
  box.high.setConstant(-1e9);
  for (const auto& middle : middles) {
    const Eigen::Vector2d q = turned_back(angle) * middle.place_m;
    box.low = box.low.cwiseMin(q);
    box.high = box.high.cwiseMax(q);
  }
  return box;
}

FlatRectangle least_rectangle(const std::vector<EdgeMiddle>& middles) {
  FlatRectangle best;
  double least = 1e18;
  for (int k = 0; k < 360; ++k) {
    const FlatRectangle box = bounds_at(middles, k * kPi / 720);
    const double area = (box.high - box.low).prod();
    if (area < least) {
      least = area;
      best = box;
    }
  }
  return best;
}

/// Moves each side to the mean of the middles near it (within one gap), turned to fit them best.
FlatRectangle settled(const std::vector<EdgeMiddle>& middles, FlatRectangle box) {
  for (int round = 0; round < 10; ++round) {
    const auto turn = turned_back(box.angle_rad);
    double slope_sum = 0, slope_weight = 0;
    FlatRectangle next = box;
    next.sigma.setZero();
    for (int axis = 0; axis < 2; ++axis) {
      for (const bool high : {false, true}) {
        double n = 0, t = 0, h = 0, tt = 0, th = 0, gap = 0;
        for (const auto& middle : middles) {
          const Eigen::Vector2d q = turn * middle.place_m;
          const double off = q[axis] - (high ? box.high[axis] : box.low[axis]);
          const double along = q[1 - axis];
          const double inset = 2 * middle.gap_m;
          if (std::abs(off) > middle.gap_m || along < box.low[1 - axis] + inset ||
              along > box.high[1 - axis] - inset) {
            continue;
          }
          n += 1, t += along, h += off, tt += along * along, th += along * off;
          gap += middle.gap_m;
        }
        if (n < 3) continue;
        const double spread = tt - t * t / n;
        const double slope = spread > 0 ? (th - t * h / n) / spread : 0;
        slope_sum += (axis == 0 ? -slope : slope) * spread;
        slope_weight += spread;
        (high ? next.high : next.low)[axis] += h / n;
        const double sigma = gap / n / std::sqrt(12.0 * n);
        next.sigma[axis] = std::hypot(next.sigma[axis], sigma);
      }
    }
    if (slope_weight > 0) next.angle_rad += slope_sum / slope_weight;
    box = next;
  }
  return box;
}

std::optional<FlatRectangle> rectangle_of(const Cloud& cloud, const FlatPart& part) {
  const auto middles = edge_middles(cloud, part);
  if (middles.size() < 8) return std::nullopt;
  return settled(middles, least_rectangle(middles));
}

std::vector<double> sides(const FlatRectangle& box) {
  const Eigen::Vector2d size = box.high - box.low;
  return {size.maxCoeff(), size.minCoeff()};
}

}  // namespace

Result<PlaneMeasure> measure_plane(const Cloud& cloud, const CropBox& box,
                                   const MeasureOptions& options, const std::optional<Rig>& rig) {
  if (auto fine = check_rig(cloud, rig); !fine) return tl::unexpected(fine.error());
  const auto part = cropped_part(cloud, box, options);
  if (!part) return tl::unexpected(part.error());
  return plane_with_rig(cloud, *part, rig);
}

Result<DistanceMeasure> measure_distance(const Cloud& cloud, const CropBox& from, const CropBox& to,
                                         const MeasureOptions& options,
                                         const std::optional<Rig>& rig) {
  if (auto fine = check_rig(cloud, rig); !fine) return tl::unexpected(fine.error());
  const auto a = cropped_part(cloud, from, options);
  if (!a) return tl::unexpected(a.error());
  const auto b = cropped_part(cloud, to, options);
  if (!b) return tl::unexpected(b.error());
  DistanceMeasure measure;
  measure.from = plane_with_rig(cloud, *a, rig);
  const auto values = distance_values(a->plane, b->plane);
  const auto sigmas = rig_sigmas(cloud, rig, values, [&](const Cloud& moved) {
    const auto c = moved_part(moved, *a), d = moved_part(moved, *b);
    return c && d ? distance_values(c->plane, d->plane) : std::vector<double>{};
  });
  const Eigen::Vector2d across = a->plane.flat(b->plane.centre_m);
  const Eigen::Vector3d lever(1, across.x(), across.y());
  const double height = std::hypot(std::sqrt(lever.dot(a->plane.covariance * lever)),
                                   std::sqrt(b->plane.covariance(0, 0)));
  measure.perpendicular_m = {values[0], height, sigmas[0]};
  measure.centres_m = {values[1], std::sqrt(a->plane.covariance(0, 0) + b->plane.covariance(0, 0)),
                       sigmas[1]};
  return measure;
}

Result<SizeMeasure> measure_size(const Cloud& cloud, const CropBox& box,
                                 const MeasureOptions& options, const std::optional<Rig>& rig) {
  if (auto fine = check_rig(cloud, rig); !fine) return tl::unexpected(fine.error());
  if (!cloud.has_profiles()) {
    return fail(Error::Code::kUnsupported,
                "a size needs a cloud that knows its beams: one that `scanfuse assemble` wrote");
  }
  const auto part = cropped_part(cloud, box, options);
  if (!part) return tl::unexpected(part.error());
  const auto rectangle = rectangle_of(cloud, *part);
  if (!rectangle) {
    return fail(Error::Code::kOutOfRange, "the part has no edges to measure between");
  }
  SizeMeasure measure;
  measure.plane = plane_with_rig(cloud, *part, rig);
  const auto values = sides(*rectangle);
  const auto sigmas = rig_sigmas(cloud, rig, values, [&](const Cloud& moved) {
    const auto there = moved_part(moved, *part);
    const auto found = there ? rectangle_of(moved, *there) : std::nullopt;
    return found ? sides(*found) : std::vector<double>{};
  });
  const Eigen::Vector2d size = rectangle->high - rectangle->low;
  const int longer = size.x() >= size.y() ? 0 : 1;
  measure.length_m = {values[0], rectangle->sigma[longer], sigmas[0]};
  measure.width_m = {values[1], rectangle->sigma[1 - longer], sigmas[1]};
  const Eigen::Vector2d axis =
      Eigen::Rotation2Dd(rectangle->angle_rad) * Eigen::Vector2d::Unit(longer);
  measure.length_axis = part->plane.axes.leftCols<2>() * axis;
  return measure;
}

}  // namespace scanfuse::calibrate
