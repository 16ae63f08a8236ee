#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "scanfuse/associate/packing.hpp"

/// Nothing here calls the solvers: the checker reads the packing and the solution, no more.
namespace scanfuse::associate {
namespace {

constexpr double kTolerance = 1e-9;  ///< of a component's bound
constexpr double kRounding = 1e-12;  ///< of one sum of a few numbers

bool near(double a, double b) {
  return std::abs(a - b) <= kTolerance * std::max({1.0, std::abs(a), std::abs(b)});
}

class Checker {
 public:
  Checker(const Packing& packing, const PackingSolution& solution)
      : packing_(packing),
        solution_(solution),
        bounds_(solution.proof.size(), 0.0),
        price_(packing.rows(), 0.0),
        row_mark_(packing.rows(), -1),
        column_mark_(packing.columns(), -1) {}

  Result<void> run() {
    if (auto fine = chosen_are_a_packing(); !fine) return fine;
    if (auto fine = components_cover(); !fine) return fine;
    for (std::size_t k = 0; k < solution_.proof.size(); ++k) {
      if (auto fine = check_step(k); !fine) return fine;
    }
    for (std::size_t c = 0; c < solution_.components.size(); ++c) {
      if (auto fine = check_component(c); !fine) return fine;
    }
    return check_sums();
  }

 private:
  template <class... Args>
  static Result<void> wrong(fmt::format_string<Args...> text, Args&&... args) {
    return fail(Error::Code::kMalformed, text, std::forward<Args>(args)...);
  }
  [[nodiscard]] bool is_column(std::int32_t j) const {
    return j >= 0 && static_cast<std::size_t>(j) < packing_.columns();
  }
  [[nodiscard]] double weight(std::int32_t j) const {
    return packing_.weights[static_cast<std::size_t>(j)];
  }
  [[nodiscard]] std::span<const std::int32_t> rows(std::int32_t j) const {
    return packing_.column(static_cast<std::size_t>(j));
  }
  int& mark_of_row(std::int32_t i) { return row_mark_[static_cast<std::size_t>(i)]; }
  int& mark_of_column(std::int32_t j) { return column_mark_[static_cast<std::size_t>(j)]; }
  void forget_marks() {
    std::ranges::fill(row_mark_, -1);
    std::ranges::fill(column_mark_, -1);
  }

  Result<void> chosen_are_a_packing() {
    double sum = 0;
    std::int32_t last = -1;
    for (const auto j : solution_.chosen) {
      if (!is_column(j) || j <= last) return wrong("chosen: column {} is out of range or order", j);
      last = j;
      sum += weight(j);
      for (const auto i : rows(j)) {
        if (mark_of_row(i) >= 0) return wrong("chosen: row {} is used twice, by column {}", i, j);
        mark_of_row(i) = j;
      }
    }
    if (!near(sum, solution_.primal)) {
      return wrong("chosen columns weigh {}, the solution says {}", sum, solution_.primal);
    }
    return {};
  }

  /// Every column of positive weight is in one component, and rows are in one at most.
  Result<void> components_cover() {
    forget_marks();
    for (int c = 0; c < static_cast<int>(solution_.components.size()); ++c) {
      for (const auto j : solution_.components[static_cast<std::size_t>(c)].columns) {
        if (!is_column(j) || mark_of_column(j) >= 0) {
          return wrong("component {}: column {} is out of range or in two components", c, j);
        }
        mark_of_column(j) = c;
        for (const auto i : rows(j)) {
          if (mark_of_row(i) >= 0 && mark_of_row(i) != c) {
            return wrong("component {}: row {} is in two components", c, i);
          }
          mark_of_row(i) = c;
        }
      }
    }
    for (std::size_t j = 0; j < packing_.columns(); ++j) {
      if (packing_.weights[j] > 0 && column_mark_[j] < 0) {
        return wrong("column {} of positive weight is in no component", j);
      }
    }
    return {};
  }

