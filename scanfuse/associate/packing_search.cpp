#include "scanfuse/associate/packing_search.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "scanfuse/associate/packing_bracket.hpp"
#include "scanfuse/associate/packing_prices.hpp"
#include "scanfuse/associate/packing_simplex.hpp"
#include "scanfuse/core/parallel.hpp"

namespace scanfuse::associate {
namespace {

constexpr double kFirstTemperature = 0.02;  ///< of the mean weight of chosen columns
constexpr double kCooling = 0.5;
constexpr double kLastTemperature = 1e-6;  ///< of the first
constexpr int kSweepsPerTemperature = 60;
constexpr double kSettled = 0.02;  ///< prices that move less, in temperatures
constexpr double kCold = 0.05;     ///< temperature times entropy, by gap: the prices are optimal
constexpr double kReheat = 4;      ///< after a branch
constexpr double kStalled = 0.98;  ///< of the gap before, or more: cooling does no good any more
constexpr std::size_t kLargestProof = 40'000'000;  ///< numbers in all steps
constexpr double kWorthSplitting = 0.7;            ///< of the columns are kept, or fewer

/// Whether the simplex is quicker than further annealing.
bool suits_simplex(const PackingCore& core) {
  return core.rows.size() <= 300 && core.columns.size() <= 12 * core.rows.size();
}

/// By how much prices exceed the linear optimum, per temperature.
double entropy(std::span<const double> shares) {
  double sum = 0;
  for (const double x : shares) sum -= x > 1e-12 ? x * std::log(x) : 0;
  return sum;
}

/// Moves a child's proof behind the others; the index of its claim, -1 for none.
std::int32_t append_proof(std::vector<ProofStep>& proof, std::vector<ProofStep> child) {
  const auto offset = static_cast<std::int32_t>(proof.size());
  for (auto& step : child) {
    for (auto& index : step.children) {
      if (index >= 0) index += offset;
    }
    proof.push_back(std::move(step));
  }
  return child.empty() ? -1 : static_cast<std::int32_t>(proof.size()) - 1;
}

class Search {
 public:
  explicit Search(const SearchLimits& limits) : limits_(limits) {}

  SearchOutcome solve(SearchPart part) {
    auto bracket = open_bracket(part.core, part.prices, part.start, part.threshold);
    double temperature = part.temperature;
    if (temperature == 0) temperature = first_temperature(part.core, bracket.best);
    const double last = kLastTemperature * first_temperature(part.core, bracket.best);
    const bool whole = diagnostics_.rounds.empty();
    note_round(bracket, whole);
    SoftPrices soft(part.core, bracket.prices);
    while (!bracket.closed() && !out_of_time()) {
      const double gap = bracket.gap();
      const bool linear = suits_simplex(part.core);
      const bool settled = linear ? solve_by_simplex(part.core, bracket)
                                  : anneal(part.core, bracket, soft, temperature);
      bracket = with_packings(part.core, std::move(bracket));
      note_round(bracket, whole);
      if (bracket.closed()) break;
      const auto kept = worth_keeping(part.core, bracket);
      const auto count = static_cast<double>(std::ranges::count(kept, 1));
      const bool at_the_end = linear || temperature < last ||
                              temperature * entropy(bracket.shares) < kCold * bracket.gap();
      if (at_the_end) return set_aside(part.core, bracket, kept, kReheat * temperature, true);
      if (count < kWorthSplitting * static_cast<double>(kept.size())) {
        return set_aside(part.core, bracket, kept, temperature, false);
      }
      if (settled || bracket.gap() > kStalled * gap) temperature *= kCooling;
    }
    return leaf(part.core, bracket);
  }

  [[nodiscard]] PackingDiagnostics diagnostics() const { return diagnostics_; }

 private:
  bool out_of_time() {
    if (!diagnostics_.out_of_time) {
      diagnostics_.out_of_time = std::chrono::steady_clock::now() >= limits_.deadline;
    }
    return diagnostics_.out_of_time;
  }

