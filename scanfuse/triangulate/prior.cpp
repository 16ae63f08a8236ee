#include "scanfuse/triangulate/prior.hpp"

#include <algorithm>
#include <cmath>

#include "scanfuse/triangulate/closest_points.hpp"

namespace scanfuse::triangulate {
namespace {

constexpr double kMostCertain = 0.9999, kLeastCertain = 1e-4;
constexpr std::size_t kSampledLines = 300;
constexpr double kSampledPairs = 4e6;  ///< of all sensors
constexpr double kCloseSigmas = 4;

SensorPrior sensor_prior(const PassiveSensor& sensor) {
  const double detected = std::clamp(sensor.detection_probability, kLeastCertain, kMostCertain);
  const double clutter = std::max(sensor.clutter_density, kLeastCertain / sensor.field_of_view());
  return {std::log(detected), std::log1p(-detected), std::log(clutter)};
}

/// Lines of each sensor, evenly thinned.
std::vector<std::vector<LineOfSight>> sampled_lines(const PassiveScene& scene,
                                                    const BearingScan& scan) {
  std::vector<std::vector<LineOfSight>> lines(scene.sensors.size());
  std::vector<std::size_t> counts(scene.sensors.size(), 0), seen(scene.sensors.size(), 0);
  for (const Bearing& b : scan.bearings) ++counts[static_cast<std::size_t>(b.sensor)];
  const auto n = static_cast<double>(counts.size());
  const double each = std::sqrt(kSampledPairs / std::max(n * (n - 1) / 2, 1.0));
  const std::size_t most = std::min(kSampledLines, static_cast<std::size_t>(each));
  for (const Bearing& b : scan.bearings) {
    const auto s = static_cast<std::size_t>(b.sensor);
    const std::size_t step = counts[s] / most + 1;
    if (seen[s]++ % step == 0) lines[s].push_back(line_of_sight(scene.sensors[s], b));
  }
  return lines;
}

std::vector<Eigen::Vector3d> meeting_points(const std::vector<std::vector<LineOfSight>>& lines) {
  std::vector<Eigen::Vector3d> points;
  for (std::size_t a = 0; a < lines.size(); ++a) {
    for (std::size_t b = a + 1; b < lines.size(); ++b) {
      for (const LineOfSight& one : lines[a]) {
        for (const LineOfSight& other : lines[b]) {
          const auto met = closest_points(one, other);
          if (met && met->sigmas_apart < kCloseSigmas) points.push_back(met->middle_m);
        }
      }
    }
  }
  return points;
}

PassiveScene::Volume volume_of(std::vector<Eigen::Vector3d> points, const PassiveScene& scene) {
  constexpr double kLow = 0.05, kHigh = 0.95, kWider = 0.25, kLeast_m = 1;
  if (points.empty()) {
    for (const auto& sensor : scene.sensors) {
      points.push_back(sensor.world_from_sensor.translation_m);
    }
  }
  PassiveScene::Volume volume{};
  for (int k = 0; k < 3; ++k) {
    std::vector<double> values;
    values.reserve(points.size());
    for (const auto& p : points) values.push_back(p[k]);
    std::sort(values.begin(), values.end());
    const auto at = [&](double share) {
      return values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1))];
    };
    const double low = at(kLow), high = at(kHigh);
    const double margin = std::max(kWider * (high - low), kLeast_m);
    volume[static_cast<std::size_t>(k)] = {low - margin, high + margin};
  }
  return volume;
}

double expected_targets(const PassiveScene& scene, const BearingScan& scan) {
  std::vector<double> counts(scene.sensors.size(), 0);
  for (const Bearing& b : scan.bearings) counts[static_cast<std::size_t>(b.sensor)] += 1;
  for (std::size_t s = 0; s < counts.size(); ++s) {
    const PassiveSensor& sensor = scene.sensors[s];
    counts[s] = (counts[s] - sensor.clutter_density * sensor.field_of_view()) /
                std::max(sensor.detection_probability, 0.05);
  }
  if (counts.empty()) return 1;
  const auto middle = counts.begin() + static_cast<std::ptrdiff_t>(counts.size() / 2);
  std::nth_element(counts.begin(), middle, counts.end());
  return std::max(*middle, 1.0);
}

}  // namespace

EstimatedPrior scene_prior(const PassiveScene& scene, const BearingScan& scan) {
  EstimatedPrior result;
  ScenePrior& prior = result.prior;
  prior.flat = true;
  for (const PassiveSensor& sensor : scene.sensors) {
    prior.sensors.push_back(sensor_prior(sensor));
    prior.flat = prior.flat && !sensor.tells_elevation();
  }
  result.volume_estimated = !scene.volume_m;
  result.targets_estimated = !scene.expected_targets;
  prior.volume_m = scene.volume_m ? *scene.volume_m
                                  : volume_of(meeting_points(sampled_lines(scene, scan)), scene);
  double volume = 1;
  for (const auto& [low, high] : prior.volume_m) volume *= high - low;
  const double targets =
      scene.expected_targets ? *scene.expected_targets : expected_targets(scene, scan);
  prior.log_intensity = std::log(targets / volume);
  const auto& [floor, ceiling] = prior.volume_m[2];
  constexpr double kOpen_m2 = 1e18;
  prior.place.mean = Eigen::Vector3d(0, 0, (floor + ceiling) / 2);
  prior.place.covariance =
      Eigen::Vector3d(kOpen_m2, kOpen_m2, (ceiling - floor) * (ceiling - floor) / 12).asDiagonal();
  return result;
}

}  // namespace scanfuse::triangulate
