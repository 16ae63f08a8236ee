#include "scanfuse/triangulate/associate_scan.hpp"

#include <algorithm>
#include <cmath>

namespace scanfuse::triangulate {
namespace {

associate::Packing packing_of(const BearingScan& scan, Candidates candidates) {
  associate::Packing packing;
  packing.set_of_row.reserve(scan.bearings.size());
  for (const Bearing& bearing : scan.bearings) packing.set_of_row.push_back(bearing.sensor);
  packing.starts = std::move(candidates.starts);
  packing.members = std::move(candidates.members);
  packing.weights = std::move(candidates.weights);
  return packing;
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

}  // namespace

Result<ScanAssociation> associate_scan(const BearingScan& scan, const PassiveScene& scene,
                                       const AssociationOptions& options, int threads) {
  ScanAssociation result;
  result.prior = scene_prior(scene, scan);
  const Cost cost = make_cost(options.cost, options.alpha);
  Candidates candidates =
      find_candidates(scan, scene, result.prior.prior, cost, options.candidates, threads);
  if (candidates.too_many) {
    return fail(Error::Code::kOutOfRange,
                "scan {}: more than {} ways to join {} bearings even with a narrow gate: the "
                "sensors are too coarse for so many targets; raise associate.most_candidates",
                scan.scan, options.candidates.most_candidates, scan.bearings.size());
  }
  result.pairs_tried = candidates.tried;
  result.gate_probability = candidates.gate_probability;
  result.packing = packing_of(scan, std::move(candidates));
  auto solution = solve(result.packing, options, threads);
  if (!solution) return tl::unexpected(solution.error());
  result.solution = std::move(*solution);
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
  return result;
}

}  // namespace scanfuse::triangulate
