#include "scanfuse/associate/packing_prices.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace scanfuse::associate {
namespace {

/// Its exponential can still be multiplied with another and summed up.
constexpr double kLargestExponent = 300;
constexpr double kLeastSum = 1e-130;  ///< about exp(-kLargestExponent)

}  // namespace

std::vector<double> feasible_prices(const PackingCore& core, std::vector<double> prices) {
  auto costs = reduced_costs(core, prices);
  for (std::size_t i = 0; i < core.rows.size(); ++i) {
    double least = costs[static_cast<std::size_t>(core.row(i)[0])];
    for (const auto j : core.row(i)) least = std::min(least, costs[static_cast<std::size_t>(j)]);
    const double price = std::max(0.0, prices[i] - least);
    const double step = price - prices[i];
    prices[i] = price;
    if (step == 0) continue;
    for (const auto j : core.row(i)) costs[static_cast<std::size_t>(j)] += step;
  }
  return prices;
}

std::vector<double> even_prices(const PackingCore& core) {
  std::vector<double> prices(core.rows.size(), 0.0);
  for (std::size_t j = 0; j < core.columns.size(); ++j) {
    const auto rows = core.column(j);
    const double share = core.weights[j] / static_cast<double>(rows.size());
    for (const auto row : rows) {
      auto& price = prices[static_cast<std::size_t>(row)];
      price = std::max(price, share);
    }
  }
  return prices;
}

SoftPrices::SoftPrices(const PackingCore& core, std::vector<double> prices)
    : core_(core), prices_(std::move(prices)), shares_(core.columns.size()) {}

void SoftPrices::refresh(double temperature) {
  for (std::size_t j = 0; j < shares_.size(); ++j) {
    shares_[j] =
        std::exp(std::min(kLargestExponent, -reduced_cost(core_, prices_, j) / temperature));
  }
}

/// The exact minimum over one price. Returns by how much it moved.
double SoftPrices::update(std::size_t row, double temperature) {
  double sum = 0;
  for (const auto j : core_.row(row)) sum += shares_[static_cast<std::size_t>(j)];
  const bool vanished = sum < kLeastSum;  // its inverse would be infinite
  const double rise = vanished ? -kLargestExponent : std::log(sum);
  const double price = std::max(0.0, prices_[row] + temperature * rise);
  const double step = price - prices_[row];
  if (step == 0) return 0;
  const double factor = price > 0 && !vanished ? 1 / sum : std::exp(-step / temperature);
  prices_[row] = price;
  for (const auto j : core_.row(row)) shares_[static_cast<std::size_t>(j)] *= factor;
  return std::abs(step);
}

int SoftPrices::sweep(double temperature, int most, double settled) {
  constexpr int kRefresh = 16;  // products of many factors drift and underflow
  const std::size_t rows = core_.rows.size();
  for (int sweep = 0; sweep < most; ++sweep) {
    if (sweep % kRefresh == 0) refresh(temperature);
    double moved = 0;
    for (std::size_t k = 0; k < rows; ++k) {
      const std::size_t row = sweep % 2 == 0 ? k : rows - 1 - k;
      moved = std::max(moved, update(row, temperature));
    }
    if (moved < settled * temperature) return sweep + 1;
  }
  return most;
}

}  // namespace scanfuse::associate
