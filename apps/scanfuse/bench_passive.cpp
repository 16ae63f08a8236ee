#include <fmt/format.h>

#include <Eigen/LU>
#include <algorithm>
#include <chrono>
#include <map>

#include "bench_rows.hpp"
#include "scanfuse/core/assignment.hpp"
#include "scanfuse/core/parallel.hpp"
#include "scanfuse/evaluate/association_score.hpp"
#include "scanfuse/simulate/passive.hpp"
#include "scanfuse/triangulate/associate_scan.hpp"

namespace scanfuse::app {
namespace {

using evaluate::AssociationScore;
using simulate::PassiveOptions;
using simulate::PassiveRecording;
using triangulate::AssociationOptions;
using triangulate::CostMethod;

std::vector<Eigen::Vector3d> places_of(const PassiveRecording& recording) {
  std::vector<Eigen::Vector3d> places;
  for (const auto& target : recording.targets[0]) places.push_back(target.position_m);
  return places;
}

double median(std::vector<double> values) {
  if (values.empty()) return std::nan("");
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// What many scenes of one kind give.
struct Outcome {
  AssociationScore score;
  std::int64_t unproved = 0;
  double worst_gap = 0;
  std::vector<double> seconds, solver_seconds;  ///< of each scene
  std::int64_t sure = 0, sure_and_right = 0;    ///< bearings told with 0.9 or more
};

/// Counts the bearings whose target (or clutter) is told with at least 0.9, and how many are right.
/// A bearing of a target that no other sensor saw is as good as clutter.
void count_sure(const PassiveRecording& recording, const triangulate::ScanAssociation& found,
                Outcome& outcome) {
  const auto& bearings = recording.scans[0].bearings;
  std::map<std::int64_t, int> seen;
  for (const Bearing& b : bearings) ++seen[*b.truth];
  const auto origin = [&](std::size_t i) {
    const std::int64_t truth = *bearings[i].truth;
    return truth >= 0 && seen[truth] >= 2 ? truth : -1;
  };
  for (std::size_t i = 0; i < bearings.size(); ++i) {
    if (found.probability_of_bearing[i] < 0.9) continue;
    ++outcome.sure;
    const std::int64_t target = found.target_of_bearing[i];
    if (target < 0) {
      outcome.sure_and_right += origin(i) < 0;
      continue;
    }
    const auto& members = found.fixes[static_cast<std::size_t>(target)].bearings;
    const auto same = std::ranges::count_if(
        members, [&](std::int32_t m) { return origin(static_cast<std::size_t>(m)) == origin(i); });
    outcome.sure_and_right += origin(i) >= 0 && 2 * same > std::ssize(members);
  }
}

Outcome run(const PassiveOptions& options, const SeedRange& seeds, int threads, CostMethod cost,
            bool posterior = false) {
  std::vector<Outcome> parts(static_cast<std::size_t>(seeds.count));
  parallel_for(parts.size(), threads, [&](std::size_t k) {
    const auto recording = simulate::simulate_passive(options, seeds.first + k);
    if (!recording) return;
    AssociationOptions association;
    association.cost = cost;
    association.posterior = posterior;
    Outcome& part = parts[k];
    const auto start = std::chrono::steady_clock::now();
    const auto found = associate_scan(recording->scans[0], recording->scene, association);
    if (!found) return;
    part.seconds.push_back(
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
    part.solver_seconds.push_back(found->solver_seconds);
    part.unproved = found->solution.proved ? 0 : 1;
    part.worst_gap = found->solution.gap();
    part.score.add(recording->scans[0], found->fixes, places_of(*recording));
    if (posterior) count_sure(*recording, *found, part);
  });
  Outcome sum;
  for (const Outcome& part : parts) {
    sum.score += part.score;
    sum.unproved += part.unproved;
    sum.worst_gap = std::max(sum.worst_gap, part.worst_gap);
    sum.seconds.insert(sum.seconds.end(), part.seconds.begin(), part.seconds.end());
    sum.solver_seconds.insert(sum.solver_seconds.end(), part.solver_seconds.begin(),
                              part.solver_seconds.end());
    sum.sure += part.sure;
    sum.sure_and_right += part.sure_and_right;
  }
  return sum;
}

/// Share of targets whose bearings all go to them when their places are known: no cost does better.
double oracle_rate(const PassiveOptions& options, const SeedRange& seeds) {
  std::int64_t right = 0, all = 0;
  for (int k = 0; k < seeds.count; ++k) {
    const auto recording =
        simulate::simulate_passive(options, seeds.first + static_cast<std::uint64_t>(k));
    const auto targets = places_of(*recording);
    std::vector<bool> good(targets.size(), true);
    for (std::size_t s = 0; s < recording->scene.sensors.size(); ++s) {
      std::vector<const Bearing*> seen;
      for (const Bearing& b : recording->scans[0].bearings) {
        if (b.sensor == static_cast<std::int32_t>(s)) seen.push_back(&b);
      }
      Eigen::MatrixXd cost(std::ssize(seen), std::ssize(targets));
      for (Eigen::Index i = 0; i < cost.rows(); ++i) {
        const auto line = triangulate::line_of_sight(recording->scene.sensors[s],
                                                     *seen[static_cast<std::size_t>(i)]);
        for (Eigen::Index j = 0; j < cost.cols(); ++j) {
          const auto at = triangulate::sight(line, targets[static_cast<std::size_t>(j)]);
          cost(i, j) = at ? std::pow(at->offset_rad.x() / line.sigma_left_rad, 2) +
                                std::pow(at->offset_rad.y() / line.sigma_up_rad, 2)
                          : 1e9;
        }
      }
      const auto target_of = solve_assignment(cost);
      for (std::size_t i = 0; i < seen.size(); ++i) {
        if (target_of[i] != *seen[i]->truth)
          good[static_cast<std::size_t>(*seen[i]->truth)] = false;
      }
    }
    all += std::ssize(good);
    right += std::ranges::count(good, true);
  }
  return static_cast<double>(right) / static_cast<double>(all);
}

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

PassiveOptions crowd(double detection_probability, double noise_rad) {
  PassiveOptions options;
  options.sensor_layout = simulate::SensorLayout::kRandom;
  options.target_layout = simulate::TargetLayout::kRandom;
  options.detection_probability = detection_probability;
  options.noise_rad = noise_rad;
  options.false_alarms = 5;
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
      const auto outcome = run(options, seeds, threads, method);
      const Target target =
          method == CostMethod::kEvidence && reached == 0.565 ? at_least(reached) : Target{};
      rows.push_back({fmt::format("{}: {}", name, cost), outcome.score.exact_rate(), "exact",
                      target, reached == 0.565 ? std::nullopt : std::optional(reached)});
    }
    rows.push_back(
        {fmt::format("{}: places known", name), oracle_rate(options, seeds), "exact", {}});
  }
}

void add_crowds(std::vector<BenchRow>& rows, const SeedRange& seeds, int threads) {
  PassiveOptions narrow = crowd(0.9, 0.005);
  narrow.field_of_view_elevation_rad = radians(60);
  const std::tuple<const char*, PassiveOptions, double> scenes[] = {
      {"20 targets, PD 0.9, 5 false alarms, 5 mrad", crowd(0.9, 0.005), 0.91},
      {"the same, false alarms within 30 deg of the horizon", narrow, 0.91},
      {"the same, PD 0.7", crowd(0.7, 0.005), 0.84},
      {"the same, 10 mrad", crowd(0.9, 0.01), 0.81},
      {"the same, 1 to 20 mrad", unequal(crowd(0.9, 0.001)), 0.69}};
  for (const auto& [name, options, f1] : scenes) {
    const auto best = run(options, seeds, threads, CostMethod::kEvidence, true);
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
    const auto printed = run(options, seeds, threads, CostMethod::kRenyiLiteral);
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

void add_cameras(std::vector<BenchRow>& rows, std::uint64_t seed, int threads) {
  const std::tuple<int, int, double> sizes[] = {{200, 10, 0.96}, {1000, 2, 0.93}, {2000, 1, 0.91}};
  for (const auto& [points, scenes, f1] : sizes) {
    PassiveOptions options = crowd(0.9, 0.3 / 2500);  // 0.3 px of a lens of 2500 px
    options.false_alarms = 0;
    options.targets = points;
    options.sensors = 4;
    options.sensor_layout = simulate::SensorLayout::kCameras;
    const auto outcome = run(options, {seed, scenes}, threads, CostMethod::kEvidence);
    const auto name = fmt::format("4 cameras, {} points", points);
    rows.push_back({name + ": F1", outcome.score.f1(), "", at_least(f1)});
    rows.push_back({name + ": whole scan, median", median(outcome.seconds), "s"});
  }
}

void add_solver(std::vector<BenchRow>& rows, std::uint64_t seed) {
  PassiveOptions line;
  PassiveOptions grid = line;
  grid.target_layout = simulate::TargetLayout::kGrid;
  PassiveOptions thousand = crowd(0.9, 0.001);
  thousand.targets = 1000;
  thousand.sensors = 5;
  thousand.false_alarms = 10;
  PassiveOptions more = thousand;
  more.targets = 2000;
  more.noise_rad = 0.0005;
  const std::tuple<const char*, PassiveOptions, int, double> scenes[] = {
      {"20 x 20 x 20 line", line, 50, 0.001},
      {"20 x 20 x 20 grid", grid, 50, 0.005},
      {"1000 targets x 5 sensors", thousand, 1, 2},
      {"2000 targets x 5 sensors", more, 1, 10}};
  for (const auto& [name, options, count, limit_s] : scenes) {
    const auto outcome = run(options, {seed, count}, 1, CostMethod::kEvidence);
    rows.push_back({fmt::format("{}: not certified", name), static_cast<double>(outcome.unproved),
                    "scenes", at_most(0)});
    rows.push_back({fmt::format("{}: solver, median", name), median(outcome.solver_seconds) * 1e3,
                    "ms", at_most(limit_s * 1e3)});
    rows.push_back(
        {fmt::format("{}: whole scan, median", name), median(outcome.seconds) * 1e3, "ms"});
  }
}

}  // namespace

std::vector<BenchRow> bench_passive(const SeedRange& seeds, int threads) {
  std::vector<BenchRow> rows;
  add_pairs(rows, seeds, threads);
  const SeedRange fewer{seeds.first, std::max(seeds.count / 10, 1)};
  add_crowds(rows, fewer, threads);
  add_locations(rows, seeds);
  add_cameras(rows, seeds.first, threads);
  add_solver(rows, seeds.first);
  return rows;
}

}  // namespace scanfuse::app
