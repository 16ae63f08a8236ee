#include "scanfuse/simulate/turntable_scans.hpp"

#include <algorithm>
#include <cmath>

#include "scanfuse/core/parallel.hpp"
#include "scanfuse/core/random.hpp"

namespace scanfuse::simulate {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr std::uint64_t kScanStream = 2'000'000;
constexpr std::uint64_t kDiscStream = 3'000'000;
constexpr double kDiscStep_rad = radians(0.05);
constexpr double kClearance_m = 0.012;
constexpr std::uint64_t kMostScansOfADisc = 100'000;

/// What one ray of a bundle met.
struct RayHit {
  double range_m = 0;
  double light = 0;
  bool black = false;
};

/// Rays that come back together.
struct SpotEcho {
  double light = 0, range_m = 0, black = 0;
};

/// Directions of a bundle about a beam, as offsets at the lidar and at 1 m, evenly over the spot.
std::vector<Vector2d> spot(int rays) {
  std::vector<Vector2d> out;
  for (int i = 0; i < rays; ++i) {
    for (int j = 0; j < rays; ++j) {
      const Vector2d p((2.0 * i + 1) / rays - 1, (2.0 * j + 1) / rays - 1);
      if (p.norm() <= 1 || rays == 1) out.push_back(p / 2);
    }
  }
  return out;
}

std::vector<RayHit> hits_of(const TurntableScene& scene, const TurntableScanOptions& options,
                            const std::vector<Vector2d>& places, const Vector3d& centre,
                            const Vector3d& ahead, const Vector3d& side, const Vector3d& up) {
  std::vector<RayHit> hits;
  for (const Vector2d& place : places) {
    const Vector3d off = place.x() * side + place.y() * up;
    const Vector3d origin = centre + options.spot_m * off;
    const Vector3d ray = (ahead + options.divergence_rad * off).normalized();
    const auto hit = scene.cast(origin, ray);
    if (hit.surface < 0 || hit.distance_m > options.farthest_m) continue;
    const Vector3d at = origin + hit.distance_m * ray;
    const double albedo = scene.albedo(hit.surface, at, Vector2d::Constant(1e-5));
    const double facing = std::abs(scene.normal(hit.surface).dot(ray));
    hits.push_back({hit.distance_m, albedo * facing, hit.surface < 2 && albedo < 0.45});
  }
  std::stable_sort(hits.begin(), hits.end(),
                   [](const auto& a, const auto& b) { return a.range_m < b.range_m; });
  return hits;
}

SpotEcho strongest_spot_echo(const std::vector<RayHit>& hits, double resolved_m) {
  SpotEcho best, echo;
  double last = 0;
  const auto close = [&] {
    if (echo.light > best.light) best = echo;
    echo = {};
  };
  for (const RayHit& hit : hits) {
    if (echo.light > 0 && hit.range_m > last + resolved_m) close();
    echo.light += hit.light;
    echo.range_m += hit.light * hit.range_m;
    echo.black += hit.black ? hit.light : 0;
    last = hit.range_m;
  }
  close();
  if (best.light > 0) {
    best.range_m /= best.light;
    best.black /= best.light;
  }
  return best;
}

/// A disc about 1.5 m before the lidar at the middle of its arc.
WorldDisc placed_disc(const TurntableWorld& world, RandomStream& random) {
  const double middle = (world.rig.first_turntable_rad + world.rig.last_turntable_rad) / 2;
  const Pose3 lidar = world.rig.pose(middle);
  const double beam = world.first_beam_rad + (world.beams - 1) / 2.0 * world.beam_step_rad +
                      random.uniform(-0.08, 0.08);
  const double range = random.uniform(1.47, 1.53);
  const double aside = random.uniform(-0.05, 0.05);
  const Vector3d at_lidar(range * std::cos(beam), range * std::sin(beam), aside);
  const Vector3d at = lidar * at_lidar;
  const Vector3d towards = (lidar.translation_m - at).normalized();
  const Vector3d any = towards.unitOrthogonal();
  const double way = random.uniform(0, 2 * kPi), tilt = radians(25) * std::sqrt(random.uniform());
  const Vector3d about = Eigen::AngleAxisd(way, towards) * any;
  const Eigen::Quaterniond facing = turn_z_to(towards);
  WorldDisc disc;
  disc.camera_from_disc = {Eigen::Quaterniond(Eigen::AngleAxisd(tilt, about)) * facing, at};
  return disc;
}

/// Whether the scan plane passes the disc within its radius and the clearance.
bool is_swept(const TurntableWorld& world, const WorldDisc& disc, double turned_rad) {
  const Pose3 lidar = world.rig.pose(turned_rad);
  const Vector3d normal = lidar.rotation * Vector3d::UnitZ();
  const double off = normal.dot(disc.camera_from_disc.translation_m - lidar.translation_m);
  return std::abs(off) <= disc.radius_m + kClearance_m;
}

/// Commanded angles, multiples of the step, whose scan planes meet the disc.
std::vector<double> arc_over(const TurntableWorld& world, const WorldDisc& disc) {
  const double middle = (world.rig.first_turntable_rad + world.rig.last_turntable_rad) / 2;
  std::vector<double> arc;
  const auto turns = static_cast<int>(kPi / 2 / kDiscStep_rad);
  const auto first = static_cast<int>(std::lround(middle / kDiscStep_rad));
  for (int k = -turns; k <= turns; ++k) {
    const double turn = (first + k) * kDiscStep_rad;
    if (is_swept(world, disc, turn)) arc.push_back(turn);
  }
  return arc;
}

}  // namespace

