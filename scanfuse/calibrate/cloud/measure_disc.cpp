#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>

#include "scanfuse/calibrate/cloud/edge_light.hpp"
#include "scanfuse/calibrate/cloud/surfaces.hpp"

namespace scanfuse::calibrate {
namespace {

/// A disc's points reach no further than this times the radius that their spread gives; those of a
/// square reach 1.22 times as far.
constexpr double kRoundest = 1.12;
constexpr double kLeastAspect = 0.6;
constexpr std::size_t kMostSurfaces = 50;
/// Where nothing stands behind, the edge lies within the spot by this share of its radius.
constexpr double kSpotDoubt = 0.5;

/// A disc by the spread of its points: for an even disc each principal variance is R^2 / 4.
struct RoundGuess {
  Eigen::Vector2d centre_m = Eigen::Vector2d::Zero();
  double radius_m = 0;
  double aspect = 0;  ///< least over greatest spread
  double reach = 0;   ///< greatest distance from the centre over the radius
};

std::vector<Eigen::Vector2d> flat_places(const Cloud& cloud, const FlatPart& part) {
  std::vector<Eigen::Vector2d> places;
  for (const std::size_t k : part.plane.inliers) {
    places.push_back(part.plane.flat(cloud.points[part.points[k]].position_m));
  }
  return places;
}

RoundGuess guess_round(const std::vector<Eigen::Vector2d>& places) {
  RoundGuess guess;
  for (const auto& q : places) guess.centre_m += q;
  guess.centre_m /= static_cast<double>(places.size());
  Eigen::Matrix2d spread = Eigen::Matrix2d::Zero();
  for (const auto& q : places) {
    spread += (q - guess.centre_m) * (q - guess.centre_m).transpose();
  }
  spread /= static_cast<double>(places.size());
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> eigen(spread);
  guess.radius_m = std::sqrt(std::max(2 * spread.trace(), 1e-12));
  guess.aspect =
      std::sqrt(std::max(eigen.eigenvalues()[0], 0.0) / std::max(eigen.eigenvalues()[1], 1e-12));
  for (const auto& q : places) {
    guess.reach = std::max(guess.reach, (q - guess.centre_m).norm() / guess.radius_m);
  }
  return guess;
}

/// The roundest flat surface of the crop.
Result<FlatPart> find_disc(const Cloud& cloud, const BeamGrid& grid, const CropBox& box,
                           const MeasureOptions& options) {
  const auto inside = cropped(cloud, box);
  auto all = surfaces(cloud, grid, inside);
  if (all.size() > kMostSurfaces) all.resize(kMostSurfaces);
  std::optional<FlatPart> best;
  double roundest = kRoundest;
  for (auto& surface : all) {
    if (surface.size() < static_cast<std::size_t>(options.min_points)) break;
    auto part = flat_part(cloud, std::move(surface), options);
    if (!part) continue;
    const auto places = flat_places(cloud, *part);
    if (places.size() < part->points.size() * 6 / 10) continue;
    const RoundGuess guess = guess_round(places);
    if (guess.aspect < kLeastAspect || guess.reach >= roundest) continue;
    roundest = guess.reach;
    best = std::move(*part);
  }
  if (best) return std::move(*best);
  return fail(Error::Code::kOutOfRange,
              "no round flat surface among {} points; give the disc's surroundings with --crop "
              "X0,X1,Y0,Y1,Z0,Z1",
              inside.size());
}

/// The circle of least squares through the outermost points of each profile, as a contour gives it.
double outermost_diameter(const Cloud& cloud, const FlatPart& part) {
  std::map<int, std::pair<std::size_t, std::size_t>> ends;
  for (const std::size_t k : part.plane.inliers) {
    const std::size_t p = part.points[k];
    const auto [place, fresh] = ends.try_emplace(cloud.points[p].profile, p, p);
    if (!fresh) place->second.second = p;
  }
  Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
  Eigen::Vector3d right = Eigen::Vector3d::Zero();
  for (const auto& [profile, pair] : ends) {
    for (const std::size_t p : {pair.first, pair.second}) {
      const Eigen::Vector2d q = part.plane.flat(cloud.points[p].position_m);
      const Eigen::Vector3d row(2 * q.x(), 2 * q.y(), 1);
      normal += row * row.transpose();
      right += row * q.squaredNorm();
    }
  }
  const Eigen::Vector3d circle = normal.ldlt().solve(right);
  const double square = circle[2] + circle.head<2>().squaredNorm();
  return square > 0 ? 2 * std::sqrt(square) : 0;
}

/// Diameter from how many points there are against their density in the middle, and its standard
/// deviation as if points were scattered by chance (a raster does better).
Measured area_diameter(const std::vector<Eigen::Vector2d>& places, const RoundGuess& guess) {
  const double inner = 0.6 * guess.radius_m;
  double count = 0;
  for (const auto& q : places) count += (q - guess.centre_m).norm() <= inner ? 1 : 0;
  Measured diameter;
  if (count < 1) return diameter;
  diameter.value = 2 * inner * std::sqrt(static_cast<double>(places.size()) / count);
  // A raster's count is off by about the root of the cells on the rim.
  const double rim = std::sqrt(2 * std::sqrt(kPi * count));
  diameter.sigma_points = diameter.value / 2 * rim / count;
  return diameter;
}

/// Distance of neighbouring points in the plane: the root of a cell's area.
double spacing_of(const std::vector<Eigen::Vector2d>& places, double radius_m) {
  return std::sqrt(kPi * radius_m * radius_m / static_cast<double>(places.size()));
}

/// Shortest usual distance of neighbours along the beams.
double beam_spacing(const Cloud& cloud, const FlatPart& part) {
  std::vector<double> gaps;
  for (std::size_t k = 1; k < part.plane.inliers.size(); ++k) {
    const CloudPoint& a = cloud.points[part.points[part.plane.inliers[k - 1]]];
    const CloudPoint& b = cloud.points[part.points[part.plane.inliers[k]]];
    if (a.profile == b.profile && b.beam == a.beam + 1) {
      gaps.push_back((part.plane.flat(a.position_m) - part.plane.flat(b.position_m)).norm());
    }
  }
  if (gaps.empty()) return 0;
  const auto middle = gaps.begin() + static_cast<std::ptrdiff_t>(gaps.size() / 2);
  std::ranges::nth_element(gaps, middle);
  return *middle;
}

struct FittedDisc {
  FlatPart part;
  DiscEdge edge;
  EdgeShift shift;
};

std::optional<FittedDisc> fit_edge(const Cloud& cloud, FlatPart part, const DiscEdge& start,
                                   const MeasureOptions& options) {
  const double spacing = beam_spacing(cloud, part);
  if (!(spacing > 0)) return std::nullopt;
  const BeamGrid grid(cloud);
  const double reach = start.radius_m * 1.3 + 6 * spacing;
  const EdgeLightOptions light{spacing, on_tolerance_m(part.plane), options.spot_m};
  DiscEdge edge = start;
  EdgeShift shift;
  for (int round = 0; round < 2; ++round) {  // what is outward of a beam depends on the centre
    const auto beams = edge_beams(grid, part.plane, edge.centre_m, reach);
    edge = fit_disc_edge(beams, edge, spacing);
    shift = edge_shift(beams, edge, light);
    edge = fit_disc_edge(beams, edge, spacing, shift);
  }
  if (!std::isfinite(edge.radius_m) || !(edge.radius_m > 0)) return std::nullopt;
  return FittedDisc{std::move(part), edge, shift};
}

/// The diameter's part that the plane's slopes add: beams meet a tilted plane elsewhere.
double slope_sigma(const Cloud& cloud, const FittedDisc& disc, const MeasureOptions& options) {
  double square = 0;
  for (int k = 1; k < 3; ++k) {
    const double sigma = std::sqrt(disc.part.plane.covariance(k, k));
    FlatPart tilted = disc.part;
    Eigen::Vector3d slopes = Eigen::Vector3d::UnitZ();
    slopes[k - 1] = -sigma;
    const Eigen::Quaterniond turn = turn_z_to(slopes);
    tilted.plane.axes = disc.part.plane.axes * turn.toRotationMatrix();
    const auto there = fit_edge(cloud, std::move(tilted), disc.edge, options);
    if (!there) continue;
    const double change = 2 * (there->edge.radius_m - disc.edge.radius_m);
    square += change * change;
  }
  return std::sqrt(square);
}

void fill_edge(const Cloud& cloud, const FittedDisc& disc, const MeasureOptions& options,
               DiscMeasure& measure) {
  const DiscEdge& edge = disc.edge;
  measure.centre_m = disc.part.plane.raised(edge.centre_m);
  measure.spot_m = disc.shift.spot_m > 0 ? disc.shift.spot_m : 2 * edge.spot_m;
  measure.edge_shift_m = edge.unbacked_share > 0.5 ? disc.shift.unbacked_m : disc.shift.backed_m;
  measure.edge_beams = edge.edge_beams;
  measure.unbacked_share = edge.unbacked_share;
  measure.centre_sigma_m = std::sqrt(edge.covariance.topLeftCorner<2, 2>().trace() / 2);
  measure.diameter_m.value = 2 * edge.radius_m;
  const double unknown = disc.shift.unbacked_known ? 0 : edge.unbacked_share;
  const double doubt = unknown * kSpotDoubt * options.spot_m;
  measure.diameter_m.sigma_points =
      std::hypot(std::hypot(2 * std::sqrt(edge.covariance(2, 2)), 2 * disc.shift.sigma_m),
                 slope_sigma(cloud, disc, options), doubt);
}

}  // namespace

Result<DiscMeasure> measure_disc(const Cloud& cloud, const CropBox& box,
                                 const MeasureOptions& options, const std::optional<Rig>& rig) {
  if (auto fine = check_rig(cloud, rig); !fine) return tl::unexpected(fine.error());
  const BeamGrid grid(cloud);
  auto part = find_disc(cloud, grid, box, options);
  if (!part) return tl::unexpected(part.error());
  const auto places = flat_places(cloud, *part);
  const RoundGuess guess = guess_round(places);
  DiscMeasure measure;
  measure.plane = plane_measure(*part);
  const Measured by_area = area_diameter(places, guess);
  measure.area_diameter_m = by_area.value;
  if (!cloud.has_profiles()) {
    measure.by_area = true;
    measure.diameter_m = by_area;
    measure.centre_m = part->plane.raised(guess.centre_m);
    measure.centre_sigma_m = spacing_of(places, guess.radius_m) / 2;
    return measure;
  }
  measure.outermost_diameter_m = outermost_diameter(cloud, *part);
  DiscEdge start;
  start.centre_m = guess.centre_m;
  start.radius_m = guess.radius_m;
  const auto disc = fit_edge(cloud, std::move(*part), start, options);
  if (!disc) {
    return fail(Error::Code::kOutOfRange,
                "the disc's edge could not be fitted: fewer than two beams on each profile");
  }
  fill_edge(cloud, *disc, options, measure);
  const auto sigmas = rig_sigmas(cloud, rig, {measure.diameter_m.value}, [&](const Cloud& moved) {
    std::vector<double> values;
    auto there = moved_part(moved, disc->part);
    if (!there) return values;
    const auto fitted = fit_edge(moved, std::move(*there), disc->edge, options);
    if (fitted) values.push_back(2 * fitted->edge.radius_m);
    return values;
  });
  measure.diameter_m.sigma_rig = sigmas.front();
  return measure;
}

}  // namespace scanfuse::calibrate