  void note_round(const Bracket& bracket, bool whole) {
    if (whole) diagnostics_.rounds.push_back({bracket.best.weight, bracket.dual});
  }

  static double first_temperature(const PackingCore& core, const CorePacking& best) {
    const double weight = best.chosen.empty()
                              ? core.weights[0]
                              : best.weight / static_cast<double>(best.chosen.size());
    return kFirstTemperature * weight;
  }

  /// Whether the prices have settled at this temperature.
  bool anneal(const PackingCore& core, Bracket& bracket, SoftPrices& soft, double temperature) {
    const int sweeps = soft.sweep(temperature, kSweepsPerTemperature, kSettled);
    diagnostics_.sweeps += sweeps;
    bracket = with_prices(core, std::move(bracket), soft.prices());
    bracket.shares = soft.shares();
    return sweeps < kSweepsPerTemperature;
  }

  bool solve_by_simplex(const PackingCore& core, Bracket& bracket) {
    const int most_pivots = 2000 + 50 * static_cast<int>(core.rows.size());
    auto optimum = solve_linear(core, bracket.best.chosen, most_pivots);
    diagnostics_.pivots += optimum.pivots;
    bracket = with_prices(core, std::move(bracket), optimum.prices);
    bracket.shares = std::move(optimum.shares);
    return optimum.optimal;
  }

  ProofStep claim(ProofStep::Kind kind, const PackingCore& core) {
    ProofStep step;
    step.kind = kind;
    step.columns = core.columns;
    proof_size_ += core.columns.size() + 2 * core.rows.size();
    return step;
  }

  ProofStep price_claim(const PackingCore& core, const Bracket& bracket) {
    auto step = claim(ProofStep::Kind::kPrices, core);
    step.rows = core.rows;
    step.prices = bracket.prices;
    return step;
  }

  static SearchOutcome found(const PackingCore& core, const CorePacking& packing) {
    SearchOutcome outcome;
    for (const auto j : packing.chosen) {
      outcome.chosen.push_back(core.columns[static_cast<std::size_t>(j)]);
    }
    outcome.primal = packing.weight;
    return outcome;
  }

  SearchOutcome leaf(const PackingCore& core, const Bracket& bracket) {
    auto outcome = found(core, bracket.best);
    outcome.bound = bracket.dual;
    outcome.proof.push_back(price_claim(core, bracket));
    return outcome;
  }

  /// Goes on with the columns kept: their components, or a branch.
  SearchOutcome set_aside(const PackingCore& core, const Bracket& bracket,
                          std::span<const char> kept, double temperature, bool may_branch) {
    auto parts = split_core(core, kept);
    const bool branch_now = may_branch && parts.size() == 1;
    auto outcome = branch_now ? branch(core, std::move(parts[0]), bracket, temperature)
                              : solve_parts(core, std::move(parts), bracket, temperature);
    auto step = price_claim(core, bracket);
    step.threshold = bracket.threshold;
    step.children = {outcome.proof.empty() ? -1
                                           : static_cast<std::int32_t>(outcome.proof.size()) - 1};
    outcome.proof.push_back(std::move(step));
    outcome.bound = std::max(outcome.bound, bracket.threshold);
    return better_of(std::move(outcome), found(core, bracket.best));
  }

  /// The outcome with the heavier packing.
  static SearchOutcome better_of(SearchOutcome outcome, SearchOutcome other) {
    if (other.primal > outcome.primal) {
      outcome.chosen = std::move(other.chosen);
      outcome.primal = other.primal;
    }
    return outcome;
  }

