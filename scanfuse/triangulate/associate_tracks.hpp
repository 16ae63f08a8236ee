#pragma once

#include <span>
#include <vector>

#include "scanfuse/triangulate/associate_scan.hpp"
#include "scanfuse/triangulate/point_filter.hpp"

namespace scanfuse::triangulate {

/// `joint`: what tracks predict and what bearings say alone are weighed together, one packing a
/// scan. `fixes_first`: a scan is associated as if there were no tracks; its fixes are then given
/// to tracks, and a bearing in no fix is lost.
enum class TrackAssociation { kJoint, kFixesFirst };

constexpr auto choices(TrackAssociation) {
  using enum TrackAssociation;
  return std::array{std::pair{"joint", kJoint}, std::pair{"fixes_first", kFixesFirst}};
}

struct PassiveTrackOptions {
  PointUpdateMethod update = PointUpdateMethod::kEkf;
  TrackAssociation association = TrackAssociation::kJoint;
  double sigma_accel = 2;
  double sigma_accel_z = 1;
  double start_speed_m_per_s = 200;
  double start_climb_m_per_s = 50;
  double gate_probability = 0.9999;
  int columns_of_track = 200;
  double new_targets_per_s = 0.1;
  double life_s = 1000;
  double confirm_probability = 0.99;
  int confirm_scans = 3;
  double coast_s = 5;
  double drop_probability = 1e-4;
  bool estimate_bias = false;
  double bias_sigma_rad = 0.02;

  static constexpr auto fields() {
    using O = PassiveTrackOptions;
    return std::tuple{
        Field{"update", &O::update, "how bearings move a track"},
        Field{"association", &O::association, "what tracks have to say in the association"},
        Field{"sigma_accel", &O::sigma_accel, 0.0, 1e4,
              "standard deviation, in m/s, that level velocity gains in one second"},
        Field{"sigma_accel_z", &O::sigma_accel_z, 0.0, 1e4, "the same of climbing"},
        Field{"start_speed_m_per_s", &O::start_speed_m_per_s, 1e-6, 1e5,
              "standard deviation of a new track's level velocity, each axis"},
        Field{"start_climb_m_per_s", &O::start_climb_m_per_s, 1e-6, 1e5, "the same of climbing"},
        Field{"gate_probability", &O::gate_probability, 0.5, 0.99999999,
              "a track's bearing is within its gate with this probability"},
        Field{"columns_of_track", &O::columns_of_track, 2, 1000000,
              "hypotheses of one track in a scan, the heaviest"},
        Field{"new_targets_per_s", &O::new_targets_per_s, 1e-9, 1e6,
              "that come into the volume, on average"},
        Field{"life_s", &O::life_s, 1e-3, 1e9, "how long a target stays, on average"},
        Field{"confirm_probability", &O::confirm_probability, 0.5, 0.999999,
              "a track is confirmed when it exists so probably"},
        Field{"confirm_scans", &O::confirm_scans, 1, 100, "and was seen in so many scans"},
        Field{"coast_s", &O::coast_s, 0.0, 1e6, "a track unseen for longer ends"},
        Field{"drop_probability", &O::drop_probability, 1e-12, 0.5,
              "a track that exists less probably ends"},
        Field{"estimate_bias", &O::estimate_bias, "estimate each sensor's constant offset"},
        Field{"bias_sigma_rad", &O::bias_sigma_rad, 1e-9, 1.0,
              "standard deviation of offsets before the first bearing"}};
  }
};

/// A target over time, as it is after a scan.
struct PassiveTrack {
  std::int64_t id = 0;  ///< never used again
  Gaussian<6> state;    ///< x, y, z, vx, vy, vz, world frame
  double log_odds = 0;  ///< ln(p / (1 - p)) of its existence
  bool confirmed = false;
  int scans_seen = 0;
  int age_scans = 0;
  int missed_scans = 0;  ///< in a row
  Time last_seen;
  std::vector<std::int32_t> bearings;  ///< of this scan, places in BearingScan::bearings
  [[nodiscard]] double existence_probability() const;
};

/// What a scan's bearings were given to.
struct TrackChoice {
  struct Start {
    std::vector<std::int32_t> bearings;  ///< places in the scan
    double weight = 0;                   ///< log odds that it is a target
  };
  std::vector<std::vector<std::int32_t>> bearings_of_track;  ///< empty: missed
  std::vector<double> log_ratio;                             ///< by track: TrackColumn::log_ratio
  std::vector<Start> starts;  ///< new targets, ordered by their first bearing
  double gap = 0;             ///< (dual - primal) / dual of the packing
};

/// One scan given to predicted tracks and new targets, as `options.association` says. `prior` holds
/// the intensity of targets without a track. An error where there are more hypotheses than allowed.
[[nodiscard]] Result<TrackChoice> associate_tracks(
    const BearingScan& scan, std::span<const LineOfSight> lines,
    std::span<const PassiveTrack> tracks, const PassiveScene& scene, const ScenePrior& prior,
    const PassiveTrackOptions& options, const AssociationOptions& association, int threads);

}  // namespace scanfuse::triangulate