  Result<void> check_step(std::size_t k) {
    const auto& step = solution_.proof[k];
    for (const auto child : step.children) {
      if (child < -1 || child >= static_cast<std::int32_t>(k)) {
        return wrong("proof step {}: child {} does not come before it", k, child);
      }
    }
    if (!std::ranges::all_of(step.columns, [&](auto j) { return is_column(j); })) {
      return wrong("proof step {}: a column is out of range", k);
    }
    switch (step.kind) {
      case ProofStep::Kind::kPrices:
        return check_prices(k, step);
      case ProofStep::Kind::kSplit:
        return check_split(k, step);
      case ProofStep::Kind::kBranch:
        return check_branch(k, step);
    }
    return wrong("proof step {}: of no known kind", k);
  }

  /// Leaves the prices in `price_`, zero elsewhere, and their sum in the bound.
  Result<void> lay_out_prices(std::size_t k, const ProofStep& step) {
    std::ranges::fill(price_, 0.0);
    if (step.rows.size() != step.prices.size()) {
      return wrong("proof step {}: {} rows, {} prices", k, step.rows.size(), step.prices.size());
    }
    std::int32_t last = -1;
    for (std::size_t i = 0; i < step.rows.size(); ++i) {
      const auto row = step.rows[i];
      if (row <= last || static_cast<std::size_t>(row) >= packing_.rows()) {
        return wrong("proof step {}: row {} is out of range or order", k, row);
      }
      if (!(step.prices[i] >= 0) || !std::isfinite(step.prices[i])) {
        return wrong("proof step {}: the price of row {} is {}", k, row, step.prices[i]);
      }
      last = row;
      price_[static_cast<std::size_t>(row)] = step.prices[i];
      bounds_[k] += step.prices[i];
    }
    return {};
  }

  /// The sum of its prices less the weight of a column.
  [[nodiscard]] double cost(std::int32_t j) const {
    double sum = -weight(j);
    for (const auto i : rows(j)) sum += price_[static_cast<std::size_t>(i)];
    return sum;
  }

  Result<void> check_prices(std::size_t k, const ProofStep& step) {
    if (auto fine = lay_out_prices(k, step); !fine) return fine;
    for (const auto j : step.columns) {
      if (cost(j) < -kRounding * std::max(1.0, weight(j))) {
        return wrong("proof step {}: prices of column {} are {} short of its weight", k, j,
                     -cost(j));
      }
    }
    if (step.children.empty()) return {};
    if (step.children.size() != 1) return wrong("proof step {}: too many children", k);
    return set_aside(k, step);
  }

  /// Columns that are not handed on to the child cannot be in a packing above the threshold.
  Result<void> set_aside(std::size_t k, const ProofStep& step) {
    const auto child = step.children[0];
    const double dual = bounds_[k];
    mark_columns(child, static_cast<int>(k));
    for (const auto j : step.columns) {
      const bool handed_on = child >= 0 && mark_of_column(j) == static_cast<int>(k);
      if (!handed_on && dual - cost(j) > step.threshold + kRounding * std::max(1.0, dual)) {
        return wrong("proof step {}: column {} is set aside without reason", k, j);
      }
    }
    bounds_[k] = std::max(step.threshold, bound_of(child));
    return {};
  }

  [[nodiscard]] double bound_of(std::int32_t step) const {
    return step < 0 ? 0.0 : bounds_[static_cast<std::size_t>(step)];
  }
  void mark_columns(std::int32_t step, int mark) {
    std::ranges::fill(column_mark_, -1);
    if (step < 0) return;
    for (const auto j : solution_.proof[static_cast<std::size_t>(step)].columns) {
      mark_of_column(j) = mark;
    }
  }