  /// A part with what its parent knows: prices, the packing's columns in it.
  static SearchPart part_of(const PackingCore& core, PackingCore part, const Bracket& bracket,
                            double temperature) {
    SearchPart result;
    result.temperature = temperature;
    for (const auto row : rows_within(part, core)) {
      result.prices.push_back(bracket.prices[static_cast<std::size_t>(row)]);
    }
    for (const auto j : bracket.best.chosen) {
      const auto column = core.columns[static_cast<std::size_t>(j)];
      const auto place = std::ranges::lower_bound(part.columns, column);
      if (place == part.columns.end() || *place != column) continue;
      result.start.push_back(static_cast<std::int32_t>(place - part.columns.begin()));
      result.threshold += core.weights[static_cast<std::size_t>(j)];
    }
    result.core = std::move(part);
    return result;
  }

  /// Components one by one. A component is of no interest where, with the others at their bounds,
  /// it cannot lift the sum above the threshold.
  SearchOutcome solve_parts(const PackingCore& core, std::vector<PackingCore> cores,
                            const Bracket& bracket, double temperature) {
    std::vector<SearchPart> parts;
    std::vector<double> bounds;
    for (auto& part : cores) {
      parts.push_back(part_of(core, std::move(part), bracket, temperature));
      bounds.push_back(total(parts.back().prices));
    }
    const bool alike = limits_.threads != 1 && parts.size() > 1 && core.members.size() > 2000;
    return join(core, alike
                          ? solve_alongside(std::move(parts))
                          : solve_in_turn(std::move(parts), std::move(bounds), bracket.threshold));
  }

  std::vector<SearchOutcome> solve_in_turn(std::vector<SearchPart> parts,
                                           std::vector<double> bounds, double threshold) {
    std::vector<SearchOutcome> outcomes;
    double sum = total(bounds);
    for (std::size_t k = 0; k < parts.size(); ++k) {
      parts[k].threshold = std::max(parts[k].threshold, threshold - (sum - bounds[k]));
      outcomes.push_back(solve(std::move(parts[k])));
      sum += std::min(0.0, outcomes.back().bound - bounds[k]);
    }
    return outcomes;
  }

  /// Each with a budget of its own, so that the order in which threads work does not matter.
  std::vector<SearchOutcome> solve_alongside(std::vector<SearchPart> parts) {
    std::vector<SearchOutcome> outcomes(parts.size());
    SearchLimits limits = limits_;
    limits.threads = 1;
    parallel_for(parts.size(), limits_.threads,
                 [&](std::size_t k) { outcomes[k] = search_part(std::move(parts[k]), limits); });
    for (const auto& outcome : outcomes) merge_diagnostics(diagnostics_, outcome.diagnostics);
    return outcomes;
  }

  SearchOutcome join(const PackingCore& core, std::vector<SearchOutcome> outcomes) {
    if (outcomes.size() == 1) return std::move(outcomes[0]);
    SearchOutcome result;
    if (outcomes.empty()) return result;
    auto step = claim(ProofStep::Kind::kSplit, core);
    step.columns.clear();
    for (auto& outcome : outcomes) {
      result.primal += outcome.primal;
      result.bound += outcome.bound;
      result.chosen.insert(result.chosen.end(), outcome.chosen.begin(), outcome.chosen.end());
      const auto& columns = outcome.proof.back().columns;
      step.columns.insert(step.columns.end(), columns.begin(), columns.end());
      step.children.push_back(append_proof(result.proof, std::move(outcome.proof)));
    }
    std::ranges::sort(step.columns);
    result.proof.push_back(std::move(step));
    return result;
  }

  /// The column whose share is nearest to one half.
  static std::size_t most_divided(const PackingCore& part, const PackingCore& core,
                                  std::span<const double> shares) {
    std::size_t best = 0, at = 0;
    double nearest = 2;
    for (std::size_t j = 0; j < core.columns.size() && at < part.columns.size(); ++j) {
      if (core.columns[j] != part.columns[at]) continue;
      const double distance = std::abs(shares[j] - 0.5);
      const bool heavier = part.weights[at] > part.weights[best];
      if (distance < nearest - 1e-6 || (distance < nearest + 1e-6 && heavier)) {
        nearest = std::min(nearest, distance);
        best = at;
      }
      ++at;
    }
    return best;
  }

