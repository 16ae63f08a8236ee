#include <algorithm>
#include <cmath>
#include <utility>

#include "scanfuse/associate/packing.hpp"
#include "scanfuse/associate/packing_core.hpp"
#include "scanfuse/associate/packing_search.hpp"
#include "scanfuse/core/parallel.hpp"

namespace scanfuse::associate {
namespace {

constexpr std::size_t kLarge = 2000;  ///< members: worth threads of its own

SearchLimits limits_of(const PriceAndBranchOptions& options) {
  using Seconds = std::chrono::duration<double>;
  const auto limit = std::chrono::duration_cast<std::chrono::steady_clock::duration>(
      Seconds(std::clamp(options.time_limit_s, 0.0, 1e6)));
  return {std::chrono::steady_clock::now() + limit, options.max_branches, options.threads};
}

/// A component's outcome becomes part of the solution.
void append_outcome(PackingSolution& solution, const PackingCore& core, SearchOutcome outcome) {
  PackingComponent component{core.rows, core.columns, outcome.primal, outcome.bound};
  const auto offset = static_cast<std::int32_t>(solution.proof.size());
  for (auto& step : outcome.proof) {
    for (auto& child : step.children) child = child < 0 ? child : child + offset;
    solution.proof.push_back(std::move(step));
  }
  component.proof = static_cast<std::int32_t>(solution.proof.size()) - 1;
  solution.components.push_back(std::move(component));
  solution.chosen.insert(solution.chosen.end(), outcome.chosen.begin(), outcome.chosen.end());
  merge_diagnostics(solution.diagnostics, outcome.diagnostics);
  auto rounds = std::move(outcome.diagnostics.rounds);
  rounds.push_back({outcome.primal, std::max(outcome.primal, outcome.bound)});
  add_rounds(solution.diagnostics, std::move(rounds));
}

SearchPart part_of_core(const PackingCore& core) {
  SearchPart part;
  part.core = core;
  return part;
}

/// The large ones in turn, each on all threads; the small ones side by side.
std::vector<SearchOutcome> solve_components(const std::vector<PackingCore>& cores,
                                            const SearchLimits& limits) {
  std::vector<SearchOutcome> outcomes(cores.size());
  std::vector<std::size_t> small;
  std::size_t work = 0;
  for (std::size_t k = 0; k < cores.size(); ++k) {
    if (cores[k].members.size() >= kLarge) {
      outcomes[k] = search_part(part_of_core(cores[k]), limits);
    } else {
      small.push_back(k);
      work += cores[k].members.size();
    }
  }
  const SearchLimits alone{limits.deadline, limits.max_branches, 1};
  parallel_for(small.size(), work < kLarge ? 1 : limits.threads, [&](std::size_t i) {
    outcomes[small[i]] = search_part(part_of_core(cores[small[i]]), alone);
  });
  return outcomes;
}

}  // namespace

Result<PackingSolution> PriceAndBranch::operator()(const Packing& packing) const {
  if (auto fine = check_packing(packing); !fine) return tl::unexpected(fine.error());
  const auto whole = core_of(packing);
  const auto cores = split_core(whole, std::vector<char>(whole.columns.size(), 1));
  auto outcomes = solve_components(cores, limits_of(options));
  PackingSolution solution;
  for (std::size_t k = 0; k < cores.size(); ++k) {
    append_outcome(solution, cores[k], std::move(outcomes[k]));
  }
  finish_solution(solution);
  return solution;
}

}  // namespace scanfuse::associate
