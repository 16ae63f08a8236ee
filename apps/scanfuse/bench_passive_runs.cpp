#include "bench_passive_runs.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <map>

#include "scanfuse/core/assignment.hpp"
#include "scanfuse/core/parallel.hpp"

namespace scanfuse::app {
using simulate::PassiveOptions;
using simulate::PassiveRecording;
using triangulate::AssociationOptions;
using triangulate::CostMethod;

namespace {

std::vector<Eigen::Vector3d> places_of(const PassiveRecording& recording) {
  std::vector<Eigen::Vector3d> places;
  for (const auto& target : recording.targets[0]) places.push_back(target.position_m);
  return places;
}

/// Counts the bearings whose target (or clutter) is told with at least 0.9, and how many are right.
/// A bearing of a target that no other sensor saw is as good as clutter.
void count_sure(const PassiveRecording& recording, const triangulate::ScanAssociation& found,
                PassiveOutcome& outcome) {
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

}  // namespace

PassiveOutcome run_passive(const PassiveOptions& options, const SeedRange& seeds, int threads,
                           CostMethod cost, const PassiveRunOptions& run) {
  std::vector<PassiveOutcome> parts(static_cast<std::size_t>(seeds.count));
  parallel_for(parts.size(), threads, [&](std::size_t k) {
    const auto recording = simulate::simulate_passive(options, seeds.first + k);
    if (!recording) return;
    AssociationOptions association;
    association.time_limit_s = run.time_limit_s;
    association.cost = cost;
    association.posterior = run.posterior;
    PassiveOutcome& part = parts[k];
    const auto start = std::chrono::steady_clock::now();
    auto found = associate_scan(recording->scans[0], recording->scene, association);
    if (!found) return;
    part.seconds.push_back(
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
    part.solver_seconds.push_back(found->solver_seconds);
    part.columns.push_back(static_cast<double>(found->packing.columns()));
    part.unproved = found->proved ? 0 : 1;
    part.worst_gap = found->gap();
    part.score.add(recording->scans[0], found->fixes, places_of(*recording));
    if (run.posterior) count_sure(*recording, *found, part);
    if (run.keep_packings) part.packings.push_back(std::move(found->packing));
  });
  PassiveOutcome sum;
  for (PassiveOutcome& part : parts) {
    std::ranges::move(part.packings, std::back_inserter(sum.packings));
    sum.score += part.score;
    sum.unproved += part.unproved;
    sum.worst_gap = std::max(sum.worst_gap, part.worst_gap);
    sum.seconds.insert(sum.seconds.end(), part.seconds.begin(), part.seconds.end());
    sum.solver_seconds.insert(sum.solver_seconds.end(), part.solver_seconds.begin(),
                              part.solver_seconds.end());
    sum.columns.insert(sum.columns.end(), part.columns.begin(), part.columns.end());
    sum.sure += part.sure;
    sum.sure_and_right += part.sure_and_right;
  }
  return sum;
}

double passive_oracle_rate(const PassiveOptions& options, const SeedRange& seeds) {
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

PassiveOptions passive_crowd(double detection_probability, double noise_rad) {
  PassiveOptions options;
  options.sensor_layout = simulate::SensorLayout::kRandom;
  options.target_layout = simulate::TargetLayout::kRandom;
  options.detection_probability = detection_probability;
  options.noise_rad = noise_rad;
  options.false_alarms = 5;
  return options;
}

}  // namespace scanfuse::app