  /// Both answers to: is this column in the packing?
  SearchOutcome branch(const PackingCore& core, PackingCore part, const Bracket& bracket,
                       double temperature) {
    const auto here = part_of(core, std::move(part), bracket, 0);
    const bool full = diagnostics_.branches >= limits_.max_branches || proof_size_ > kLargestProof;
    if (full || out_of_time()) {
      diagnostics_.out_of_nodes = diagnostics_.out_of_nodes || !diagnostics_.out_of_time;
      return surrender(here);
    }
    ++diagnostics_.branches;
    diagnostics_.largest_core =
        std::max(diagnostics_.largest_core, static_cast<std::int64_t>(here.core.columns.size()));
    const auto column = most_divided(here.core, core, bracket.shares);
    Bracket inside = bracket_of(here, bracket.threshold);
    auto with = take(here.core, column, inside, temperature);
    inside.threshold = std::max(inside.threshold, with.primal);
    auto without = leave(here.core, column, inside, temperature);
    return join_branches(here.core, column, std::move(with), std::move(without));
  }

  static Bracket bracket_of(const SearchPart& part, double threshold) {
    Bracket bracket;
    bracket.prices = part.prices;
    bracket.best.chosen = part.start;
    bracket.threshold = threshold;
    return bracket;
  }

  SearchOutcome surrender(const SearchPart& part) {
    Bracket bracket = bracket_of(part, 0);
    bracket.dual = total(part.prices);
    for (const auto j : part.start) {
      bracket.best.weight += part.core.weights[static_cast<std::size_t>(j)];
    }
    return leaf(part.core, bracket);
  }

  SearchOutcome take(const PackingCore& core, std::size_t column, Bracket bracket,
                     double temperature) {
    std::vector<char> blocked(core.rows.size(), 0);
    for (const auto row : core.column(column)) blocked[static_cast<std::size_t>(row)] = 1;
    std::vector<char> kept(core.columns.size(), 1);
    for (std::size_t j = 0; j < kept.size(); ++j) {
      for (const auto row : core.column(j)) {
        if (blocked[static_cast<std::size_t>(row)]) kept[j] = 0;
      }
    }
    bracket.threshold -= core.weights[column];
    auto outcome = solve_parts(core, split_core(core, kept), bracket, temperature);
    outcome.primal += core.weights[column];
    outcome.bound += core.weights[column];
    outcome.chosen.push_back(core.columns[column]);
    return outcome;
  }

  SearchOutcome leave(const PackingCore& core, std::size_t column, const Bracket& bracket,
                      double temperature) {
    std::vector<char> kept(core.columns.size(), 1);
    kept[column] = 0;
    return solve_parts(core, split_core(core, kept), bracket, temperature);
  }

  SearchOutcome join_branches(const PackingCore& core, std::size_t column, SearchOutcome with,
                              SearchOutcome without) {
    auto step = claim(ProofStep::Kind::kBranch, core);
    step.branch_column = core.columns[column];
    SearchOutcome result;
    step.children.push_back(append_proof(result.proof, std::move(with.proof)));
    step.children.push_back(append_proof(result.proof, std::move(without.proof)));
    result.proof.push_back(std::move(step));
    result.bound = std::max(with.bound, without.bound);
    auto& better = with.primal >= without.primal ? with : without;
    result.primal = better.primal;
    result.chosen = std::move(better.chosen);
    return result;
  }

  const SearchLimits limits_;
  PackingDiagnostics diagnostics_;
  std::size_t proof_size_ = 0;
};

}  // namespace

SearchOutcome search_part(SearchPart part, const SearchLimits& limits) {
  Search search(limits);
  auto outcome = search.solve(std::move(part));
  outcome.diagnostics = search.diagnostics();
  return outcome;
}

}  // namespace scanfuse::associate
