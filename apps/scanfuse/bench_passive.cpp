#include <fmt/format.h>

#include <Eigen/LU>
#include <algorithm>

#include "bench_passive_runs.hpp"

namespace scanfuse::app {
namespace {

using simulate::PassiveOptions;
using triangulate::CostMethod;

PassiveOptions two_targets(double noise_rad) {
  PassiveOptions options;
  options.targets = 2;
  options.spacing_m = 500;
  options.noise_rad = noise_rad;
  return options;
}

PassiveOptions unequal(PassiveOptions options) {
  options.noise_rad = 0.001;
  options.noise_ratio = std::sqrt(20);  // 1, 4.5 and 20 mrad
  return options;
}

void add_pairs(std::vector<BenchRow>& rows, const SeedRange& seeds, int threads) {
  PassiveOptions apart = unequal(two_targets(0.001));
  apart.sensor_layout = simulate::SensorLayout::kRandom;
  apart.target_layout = simulate::TargetLayout::kCluster;
  const std::tuple<const char*, PassiveOptions, double> scenes[] = {
      {"two targets 0.5 km apart, 5 mrad", two_targets(0.005), 0.776},
      {"two targets 0.5 km apart, 10 mrad", two_targets(0.01), 0.435},
      {"two targets 0.5 km apart, 1 to 20 mrad", apart, 0.565}};
  for (const auto& [name, options, reached] : scenes) {
    for (const auto& [cost, method] : choices(CostMethod{})) {
      const auto outcome = run_passive(options, seeds, threads, method);
      const Target target =
          method == CostMethod::kEvidence && reached == 0.565 ? at_least(reached) : Target{};
      rows.push_back({fmt::format("{}: {}", name, cost), outcome.score.exact_rate(), "exact",
                      target, reached == 0.565 ? std::nullopt : std::optional(reached)});
    }
    rows.push_back(
        {fmt::format("{}: places known", name), passive_oracle_rate(options, seeds), "exact", {}});
  }
}

void add_crowds(std::vector<BenchRow>& rows, const SeedRange& seeds, int threads) {
  PassiveOptions narrow = passive_crowd(0.9, 0.005);
  narrow.field_of_view_elevation_rad = radians(60);
  const std::tuple<const char*, PassiveOptions, double> scenes[] = {
      {"20 targets, PD 0.9, 5 false alarms, 5 mrad", passive_crowd(0.9, 0.005), 0.91},
      {"the same, false alarms within 30 deg of the horizon", narrow, 0.91},
      {"the same, PD 0.7", passive_crowd(0.7, 0.005), 0.84},
      {"the same, 10 mrad", passive_crowd(0.9, 0.01), 0.81},
      {"the same, 1 to 20 mrad", unequal(passive_crowd(0.9, 0.001)), 0.69}};
  for (const auto& [name, options, f1] : scenes) {
    const auto best =
        run_passive(options, seeds, threads, CostMethod::kEvidence, {.posterior = true});
    const bool first = f1 == 0.91;
    rows.push_back({fmt::format("{}: F1", name), best.score.f1(), "", at_least(f1)});
    rows.push_back({fmt::format("{}: ghosts", name), best.score.ghosts_per_scene(), "a scene",
                    first ? at_most(1.4) : Target{}});
    // Where sensors cannot see all of the volume, OSPA counts what nobody could find.
    const bool all_in_sight = options.field_of_view_elevation_rad >= kPi;
    rows.push_back({fmt::format("{}: OSPA", name), best.score.ospa_m() / 1e3, "km",
                    first && all_in_sight ? at_most(0.37) : Target{}});
    rows.push_back({fmt::format("{}: right of what is told with 0.9", name),
                    static_cast<double>(best.sure_and_right) / static_cast<double>(best.sure), "",
                    at_least(0.97)});
    const auto printed = run_passive(options, seeds, threads, CostMethod::kRenyiLiteral);
    rows.push_back({fmt::format("{}: F1 of the printed cost", name), printed.score.f1(), ""});
  }
}

/// Errors of positions against what is told of them, one target seen by the paper's sensors.
void add_locations(std::vector<BenchRow>& rows, const SeedRange& seeds) {
  PassiveOptions options = two_targets(0.005);
  options.targets = 1;
  double squared = 0, bound = 0, nees = 0, literal = 0;
  for (int k = 0; k < seeds.count; ++k) {
    const auto recording =
        simulate::simulate_passive(options, seeds.first + static_cast<std::uint64_t>(k));
    const auto lines = triangulate::lines_of_sight(recording->scans[0], recording->scene);
    const auto at = triangulate::most_likely(lines);
    const Eigen::Vector3d truth = recording->targets[0][0].position_m;
    const Eigen::Vector3d error = at->position_m - truth;
    squared += error.squaredNorm();
    bound += triangulate::most_likely(lines, truth)->covariance_m2.trace();
    nees += error.dot(at->covariance_m2.inverse() * error);
    const Eigen::Vector3d plain = triangulate::least_squares(lines) - truth;
    literal += plain.dot(triangulate::covariance_literal(lines).inverse() * plain);
  }
  rows.push_back({"one target, 5 mrad: RMSE / Cramer-Rao bound", std::sqrt(squared / bound), "",
                  at_most(1.02)});
  rows.push_back(
      {"one target, 5 mrad: NEES (3 is right)", nees / seeds.count, "", between(2.9, 3.1)});
  rows.push_back({"one target, 5 mrad: NEES of the printed covariance", literal / seeds.count, ""});
}

}  // namespace

std::vector<BenchRow> bench_passive(const SeedRange& seeds, int threads) {
  std::vector<BenchRow> rows;
  add_pairs(rows, seeds, threads);
  const SeedRange fewer{seeds.first, std::max(seeds.count / 10, 1)};
  add_crowds(rows, fewer, threads);
  add_locations(rows, seeds);
  add_passive_cameras(rows, seeds.first, threads);
  add_passive_solver(rows, seeds.first);
  add_many_sensors(rows, seeds.first);
  add_passive_tracks(rows, {seeds.first, std::max(seeds.count / 200, 1)}, threads);
  return rows;
}

}  // namespace scanfuse::app
