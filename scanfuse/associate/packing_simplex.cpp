#include "scanfuse/associate/packing_simplex.hpp"

#include <algorithm>
#include <cmath>

#include "scanfuse/core/random.hpp"

namespace scanfuse::associate {
namespace {

/// Variables: columns 0 .. n - 1, then the slack of each row.
class Simplex {
 public:
  explicit Simplex(const PackingCore& core)
      : core_(core),
        m_(core.rows.size()),
        n_(core.columns.size()),
        inverse_(m_ * m_, 0.0),
        values_(m_),
        prices_(m_, 0.0),
        basis_(m_),
        basic_(n_ + m_, 0) {
    RandomStream random(7);
    for (std::size_t i = 0; i < m_; ++i) {
      inverse_[i * m_ + i] = 1;
      values_[i] = 1 + random.uniform(1e-7, 2e-7);
      basis_[i] = n_ + i;
      basic_[n_ + i] = 1;
    }
    largest_ = *std::ranges::max_element(core.weights);
  }

  /// Brings a packing into the basis.
  void start(std::span<const std::int32_t> packing) {
    for (const auto j : packing) enter(static_cast<std::size_t>(j));
  }

  LinearOptimum run(int most_pivots) {
    while (pivots_ < most_pivots) {
      const std::size_t entering = price();
      if (entering == n_ + m_) return optimum(true);
      if (!enter(entering)) break;
    }
    return optimum(false);
  }

 private:
  /// The variable with the largest gain, n + m where there is none.
  std::size_t price() const {
    double best = 1e-11 * largest_;
    std::size_t entering = n_ + m_;
    for (std::size_t j = 0; j < n_; ++j) {
      if (basic_[j]) continue;
      const double gain = -reduced_cost(core_, prices_, j);
      if (gain > best) best = gain, entering = j;
    }
    for (std::size_t i = 0; i < m_; ++i) {
      if (!basic_[n_ + i] && -prices_[i] > best) best = -prices_[i], entering = n_ + i;
    }
    return entering;
  }

  /// B^-1 times the column of a variable.
  std::vector<double> direction(std::size_t variable) const {
    std::vector<double> alpha(m_, 0.0);
    const auto add = [&](std::size_t row) {
      const double* column = &inverse_[row * m_];
      for (std::size_t i = 0; i < m_; ++i) alpha[i] += column[i];
    };
    if (variable >= n_) {
      add(variable - n_);
    } else {
      for (const auto row : core_.column(variable)) add(static_cast<std::size_t>(row));
    }
    return alpha;
  }

  /// False where nothing limits the variable: rounding only, the programme is bounded.
  bool enter(std::size_t variable) {
    const auto alpha = direction(variable);
    std::size_t leaving = m_;
    double step = 0;
    for (std::size_t i = 0; i < m_; ++i) {
      if (alpha[i] < 1e-9) continue;
      const double ratio = std::max(0.0, values_[i]) / alpha[i];
      if (leaving < m_ && ratio >= step) continue;
      leaving = i;
      step = ratio;
    }
    if (leaving == m_) return false;
    pivot(variable, leaving, alpha, step);
    return true;
  }

  void pivot(std::size_t variable, std::size_t r, std::span<const double> alpha, double step) {
    const double gain =
        variable < n_ ? -reduced_cost(core_, prices_, variable) : -prices_[variable - n_];
    for (std::size_t i = 0; i < m_; ++i) values_[i] -= step * alpha[i];
    values_[r] = step;
    for (std::size_t k = 0; k < m_; ++k) {
      double* column = &inverse_[k * m_];
      if (column[r] == 0) continue;
      const double scaled = column[r] / alpha[r];
      for (std::size_t i = 0; i < m_; ++i) column[i] -= scaled * alpha[i];
      column[r] = scaled;
      prices_[k] += gain * scaled;
    }
    basic_[basis_[r]] = 0;
    basic_[variable] = 1;
    basis_[r] = variable;
    ++pivots_;
  }

  LinearOptimum optimum(bool optimal) const {
    LinearOptimum result{prices_, std::vector<double>(n_, 0.0), pivots_, optimal};
    for (std::size_t i = 0; i < m_; ++i) {
      if (basis_[i] < n_) result.shares[basis_[i]] = std::clamp(values_[i], 0.0, 1.0);
    }
    return result;
  }

  const PackingCore& core_;
  std::size_t m_, n_;
  std::vector<double> inverse_;  ///< column by column
  std::vector<double> values_;   ///< of the basic variables
  std::vector<double> prices_;
  std::vector<std::size_t> basis_;
  std::vector<char> basic_;
  double largest_ = 0;
  int pivots_ = 0;
};

}  // namespace

LinearOptimum solve_linear(const PackingCore& core, std::span<const std::int32_t> start,
                           int most_pivots) {
  Simplex simplex(core);
  simplex.start(start);
  return simplex.run(most_pivots);
}

}  // namespace scanfuse::associate
