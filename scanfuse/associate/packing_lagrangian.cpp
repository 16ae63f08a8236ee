#include <algorithm>
#include <numeric>
#include <utility>

#include "scanfuse/associate/packing.hpp"
#include "scanfuse/associate/packing_core.hpp"
#include "scanfuse/associate/packing_prices.hpp"
#include "scanfuse/associate/packing_stages.hpp"

namespace scanfuse::associate {
namespace {

/// Multipliers by subgradient steps on one component.
class Relaxation {
 public:
  Relaxation(const OrderedCore& ordered, const LagrangianOptions& options)
      : ordered_(ordered), options_(options), prices_(ordered.core.rows.size(), 0.0) {}

  void run() {
    double length = 1;
    int since_better = 0;
    for (int k = 0; k < options_.iterations && !closed(); ++k) {
      ++iterations_;
      const bool better = iterate(length);
      rounds_.push_back({best_.weight, dual_});
      since_better = better ? 0 : since_better + 1;
      if (since_better < kPatience) continue;
      since_better = 0;
      length /= 2;
    }
  }

  [[nodiscard]] const CorePacking& best() const { return best_; }
  [[nodiscard]] int iterations() const { return iterations_; }
  [[nodiscard]] const std::vector<PackingRound>& rounds() const { return rounds_; }

  /// Feasible prices of all rows: the best multipliers and those of their 2-D assignment.
  [[nodiscard]] std::vector<double> prices() const {
    Stages stages(ordered_, best_prices_);
    stages.step_over(0);
    stages.assign(1);
    auto all = stages.assignment_prices();
    for (std::size_t i = 0; i < all.size(); ++i) {
      if (ordered_.set_of_row[i] > 1) all[i] = best_prices_[i];
    }
    return feasible_prices(ordered_.core, std::move(all));
  }

 private:
  static constexpr int kPatience = 10;  ///< steps without a better bound, then they are halved

  [[nodiscard]] bool closed() const {
    return iterations_ > 0 && dual_ - best_.weight <= std::max(1e-12, options_.gap) * dual_;
  }

  /// Solves the relaxed problem, recovers a packing, moves the multipliers. Whether the bound got
  /// better.
  bool iterate(double length) {
    Stages stages(ordered_, prices_);
    stages.step_over(0);
    stages.assign(1);
    const auto relaxed = stages.relaxed();
    double dual = std::accumulate(prices_.begin(), prices_.end(), 0.0);
    for (const auto j : relaxed) dual += stages.value(j);
    const bool better = iterations_ == 1 || dual < dual_;
    if (better) {
      dual_ = dual;
      best_prices_ = prices_;
    }
    recover(stages);
    move(relaxed, length * (dual - best_.weight));
    return better;
  }

  void recover(Stages& stages) {
    stages.advance(1);
    for (std::size_t set = 2; set < ordered_.count; ++set) {
      stages.assign(set);
      stages.advance(set);
    }
    auto packing = stages.packing();
    if (packing.weight > best_.weight) best_ = std::move(packing);
  }

  /// Polyak: length (dual - primal) / |g|^2 against g = 1 - (how often each row is used).
  void move(std::span<const std::int32_t> relaxed, double distance) {
    std::vector<double> gradient(prices_.size(), 0.0);
    for (std::size_t i = 0; i < gradient.size(); ++i) {
      gradient[i] = ordered_.set_of_row[i] > 1 ? 1 : 0;
    }
    for (const auto j : relaxed) {
      for (const auto row : ordered_.core.column(static_cast<std::size_t>(j))) {
        if (ordered_.set(row) > 1) gradient[static_cast<std::size_t>(row)] -= 1;
      }
    }
    double norm2 = 0;
    for (std::size_t i = 0; i < gradient.size(); ++i) {
      if (gradient[i] > 0 && prices_[i] == 0) gradient[i] = 0;
      norm2 += gradient[i] * gradient[i];
    }
    if (norm2 == 0) return;
    for (std::size_t i = 0; i < gradient.size(); ++i) {
      prices_[i] = std::max(0.0, prices_[i] - distance / norm2 * gradient[i]);
    }
  }

  const OrderedCore& ordered_;
  LagrangianOptions options_;
  std::vector<double> prices_;       ///< by row, zero for the first two sets
  std::vector<double> best_prices_;  ///< those of the least bound
  double dual_ = 0;
  CorePacking best_;
  int iterations_ = 0;
  std::vector<PackingRound> rounds_;
};

void append_relaxation(PackingSolution& solution, const PackingCore& core, const Packing& packing,
                       const LagrangianOptions& options) {
  const OrderedCore ordered(core, packing);
  Relaxation relaxation(ordered, options);
  relaxation.run();
  ProofStep step;
  step.columns = core.columns;
  step.rows = core.rows;
  step.prices = relaxation.prices();
  const double dual = std::accumulate(step.prices.begin(), step.prices.end(), 0.0);
  PackingComponent component{core.rows, core.columns, relaxation.best().weight, dual};
  component.proof = static_cast<std::int32_t>(solution.proof.size());
  solution.proof.push_back(std::move(step));
  solution.components.push_back(std::move(component));
  solution.diagnostics.sweeps += relaxation.iterations();
  auto rounds = relaxation.rounds();
  rounds.push_back({relaxation.best().weight, std::max(relaxation.best().weight, dual)});
  add_rounds(solution.diagnostics, std::move(rounds));
  for (const auto j : relaxation.best().chosen) {
    solution.chosen.push_back(core.columns[static_cast<std::size_t>(j)]);
  }
}

}  // namespace

Result<PackingSolution> LagrangianPacking::operator()(const Packing& packing) const {
  if (auto fine = check_packing(packing); !fine) return tl::unexpected(fine.error());
  const auto whole = core_of(packing);
  PackingSolution solution;
  for (const auto& core : split_core(whole, std::vector<char>(whole.columns.size(), 1))) {
    append_relaxation(solution, core, packing, options);
  }
  finish_solution(solution);
  return solution;
}

}  // namespace scanfuse::associate
