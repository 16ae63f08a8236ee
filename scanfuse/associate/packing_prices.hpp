#pragma once

#include <span>
#include <vector>

#include "scanfuse/associate/packing_core.hpp"

/// Prices of rows: the dual of the packing's linear programme.
///
///   minimise  sum_i u_i    so that  u >= 0,  sum over rows i of column j of u_i >= w_j
namespace scanfuse::associate {

/// Feasible prices from any: each row in turn gets the least price that its columns need. Where the
/// prices are feasible before, their sum does not grow.
[[nodiscard]] std::vector<double> feasible_prices(const PackingCore& core,
                                                  std::vector<double> prices);

/// Each column's weight spread evenly over its rows, the largest share taken: feasible.
[[nodiscard]] std::vector<double> even_prices(const PackingCore& core);

/// Coordinate descent that does not get stuck. Constraints are softened with a temperature t:
///
///   minimise  sum_i u_i + t sum_j x_j,   x_j = exp((w_j - u(column j)) / t),   u >= 0
///
/// whose exact minimum over one u_i is u_i += t ln(sum of x_j over columns of row i), but not below
/// 0: Bregman's projections, Sinkhorn's algorithm for the packing polytope [Benamou2015]. At the
/// minimum the u are feasible, x is a fractional packing, and the sum of u exceeds the weight of x
/// by t times the entropy of x.
class SoftPrices {
 public:
  SoftPrices(const PackingCore& core, std::vector<double> prices);

  /// Sweeps over all rows at a temperature until the prices move by less than `settled` times the
  /// temperature, or `most` sweeps. Returns how many.
  int sweep(double temperature, int most, double settled);

  [[nodiscard]] const std::vector<double>& prices() const { return prices_; }
  /// The fractional packing at the last temperature.
  [[nodiscard]] const std::vector<double>& shares() const { return shares_; }

 private:
  void refresh(double temperature);
  double update(std::size_t row, double temperature);

  const PackingCore& core_;
  std::vector<double> prices_;
  std::vector<double> shares_;
};

}  // namespace scanfuse::associate
