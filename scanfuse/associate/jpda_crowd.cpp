#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "scanfuse/associate/jpda.hpp"
#include "scanfuse/associate/log_sums.hpp"

/// What `Jpda` does with components too large for the sum over all joint assignments.
namespace scanfuse::associate {

void Jpda::cheap(std::span<const Edge> edges, int rows, int columns) {
  row_sums_.assign(static_cast<std::size_t>(rows), kNever);
  column_sums_.assign(static_cast<std::size_t>(columns), kNever);
  for (const Edge& e : edges) {
    row_sums_[e.row] = log_add(row_sums_[e.row], e.log_ratio);
    column_sums_[e.column] = log_add(column_sums_[e.column], e.log_ratio);
  }
  for (const Edge& e : edges) {
    const double row = row_sums_[e.row], column = column_sums_[e.column];
    const double largest = std::max({row, column, 0.0});
    const double sum = std::exp(-largest) + std::exp(row - largest) + std::exp(column - largest) -
                       std::exp(e.log_ratio - largest);
    marginals_.pair[e.pair] = std::exp(e.log_ratio - largest) / sum;
  }
}

/// Goes through the edges list by list of equal `side`, and hands each edge ln(1 + the sum of the
/// others of its list), whose logarithms are `term`.
template <class Side, class Term, class Take>
void Jpda::for_each_list(std::span<const std::size_t> order, Side&& side, Term&& term,
                         Take&& take) {
  for (std::size_t first = 0; first < order.size();) {
    std::size_t last = first;
    terms_.clear();
    for (; last < order.size() && side(order[last]) == side(order[first]); ++last) {
      terms_.push_back(term(order[last]));
    }
    others_.resize(terms_.size());
    one_plus_others(terms_, others_);
    for (std::size_t i = first; i < last; ++i) take(order[i], others_[i - first]);
    first = last;
  }
}

void Jpda::propagate(std::span<const Edge> edges, int columns) {
  constexpr int kRounds = 100;
  constexpr double kSettled = 1e-6;  // far below what the method errs by
  to_detection_.assign(edges.size(), 0);
  to_track_.assign(edges.size(), 0);
  by_row_.resize(edges.size());
  std::iota(by_row_.begin(), by_row_.end(), std::size_t{0});
  by_column_ = by_row_;
  std::sort(by_column_.begin(), by_column_.end(), [&](std::size_t a, std::size_t b) {
    return std::pair{edges[a].column, a} < std::pair{edges[b].column, b};
  });
  const auto row = [&](std::size_t e) { return edges[e].row; };
  const auto column = [&](std::size_t e) { return edges[e].column; };
  const auto claim = [&](std::size_t e) { return edges[e].log_ratio + to_track_[e]; };
  const auto offer = [&](std::size_t e) { return to_detection_[e]; };

  double change = 1;
  for (int round = 0; round < kRounds && change > kSettled; ++round) {
    for_each_list(by_row_, row, claim, [&](std::size_t e, double others) {
      to_detection_[e] = edges[e].log_ratio - others;
    });
    change = 0;
    for_each_list(by_column_, column, offer, [&](std::size_t e, double others) {
      change = std::max(change, std::abs(std::exp(-others) - std::exp(to_track_[e])));
      to_track_[e] = -others;
    });
  }
  for_each_list(by_row_, row, claim, [&](std::size_t e, double others) {
    marginals_.pair[edges[e].pair] = std::exp(claim(e) - log_add(claim(e), others));
  });
  keep_detections_below_one(edges, columns);
}

/// A detection's pairs sum to at most one once the messages have settled; should they not have, the
/// surplus is taken from all of them.
void Jpda::keep_detections_below_one(std::span<const Edge> edges, int columns) {
  column_sums_.assign(static_cast<std::size_t>(columns), 0);
  for (const Edge& e : edges) column_sums_[e.column] += marginals_.pair[e.pair];
  for (const Edge& e : edges) marginals_.pair[e.pair] /= std::max(1.0, column_sums_[e.column]);
}

}  // namespace scanfuse::associate