std::vector<BeamReturn> simulate_scan(const TurntableWorld& world, const TurntableScene& scene,
                                      const TurntableScanOptions& options, double turned_rad,
                                      std::uint64_t seed, std::uint64_t stream) {
  RandomStream random(seed, kScanStream + stream);
  const Pose3 lidar = world.rig.pose(turned_rad);
  const Eigen::Matrix3d R = lidar.rotation.toRotationMatrix();
  const auto places = spot(options.spot_rays);
  std::vector<BeamReturn> scan;
  scan.reserve(static_cast<std::size_t>(world.beams));
  for (int k = 0; k < world.beams; ++k) {
    BeamReturn beam;
    beam.angle_rad = world.first_beam_rad + k * world.beam_step_rad;
    const double c = std::cos(beam.angle_rad), s = std::sin(beam.angle_rad);
    const Vector3d ahead = c * R.col(0) + s * R.col(1), side = c * R.col(1) - s * R.col(0);
    const SpotEcho echo = strongest_spot_echo(
        hits_of(scene, options, places, lidar.translation_m, ahead, side, R.col(2)),
        options.resolved_m);
    const double noise = options.range_noise_m * random.normal();
    beam.range_m = std::numeric_limits<double>::quiet_NaN();
    if (echo.light > 0) {
      const double range =
          echo.range_m + options.range_bias_m + echo.black * options.square_bias_m + noise;
      const double step = options.range_step_m;
      beam.range_m = step > 0 ? std::round(range / step) * step : range;
      beam.intensity = echo.light / static_cast<double>(places.size());
    }
    scan.push_back(beam);
  }
  return scan;
}

std::vector<std::vector<BeamReturn>> simulate_scans(const TurntableWorld& world,
                                                    const TurntableScanOptions& options,
                                                    std::uint64_t seed,
                                                    const std::vector<double>& turned_rad,
                                                    int threads) {
  const TurntableScene scene(world);
  const auto& angles = turned_rad.empty() ? world.turntable_rad : turned_rad;
  std::vector<std::vector<BeamReturn>> scans(angles.size());
  parallel_for(angles.size(), threads, [&](std::size_t i) {
    scans[i] = simulate_scan(world, scene, options, angles[i], seed, i);
  });
  return scans;
}

std::vector<DiscSweep> simulate_disc_sweeps(const TurntableWorld& world,
                                            const TurntableScanOptions& options, int placements,
                                            std::uint64_t seed, int threads) {
  std::vector<DiscSweep> sweeps;
  for (int i = 0; i < placements; ++i) {
    const auto number = static_cast<std::uint64_t>(i);
    RandomStream random(seed, kDiscStream + number);
    DiscSweep sweep;
    sweep.disc = placed_disc(world, random);
    sweep.turntable_rad = arc_over(world, sweep.disc);
    sweep.scans.resize(sweep.turntable_rad.size());
    const TurntableScene scene(world, {}, &sweep.disc);
    parallel_for(sweep.scans.size(), threads, [&](std::size_t k) {
      sweep.scans[k] = simulate_scan(world, scene, options, sweep.turntable_rad[k], seed,
                                     (number + 1) * kMostScansOfADisc + k);
    });
    sweeps.push_back(std::move(sweep));
  }
  return sweeps;
}

}  // namespace scanfuse::simulate
