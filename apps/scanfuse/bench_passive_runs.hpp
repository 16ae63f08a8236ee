#pragma once

#include <vector>

#include "bench_rows.hpp"
#include "scanfuse/evaluate/association_score.hpp"
#include "scanfuse/simulate/passive.hpp"
#include "scanfuse/triangulate/associate_scan.hpp"

namespace scanfuse::app {

/// What many scenes of one kind give.
struct PassiveOutcome {
  evaluate::AssociationScore score;
  std::int64_t unproved = 0;
  double worst_gap = 0;
  std::vector<double> seconds, solver_seconds, columns;  ///< of each scene
  std::int64_t sure = 0, sure_and_right = 0;             ///< bearings told with 0.9 or more
  std::vector<associate::Packing> packings;              ///< kept where asked for
};

/// What `run_passive` does besides association.
struct PassiveRunOptions {
  bool posterior = false;
  bool keep_packings = false;
  double time_limit_s = triangulate::AssociationOptions{}.time_limit_s;  ///< of the solver
};

/// The first scan of each seed's scene, associated.
[[nodiscard]] PassiveOutcome run_passive(const simulate::PassiveOptions& options,
                                         const SeedRange& seeds, int threads,
                                         triangulate::CostMethod cost,
                                         const PassiveRunOptions& run = {});

/// Share of targets whose bearings all go to them when their places are known: no cost does better.
[[nodiscard]] double passive_oracle_rate(const simulate::PassiveOptions& options,
                                         const SeedRange& seeds);

/// 20 targets and three sensors anywhere in 40 x 40 x 11 km, 5 false alarms a sensor.
[[nodiscard]] simulate::PassiveOptions passive_crowd(double detection_probability,
                                                     double noise_rad);

/// Four cameras around 200 to 5000 points.
void add_passive_cameras(std::vector<BenchRow>& rows, std::uint64_t seed, int threads);

/// The default solver on the paper's scenes and on crowds, a greedy choice beside it.
void add_passive_solver(std::vector<BenchRow>& rows, std::uint64_t seed);

/// Time and hypotheses of a scan of 2 to 64 sensors.
void add_many_sensors(std::vector<BenchRow>& rows, std::uint64_t seed);

/// Targets followed by bearings: MOTA, switches, errors against their covariance.
void add_passive_tracks(std::vector<BenchRow>& rows, const SeedRange& seeds, int threads);

}  // namespace scanfuse::app