  Result<void> check_split(std::size_t k, const ProofStep& step) {
    forget_marks();
    for (const auto child : step.children) {
      if (child < 0) return wrong("proof step {}: a part is missing", k);
      bounds_[k] += bound_of(child);
      for (const auto j : solution_.proof[static_cast<std::size_t>(child)].columns) {
        mark_of_column(j) = child;
        for (const auto i : rows(j)) {
          if (mark_of_row(i) >= 0 && mark_of_row(i) != child) {
            return wrong("proof step {}: parts share row {}", k, i);
          }
          mark_of_row(i) = child;
        }
      }
    }
    for (const auto j : step.columns) {
      if (mark_of_column(j) < 0) return wrong("proof step {}: column {} is in no part", k, j);
    }
    return {};
  }

  [[nodiscard]] bool share_a_row(std::int32_t a, std::int32_t b) const {
    return std::ranges::any_of(
        rows(a), [&](auto i) { return std::ranges::find(rows(b), i) != rows(b).end(); });
  }

  Result<void> check_branch(std::size_t k, const ProofStep& step) {
    const auto on = step.branch_column;
    if (step.children.size() != 2 || !is_column(on)) {
      return wrong("proof step {}: a branch needs a column and two children", k);
    }
    mark_columns(step.children[0], 1);
    for (const auto j : step.columns) {
      if (!share_a_row(j, on) && mark_of_column(j) != 1) {
        return wrong("proof step {}: with column {}, column {} is forgotten", k, on, j);
      }
    }
    mark_columns(step.children[1], 2);
    for (const auto j : step.columns) {
      if (j != on && mark_of_column(j) != 2) {
        return wrong("proof step {}: without column {}, column {} is forgotten", k, on, j);
      }
    }
    bounds_[k] = std::max(bound_of(step.children[0]) + weight(on), bound_of(step.children[1]));
    return {};
  }

  Result<void> check_component(std::size_t c) {
    const auto& component = solution_.components[c];
    if (component.proof < 0 ||
        static_cast<std::size_t>(component.proof) >= solution_.proof.size()) {
      return wrong("component {}: has no proof", c);
    }
    mark_columns(component.proof, 1);
    double primal = 0;
    for (const auto j : component.columns) {
      if (mark_of_column(j) != 1) return wrong("component {}: column {} is not proved", c, j);
      if (std::ranges::binary_search(solution_.chosen, j)) primal += weight(j);
    }
    if (!near(primal, component.primal)) {
      return wrong("component {}: its chosen columns weigh {}, it says {}", c, primal,
                   component.primal);
    }
    const double tolerance = kTolerance * std::max(1.0, std::abs(component.dual));
    const double bound = bound_of(component.proof);
    if (!(bound <= component.dual + tolerance)) {
      return wrong("component {}: proved is {}, it says {}", c, bound, component.dual);
    }
    if (component.proved && !(component.primal >= component.dual - tolerance)) {
      return wrong("component {}: has a gap and says that it has none", c);
    }
    return {};
  }

  Result<void> check_sums() {
    double primal = 0, dual = 0;
    bool proved = true;
    for (const auto& component : solution_.components) {
      primal += component.primal;
      dual += component.dual;
      proved = proved && component.proved;
    }
    if (!near(primal, solution_.primal) || !near(dual, solution_.dual)) {
      return wrong("components sum up to {} and {}, the solution says {} and {}", primal, dual,
                   solution_.primal, solution_.dual);
    }
    if (solution_.proved && !proved) return wrong("not every component is proved");
    return {};
  }

  const Packing& packing_;
  const PackingSolution& solution_;
  std::vector<double> bounds_;  ///< by step
  std::vector<double> price_;   ///< by row, of one step
  std::vector<int> row_mark_;   ///< scratch
  std::vector<int> column_mark_;
};

}  // namespace

Result<void> check_bound(const Packing& packing, const PackingSolution& solution) {
  if (auto fine = check_packing(packing); !fine) return fine;
  return Checker(packing, solution).run();
}

}  // namespace scanfuse::associate
