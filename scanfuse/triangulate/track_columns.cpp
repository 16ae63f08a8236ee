#include "scanfuse/triangulate/track_columns.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "scanfuse/estimate/kalman.hpp"

namespace scanfuse::triangulate {
namespace {

constexpr std::size_t kMostRows = 64;  // of a column of a packing, the track's among them

struct Growing {
  TrackColumn column;
  Gaussian<3> place;
};

/// The place with one more bearing, and what the bearing weighs.
struct Taken {
  Gaussian<3> place;
  double nis = 0;
  double log_likelihood = 0;
};

template <int M>
Taken take(const Gaussian<3>& place, const Sight& seen, const LineOfSight& line) {
  const Eigen::Matrix<double, M, 3> H = seen.jacobian_rad_per_m.topRows<M>();
  Eigen::Matrix<double, M, M> R = Eigen::Matrix<double, M, M>::Zero();
  R(0, 0) = line.sigma_left_rad * line.sigma_left_rad;
  if constexpr (M == 2) R(1, 1) = line.sigma_up_rad * line.sigma_up_rad;
  const estimate::Innovation<M> nu{-seen.offset_rad.head<M>(),
                                   H * place.covariance * H.transpose() + R};
  return {estimate::correct<3, M>(place, nu, R, H), nu.nis(), nu.log_likelihood()};
}

/// Everything about a scan that growing looks at.
struct Gates {
  const PassiveScene& scene;
  const ScenePrior& prior;
  const std::array<double, 2>& limits;  ///< chi-square quantile, 1 and 2 degrees of freedom
};

void grow(const Growing& from, const LinesOfSensor& sensor, const Gates& gates,
          std::vector<Growing>& out) {
  if (from.column.bearings.size() + 1 >= kMostRows) return;
  const LineOfSight& any = sensor.lines.front();
  const SensorPrior& prior = gates.prior.sensors[static_cast<std::size_t>(any.sensor)];
  const double range = (from.place.mean - any.origin_m).norm();
  const double blur = std::sqrt(from.place.covariance.trace()) / std::max(range, 1e-6);
  const double reach = std::sqrt(gates.limits[1]) * (sensor.widest_rad + blur);
  sensor.by_azimuth.for_near(from.place.mean, reach, [&](std::int32_t j) {
    const LineOfSight& line = sensor.lines[static_cast<std::size_t>(j)];
    const auto seen = sight(line, from.place.mean);
    if (!seen) return;
    const Taken taken = line.tells_elevation() ? take<2>(from.place, *seen, line)
                                               : take<1>(from.place, *seen, line);
    if (!(taken.nis <= gates.limits[static_cast<std::size_t>(line.dimensions() - 1)])) return;
    Growing next{from.column, taken.place};
    next.column.bearings.push_back(sensor.places[static_cast<std::size_t>(j)]);
    next.column.log_ratio += prior.log_detected - prior.log_clutter + taken.log_likelihood;
    out.push_back(std::move(next));
  });
}

}  // namespace

std::vector<TrackColumn> columns_of_track(const Gaussian<3>& place_m,
                                          std::span<const LinesOfSensor> sensors,
                                          const PassiveScene& scene, const ScenePrior& prior,
                                          const std::array<double, 2>& limits, int most) {
  const Gates gates{scene, prior, limits};
  std::vector<Growing> growing{{{}, place_m}}, next;
  for (std::size_t s = 0; s < sensors.size(); ++s) {
    if (sensors[s].lines.empty()) continue;
    const bool looks = in_field_of_view(scene.sensors[s], place_m.mean);
    next.clear();
    for (const Growing& from : growing) {
      next.push_back(from);
      if (looks) next.back().column.log_ratio += prior.sensors[s].log_missed;
    }
    for (const Growing& from : growing) grow(from, sensors[s], gates, next);
    if (std::ssize(next) > most) {
      std::stable_sort(next.begin() + 1, next.end(), [](const Growing& a, const Growing& b) {
        return a.column.log_ratio > b.column.log_ratio;
      });
      next.erase(next.begin() + most, next.end());
    }
    growing.swap(next);
  }
  std::vector<TrackColumn> columns;
  columns.reserve(growing.size());
  for (Growing& g : growing) columns.push_back(std::move(g.column));
  return columns;
}

}  // namespace scanfuse::triangulate
