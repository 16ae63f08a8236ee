#include "scanfuse/triangulate/associate_tracks.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "scanfuse/associate/log_sums.hpp"
#include "scanfuse/core/parallel.hpp"
#include "scanfuse/estimate/consistency.hpp"
#include "scanfuse/triangulate/track_columns.hpp"

namespace scanfuse::triangulate {
namespace {

/// ln [r e^L / (1 - r + r e^L0)]
double weight_of(const PassiveTrack& track, double log_ratio, double log_missed) {
  return track.log_odds + log_ratio - associate::log_add(0, track.log_odds + log_missed);
}

void sort_starts(TrackChoice& choice) {
  std::ranges::sort(choice.starts, {}, &TrackChoice::Start::bearings);
}

/// Every track's columns; the first of each is the empty one.
std::vector<std::vector<TrackColumn>> columns_of_tracks(std::span<const LineOfSight> lines,
                                                        std::span<const PassiveTrack> tracks,
                                                        const PassiveScene& scene,
                                                        const ScenePrior& prior,
                                                        const PassiveTrackOptions& options,
                                                        int threads) {
  const auto sensors = lines_by_sensor(lines, scene);
  const std::array limits{estimate::chi_square_quantile(options.gate_probability, 1),
                          estimate::chi_square_quantile(options.gate_probability, 2)};
  std::vector<std::vector<TrackColumn>> columns(tracks.size());
  parallel_for(tracks.size(), threads, [&](std::size_t t) {
    columns[t] = columns_of_track(place_of(tracks[t].state), sensors, scene, prior, limits,
                                  options.columns_of_track);
  });
  return columns;
}

/// Where a column of the packing that a track made came from.
struct Origin {
  std::size_t track = 0;
  std::size_t column = 0;
};

/// Candidates' columns first, then the tracks'; rows: bearings, then tracks, which are a set of
/// their own.
std::vector<Origin> add_tracks(associate::Packing& packing,
                               std::span<const std::vector<TrackColumn>> columns,
                               std::span<const PassiveTrack> tracks, std::int32_t set) {
  std::vector<Origin> origins;
  std::vector<std::int32_t> rows;
  for (std::size_t t = 0; t < tracks.size(); ++t) {
    const auto row = static_cast<std::int32_t>(packing.rows());
    packing.set_of_row.push_back(set);
    const double missed = columns[t].front().log_ratio;
    for (std::size_t k = 1; k < columns[t].size(); ++k) {
      const double weight = weight_of(tracks[t], columns[t][k].log_ratio, missed);
      if (!(weight > 0)) continue;
      rows = columns[t][k].bearings;
      rows.push_back(row);
      packing.add(rows, weight);
      origins.push_back({t, k});
    }
  }
  return origins;
}

Result<TrackChoice> jointly(const BearingScan& scan, std::span<const LineOfSight> lines,
                            std::span<const PassiveTrack> tracks, const PassiveScene& scene,
                            const ScenePrior& prior, const PassiveTrackOptions& options,
                            const AssociationOptions& association, int threads) {
  const auto columns = columns_of_tracks(lines, tracks, scene, prior, options, threads);
  auto fresh = weigh_hypotheses(scan, scene, prior, association, threads);
  if (!fresh) return tl::unexpected(fresh.error());
  associate::Packing& packing = fresh->packing;
  const std::size_t first = packing.columns();
  const auto origins =
      add_tracks(packing, columns, tracks, static_cast<std::int32_t>(scene.sensors.size()));
  const auto solution = solve(packing, association, threads);
  if (!solution) return tl::unexpected(solution.error());
  TrackChoice choice;
  choice.gap = associate::relative_gap(solution->primal, bound_on_all(*fresh, *solution));
  choice.bearings_of_track.resize(tracks.size());
  for (const auto& own : columns) choice.log_ratio.push_back(own.front().log_ratio);
  for (const std::int32_t chosen : solution->chosen) {
    const auto k = static_cast<std::size_t>(chosen);
    if (k < first) {
      const auto rows = packing.column(k);
      choice.starts.push_back({{rows.begin(), rows.end()}, packing.weights[k]});
      continue;
    }
    const Origin& origin = origins[k - first];
    const TrackColumn& column = columns[origin.track][origin.column];
    choice.bearings_of_track[origin.track] = column.bearings;
    choice.log_ratio[origin.track] = column.log_ratio;
  }
  sort_starts(choice);
  return choice;
}

/// ln of the chance that a target there has no fix: fewer than two of the sensors that looked saw
/// it.
double log_without_fix(const Eigen::Vector3d& place_m, const PassiveScene& scene,
                       const ScenePrior& prior) {
  AtMostOne seen;
  for (std::size_t s = 0; s < scene.sensors.size(); ++s) {
    const double missed = std::exp(prior.sensors[s].log_missed);  // 1 where it did not look
    if (in_field_of_view(scene.sensors[s], place_m)) seen.add(1 - missed);
  }
  return std::log(seen.probability());
}

/// A fix as a track's: its evidence with the place that the track predicts for the even intensity.
std::optional<double> log_ratio(const Fix& fix, const Gaussian<3>& place, double log_intensity,
                                double gate) {
  const Eigen::Vector3d off = fix.position_m - place.mean;
  const Eigen::Matrix3d spread = fix.covariance_m2 + place.covariance;
  const double distance = off.dot(spread.ldlt().solve(off));
  if (!(distance <= gate)) return std::nullopt;
  return fix.weight - log_intensity -
         (3 * std::log(2 * kPi) + std::log(spread.determinant()) + distance) / 2;
}

Result<TrackChoice> fixes_first(const BearingScan& scan, std::span<const PassiveTrack> tracks,
                                const PassiveScene& scene, const ScenePrior& prior,
                                const PassiveTrackOptions& options, AssociationOptions association,
                                int threads) {
  association.posterior = false;
  const auto found = associate_scan(scan, scene, association, threads);
  if (!found) return tl::unexpected(found.error());
  // A scene of no targets has fixes of no weight: then there are none.
  const double even = found->prior.prior.log_intensity, fresh = prior.log_intensity - even;
  const double gate = estimate::chi_square_quantile(options.gate_probability, 3);
  TrackChoice choice;
  choice.gap = found->gap();
  choice.bearings_of_track.resize(tracks.size());
  associate::Packing packing;
  packing.set_of_row.assign(found->fixes.size(), 0);
  std::vector<double> ratios;
  for (std::size_t t = 0; t < tracks.size(); ++t) {
    const Gaussian<3> place = place_of(tracks[t].state);
    choice.log_ratio.push_back(log_without_fix(place.mean, scene, prior));
    packing.set_of_row.push_back(1);
    for (std::size_t f = 0; f < found->fixes.size(); ++f) {
      const auto ratio = log_ratio(found->fixes[f], place, even, gate);
      if (!ratio) continue;
      const std::array rows{static_cast<std::int32_t>(f),
                            static_cast<std::int32_t>(packing.rows() - 1)};
      packing.add(rows, weight_of(tracks[t], *ratio, choice.log_ratio[t]) -
                            std::max(found->fixes[f].weight + fresh, 0.0));
      ratios.push_back(*ratio);
    }
  }
  const auto solution = solve(packing, association, threads);
  if (!solution) return tl::unexpected(solution.error());
  std::vector<bool> used(found->fixes.size(), false);
  for (const std::int32_t chosen : solution->chosen) {
    const auto k = static_cast<std::size_t>(chosen);
    const auto f = static_cast<std::size_t>(packing.column(k)[0]);
    const auto t = static_cast<std::size_t>(packing.column(k)[1]) - used.size();
    used[f] = true;
    choice.bearings_of_track[t] = found->fixes[f].bearings;
    choice.log_ratio[t] = ratios[k];
  }
  for (std::size_t f = 0; f < used.size(); ++f) {
    const double weight = found->fixes[f].weight + fresh;
    if (!used[f] && weight > 0) choice.starts.push_back({found->fixes[f].bearings, weight});
  }
  return choice;
}

}  // namespace

double PassiveTrack::existence_probability() const { return 1 / (1 + std::exp(-log_odds)); }

Result<TrackChoice> associate_tracks(const BearingScan& scan, std::span<const LineOfSight> lines,
                                     std::span<const PassiveTrack> tracks,
                                     const PassiveScene& scene, const ScenePrior& prior,
                                     const PassiveTrackOptions& options,
                                     const AssociationOptions& association, int threads) {
  if (options.association == TrackAssociation::kFixesFirst) {
    return fixes_first(scan, tracks, scene, prior, options, association, threads);
  }
  return jointly(scan, lines, tracks, scene, prior, options, association, threads);
}

}  // namespace scanfuse::triangulate
