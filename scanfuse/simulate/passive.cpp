#include "scanfuse/simulate/passive.hpp"

#include <algorithm>
#include <cmath>

#include "scanfuse/core/random.hpp"

namespace scanfuse::simulate {
namespace {

enum Stream : std::uint64_t { kSensors = 1, kTargets = 2, kScans = 1000 };
constexpr PassiveScene::Volume kWide{{{0, 40e3}, {0, 40e3}, {0, 11e3}}};
constexpr PassiveScene::Volume kCube{{{-0.05, 0.05}, {-0.05, 0.05}, {-0.05, 0.05}}};
constexpr double kCameraRange_m = 0.5, kCameraField_rad = 0.4;

Eigen::Vector3d anywhere(const PassiveScene::Volume& volume, RandomStream& random) {
  Eigen::Vector3d p;
  for (int k = 0; k < 3; ++k) {
    const auto& [low, high] = volume[static_cast<std::size_t>(k)];
    p[k] = random.uniform(low, high);
  }
  return p;
}

/// x axis towards `at`, y level.
Eigen::Quaterniond looking(const Eigen::Vector3d& from, const Eigen::Vector3d& at) {
  const Eigen::Vector3d d = at - from;
  return Eigen::AngleAxisd(std::atan2(d.y(), d.x()), Eigen::Vector3d::UnitZ()) *
         Eigen::AngleAxisd(-std::atan2(d.z(), std::hypot(d.x(), d.y())), Eigen::Vector3d::UnitY());
}

Result<std::vector<Eigen::Vector3d>> places(const PassiveOptions& options, RandomStream& random) {
  if (options.sensor_layout == SensorLayout::kPaper) {
    return std::vector<Eigen::Vector3d>{{30e3, 0, 100}, {0, 30e3, 100}, {0, 0, 0}};
  }
  const bool cameras = options.sensor_layout == SensorLayout::kCameras;
  const double apart = cameras ? 0.1 : 3e3;
  std::vector<Eigen::Vector3d> found;
  for (int tries = 0; std::ssize(found) < options.sensors; ++tries) {
    if (tries > 100000) {
      return fail(Error::Code::kOutOfRange, "{} sensors cannot stand {} m apart", options.sensors,
                  apart);
    }
    Eigen::Vector3d p = anywhere(kWide, random);
    p.z() = 0;
    if (cameras) {
      const double azimuth = random.uniform(-kPi, kPi), elevation = random.uniform(-0.6, 0.6);
      p = kCameraRange_m * Eigen::Vector3d(std::cos(azimuth) * std::cos(elevation),
                                           std::sin(azimuth) * std::cos(elevation),
                                           std::sin(elevation));
    }
    const bool free = std::ranges::all_of(
        found, [&](const Eigen::Vector3d& other) { return (p - other).norm() >= apart; });
    if (free) found.push_back(p);
  }
  return found;
}

/// Wide enough for a line or a grid of targets too.
PassiveScene::Volume volume_of(const PassiveOptions& options) {
  if (options.sensor_layout == SensorLayout::kCameras) return kCube;
  PassiveScene::Volume volume = kWide;
  if (options.target_layout == TargetLayout::kLine) {
    volume[0][1] = std::max(volume[0][1], 20e3 + options.targets * options.spacing_m);
  } else if (options.target_layout == TargetLayout::kGrid) {
    const double half_m = std::ceil(std::sqrt(options.targets)) * options.spacing_m / 2;
    for (std::size_t k = 0; k < 2; ++k) {
      volume[k] = {std::min(volume[k][0], 20e3 - half_m), std::max(volume[k][1], 20e3 + half_m)};
    }
  }
  return volume;
}

Result<PassiveScene> make_scene(const PassiveOptions& options, RandomStream& random) {
  const auto positions = places(options, random);
  if (!positions) return tl::unexpected(positions.error());
  const bool cameras = options.sensor_layout == SensorLayout::kCameras;
  PassiveScene scene;
  scene.volume_m = volume_of(options);
  if (options.targets > 0) scene.expected_targets = options.targets;
  double noise = options.noise_rad;
  for (const Eigen::Vector3d& p : *positions) {
    PassiveSensor sensor;
    sensor.name = fmt::format("{}{}", cameras ? "camera" : "sensor", scene.sensors.size() + 1);
    sensor.world_from_sensor.translation_m = p;
    sensor.sigma_azimuth_rad = noise;
    if (!options.azimuth_only) sensor.sigma_elevation_rad = noise;
    sensor.detection_probability = options.detection_probability;
    sensor.field_of_view_elevation_rad = options.field_of_view_elevation_rad;
    if (cameras) {
      sensor.world_from_sensor.rotation = looking(p, Eigen::Vector3d::Zero());
      sensor.field_of_view_azimuth_rad = sensor.field_of_view_elevation_rad = kCameraField_rad;
    }
    sensor.clutter_density = options.false_alarms / sensor.field_of_view();
    scene.sensors.push_back(std::move(sensor));
    noise *= options.noise_ratio;
  }
  return scene;
}

std::vector<PassiveTarget> make_targets(const PassiveOptions& options,
                                        const PassiveScene::Volume& volume, RandomStream& random) {
  const int side = static_cast<int>(std::ceil(std::sqrt(options.targets)));
  std::vector<PassiveTarget> targets(static_cast<std::size_t>(options.targets));
  for (int k = 0; k < options.targets; ++k) {
    PassiveTarget& target = targets[static_cast<std::size_t>(k)];
    target.position_m = Eigen::Vector3d(20e3, 20e3, 8e3);
    if (options.target_layout == TargetLayout::kLine) {
      target.position_m.x() += k * options.spacing_m;
    } else if (options.target_layout == TargetLayout::kGrid) {
      const int row = k / side, column = k % side;
      target.position_m.x() += (column - (side - 1) / 2.0) * options.spacing_m;
      target.position_m.y() += (row - (side - 1) / 2.0) * options.spacing_m;
    } else if (options.target_layout == TargetLayout::kRandom || k == 0) {
      target.position_m = anywhere(volume, random);
    } else {
      const double towards = random.uniform(-kPi, kPi);
      target.position_m =
          targets[static_cast<std::size_t>(k) - 1].position_m +
          options.spacing_m * Eigen::Vector3d(std::cos(towards), std::sin(towards), 0);
    }
    const double course = random.uniform(-kPi, kPi);
    target.velocity_m_per_s =
        options.speed_m_per_s * Eigen::Vector3d(std::cos(course), std::sin(course), 0);
  }
  return targets;
}

/// Azimuth and elevation in the sensor's frame.
std::pair<double, double> angles_of(const PassiveSensor& sensor, const Eigen::Vector3d& point) {
  const Eigen::Vector3d p = sensor.world_from_sensor.inverse() * point;
  return {std::atan2(p.y(), p.x()), std::atan2(p.z(), std::hypot(p.x(), p.y()))};
}

/// Knuth's method in pieces, so that the exponential does not vanish.
int poisson(double mean, RandomStream& random) {
  int count = 0;
  for (; mean > 0; mean -= 30) {
    const double limit = std::exp(-std::min(mean, 30.0));
    for (double product = random.uniform(); product > limit; product *= random.uniform()) ++count;
  }
  return count;
}

/// What one sensor tells of a scan.
void see(const PassiveSensor& sensor, std::int32_t index, const std::vector<PassiveTarget>& targets,
         const PassiveOptions& options, RandomStream& random, std::vector<Bearing>& out) {
  const double bias = index == 0 ? options.azimuth_bias_rad : 0;
  std::vector<Bearing> seen;
  for (std::size_t t = 0; t < targets.size(); ++t) {
    const auto [azimuth, elevation] = angles_of(sensor, targets[t].position_m);
    const double da = random.normal(), de = random.normal();
    const bool inside = std::abs(azimuth) <= sensor.field_of_view_azimuth_rad / 2 &&
                        std::abs(elevation) <= sensor.field_of_view_elevation_rad / 2;
    if (!random.chance(sensor.detection_probability) || !inside) continue;
    Bearing b;
    b.azimuth_rad = wrap_pi(azimuth + sensor.sigma_azimuth_rad * da + bias);
    if (sensor.tells_elevation()) {
      b.elevation_rad = std::clamp(elevation + *sensor.sigma_elevation_rad * de, -kPi / 2, kPi / 2);
    }
    b.truth = static_cast<std::int64_t>(t);
    seen.push_back(b);
  }
  const double sine = std::sin(sensor.field_of_view_elevation_rad / 2);
  for (int k = poisson(options.false_alarms, random); k > 0; --k) {
    Bearing b;
    b.azimuth_rad = random.uniform(-0.5, 0.5) * sensor.field_of_view_azimuth_rad;
    const double height = random.uniform(-sine, sine);
    if (sensor.tells_elevation()) b.elevation_rad = std::asin(height);
    b.truth = -1;
    seen.push_back(b);
  }
  for (std::size_t k = seen.size(); k > 1; --k) std::swap(seen[k - 1], seen[random.below(k)]);
  for (std::size_t k = 0; k < seen.size(); ++k) {
    seen[k].sensor = index;
    seen[k].measurement = static_cast<std::int64_t>(k);
    out.push_back(seen[k]);
  }
}

}  // namespace

Result<PassiveRecording> simulate_passive(const PassiveOptions& options, std::uint64_t seed) {
  RandomStream sensors(seed, kSensors), places(seed, kTargets);
  auto scene = make_scene(options, sensors);
  if (!scene) return tl::unexpected(scene.error());
  PassiveRecording recording{std::move(*scene), {}, {}};
  auto targets = make_targets(options, *recording.scene.volume_m, places);
  for (int k = 0; k < options.scans; ++k) {
    RandomStream random(seed, kScans + static_cast<std::uint64_t>(k));
    BearingScan scan;
    scan.scan = k;
    scan.stamp = time_from_seconds(k * options.interval_s);
    for (std::size_t s = 0; s < recording.scene.sensors.size(); ++s) {
      see(recording.scene.sensors[s], static_cast<std::int32_t>(s), targets, options, random,
          scan.bearings);
    }
    recording.scans.push_back(std::move(scan));
    recording.targets.push_back(targets);
    for (PassiveTarget& target : targets) {
      target.position_m += options.interval_s * target.velocity_m_per_s;
    }
  }
  return recording;
}

}  // namespace scanfuse::simulate
