#include "scanfuse/triangulate/associate_scan.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <numeric>

namespace scanfuse::triangulate {
namespace {

/// The most likely place of a chosen hypothesis; its bearings are known to meet.
Fix fix_of(std::span<const std::int32_t> column, const BearingScan& scan, const PassiveScene& scene,
           const ScenePrior& prior) {
  std::vector<LineOfSight> lines;
  Fix fix;
  for (const std::int32_t place : column) {
    const Bearing& bearing = scan.bearings[static_cast<std::size_t>(place)];
    lines.push_back(
        line_of_sight(scene.sensors[static_cast<std::size_t>(bearing.sensor)], bearing));
    fix.degrees_of_freedom += lines.back().dimensions();
    fix.bearings.push_back(place);
  }
  fix.degrees_of_freedom = std::max(fix.degrees_of_freedom + (prior.flat ? 1 : 0) - 3, 0);
  auto at = most_likely(lines, prior.height());
  if (!at) at = Location{least_squares(lines), covariance_corrected(lines, least_squares(lines))};
  fix.position_m = at->position_m;
  fix.covariance_m2 = at->covariance_m2;
  fix.chi2 = at->chi2;
  return fix;
}

/// Existence and membership from the posterior of all hypotheses.
Result<void> add_posterior(ScanAssociation& found, const AssociationOptions& options) {
  const auto posterior = associate::packing_posterior(found.packing, found.solution,
                                                      {.max_moves = options.posterior_moves});
  if (!posterior) return tl::unexpected(posterior.error());
  const auto& targets = found.target_of_bearing;
  std::vector<double> existence(found.fixes.size(), 0);
  std::vector<std::size_t> shared(found.fixes.size(), 0);
  for (std::size_t i = 0; i < targets.size(); ++i) {
    found.probability_of_bearing[i] = targets[i] < 0 ? posterior->clutter[i] : 0;
  }
  for (std::size_t k = 0; k < found.packing.columns(); ++k) {
    const auto column = found.packing.column(k);
    const auto target_of = [&](std::int32_t m) { return targets[static_cast<std::size_t>(m)]; };
    for (const auto m : column) {
      if (target_of(m) >= 0) ++shared[static_cast<std::size_t>(target_of(m))];
    }
    for (const auto m : column) {
      if (target_of(m) < 0) continue;
      const auto t = static_cast<std::size_t>(target_of(m));
      if (2 * shared[t] > found.fixes[t].bearings.size()) {
        found.probability_of_bearing[static_cast<std::size_t>(m)] += posterior->column[k];
        existence[t] += posterior->column[k] / static_cast<double>(shared[t]);
      }
    }
    for (const auto m : column) {
      if (target_of(m) >= 0) shared[static_cast<std::size_t>(target_of(m))] = 0;
    }
  }
  for (double& p : found.probability_of_bearing) p = std::min(p, 1.0);
  for (std::size_t t = 0; t < existence.size(); ++t) {
    found.fixes[t].existence_probability = std::min(existence[t], 1.0);
  }
  return {};
}

}  // namespace

Result<WeighedHypotheses> weigh_hypotheses(const BearingScan& scan, const PassiveScene& scene,
                                           const ScenePrior& prior,
                                           const AssociationOptions& options, int threads) {
  Candidates candidates = find_candidates(
      scan, scene, prior, make_cost(options.cost, options.alpha), options.candidates, threads);
  if (candidates.too_many) {
    return fail(Error::Code::kOutOfRange,
                "scan {}: too many ways to join {} bearings, even with a narrow gate (more than {} "
                "pairs or {} hypotheses): the sensors are too coarse for so many bearings; raise "
                "candidates.most_pairs or candidates.most_candidates",
                scan.scan, scan.bearings.size(), options.candidates.most_pairs,
                options.candidates.most_candidates);
  }
  WeighedHypotheses weighed{{},
                            candidates.tried,
                            candidates.gate_probability,
                            std::move(candidates.cut),
                            std::move(candidates.cut_prices)};
  associate::Packing& packing = weighed.packing;
  packing.set_of_row.reserve(scan.bearings.size());
  for (const Bearing& bearing : scan.bearings) packing.set_of_row.push_back(bearing.sensor);
  packing.starts = std::move(candidates.starts);
  packing.members = std::move(candidates.members);
  packing.weights = std::move(candidates.weights);
  return weighed;
}

double bound_on_all(const WeighedHypotheses& weighed, const associate::PackingSolution& solution) {
  std::vector<char> cut(weighed.packing.rows(), 0);
  for (const std::int32_t row : weighed.cut) cut[static_cast<std::size_t>(row)] = 1;
  const double covered = std::accumulate(weighed.cut_prices.begin(), weighed.cut_prices.end(), 0.0);
  double known = 0;
  for (const auto& component : solution.components) {
    if (cut[static_cast<std::size_t>(component.rows.front())]) known += component.dual;
  }
  return solution.dual + std::max(covered - known, 0.0);
}

Result<associate::PackingSolution> solve(const associate::Packing& packing,
                                         const AssociationOptions& options, int threads) {
  if (options.solver != associate::PackingMethod::kPriceAndBranch) {
    return associate::solve_packing(options.solver, packing);
  }
  associate::PriceAndBranch solver;
  solver.options.time_limit_s = options.time_limit_s;
  solver.options.threads = threads;
  return solver(packing);
}

Result<ScanAssociation> associate_scan(const BearingScan& scan, const PassiveScene& scene,
                                       const AssociationOptions& options, int threads) {
  ScanAssociation result;
  result.prior = scene_prior(scene, scan);
  auto weighed = weigh_hypotheses(scan, scene, result.prior.prior, options, threads);
  if (!weighed) return tl::unexpected(weighed.error());
  result.pairs_tried = weighed->pairs_tried;
  result.gate_probability = weighed->gate_probability;
  const auto start = std::chrono::steady_clock::now();
  auto solution = solve(weighed->packing, options, threads);
  result.solver_seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  if (!solution) return tl::unexpected(solution.error());
  result.solution = std::move(*solution);
  result.dual = bound_on_all(*weighed, result.solution);
  result.cut_bearings = weighed->cut.size();
  result.proved = result.solution.proved && weighed->cut.empty();
  result.packing = std::move(weighed->packing);
  result.target_of_bearing.assign(scan.bearings.size(), -1);
  for (const std::int32_t column : result.solution.chosen) {
    const auto k = static_cast<std::size_t>(column);
    Fix fix = fix_of(result.packing.column(k), scan, scene, result.prior.prior);
    fix.weight = result.packing.weights[k];
    fix.existence_probability = 1 / (1 + std::exp(-fix.weight));
    result.fixes.push_back(std::move(fix));
  }
  std::ranges::sort(result.fixes, {}, &Fix::bearings);
  for (std::size_t t = 0; t < result.fixes.size(); ++t) {
    result.fixes[t].target = static_cast<std::int64_t>(t);
    for (const std::int32_t place : result.fixes[t].bearings) {
      result.target_of_bearing[static_cast<std::size_t>(place)] = static_cast<std::int64_t>(t);
    }
  }
  result.probability_of_bearing.assign(scan.bearings.size(), 1);
  if (options.posterior) {
    if (auto done = add_posterior(result, options); !done) return tl::unexpected(done.error());
  }
  return result;
}

}  // namespace scanfuse::triangulate
