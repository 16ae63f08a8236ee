#include "scanfuse/associate/jpda.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <tuple>
#include <utility>

#include "scanfuse/associate/log_sums.hpp"

namespace scanfuse::associate {
Marginals joint_probabilities(int tracks, int detections, std::span<const GatedPair> pairs,
                              const JpdaOptions& options) {
  return Jpda()(tracks, detections, pairs, options);
}

const Marginals& Jpda::operator()(int tracks, int detections, std::span<const GatedPair> pairs,
                                  const JpdaOptions& options) {
  marginals_.pair.assign(pairs.size(), 0);
  marginals_.missed.assign(static_cast<std::size_t>(tracks), 1);
  find_components(tracks, detections, pairs, options);
  for (std::size_t first = 0; first < edges_.size();) {
    std::size_t last = first;
    while (last < edges_.size() && edges_[last].component == edges_[first].component) ++last;
    solve({&edges_[first], last - first}, pairs, options);
    first = last;
  }
  return marginals_;
}

int Jpda::root(int node) {
  while (parents_[node] != node) node = parents_[node] = parents_[parents_[node]];
  return node;
}

void Jpda::find_components(int tracks, int detections, std::span<const GatedPair> pairs,
                           const JpdaOptions& options) {
  const double missed = 1 - options.detection_probability * options.gate_probability;
  const double log_scale =
      std::log(options.detection_probability / options.clutter_density) - std::log(missed);
  parents_.resize(static_cast<std::size_t>(tracks) + static_cast<std::size_t>(detections));
  std::iota(parents_.begin(), parents_.end(), 0);
  edges_.clear();
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const double log_ratio = pairs[i].log_likelihood + log_scale;
    if (!(log_ratio > kNever)) continue;
    edges_.push_back({0, pairs[i].track, pairs[i].detection, log_ratio, i});
    const int a = root(pairs[i].track), b = root(tracks + pairs[i].detection);
    parents_[std::max(a, b)] = std::min(a, b);
  }
  for (Edge& edge : edges_) edge.component = root(edge.row);
  std::sort(edges_.begin(), edges_.end(), [](const Edge& a, const Edge& b) {
    return std::tie(a.component, a.row, a.column) < std::tie(b.component, b.row, b.column);
  });
}

/// Numbers the tracks (or detections) of a component from zero; returns how many there are.
int Jpda::renumber(std::span<Edge> edges, int Edge::* side, std::vector<int>& numbers) {
  numbers.clear();
  for (const Edge& edge : edges) numbers.push_back(edge.*side);
  std::sort(numbers.begin(), numbers.end());
  numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
  for (Edge& edge : edges) {
    edge.*side = static_cast<int>(std::lower_bound(numbers.begin(), numbers.end(), edge.*side) -
                                  numbers.begin());
  }
  return static_cast<int>(numbers.size());
}

void Jpda::solve(std::span<Edge> edges, std::span<const GatedPair> pairs,
                 const JpdaOptions& options) {
  int rows = renumber(edges, &Edge::row, numbers_);
  int columns = renumber(edges, &Edge::column, numbers_);
  if (std::min(rows, columns) > options.exact_up_to) {
    if (options.crowd == CrowdMethod::kCheap) {
      cheap(edges, rows, columns);
    } else {
      propagate(edges, columns);
    }
    for (const Edge& e : edges) {
      double& missed = marginals_.missed[pairs[e.pair].track];
      missed = std::max(0.0, missed - marginals_.pair[e.pair]);
    }
    return;
  }
  const bool detections_are_rows = columns > rows;
  if (detections_are_rows) {
    for (Edge& edge : edges) std::swap(edge.row, edge.column);
    std::swap(rows, columns);
    std::sort(edges.begin(), edges.end(), [](const Edge& a, const Edge& b) {
      return std::tie(a.row, a.column) < std::tie(b.row, b.column);
    });
  }
  exact(edges, rows, columns);
  for (const Edge& e : edges) {
    marginals_.missed[pairs[e.pair].track] =
        detections_are_rows ? column_is_free(e.column, rows) : row_is_free(e.row);
  }
}

/// forward(i, S): the sum over ways in which rows before i take exactly the columns S.
/// backward(i, S): over ways in which rows from i on take columns outside S.
/// P(row i takes column c) = sum_S forward(i, S) r_ic backward(i+1, S + c) / backward(0, {}).
void Jpda::exact(std::span<const Edge> edges, int rows, int columns) {
  subsets_ = std::size_t{1} << static_cast<unsigned>(columns);
  sweep_forward(edges, rows);
  sweep_backward(edges, rows);
  for (const Edge& e : edges) {
    double& probability = marginals_.pair[e.pair];
    for (std::size_t set = 0; set < subsets_; ++set) {
      if ((set & bit(e)) != 0 || forward_[at(e.row, set)] == kNever) continue;
      probability += std::exp(forward_[at(e.row, set)] + e.log_ratio +
                              backward_[at(e.row + 1, set | bit(e))] - backward_[0]);
    }
  }
}

std::size_t Jpda::at(int row, std::size_t set) const {
  return static_cast<std::size_t>(row) * subsets_ + set;
}

std::size_t Jpda::bit(const Edge& edge) {
  return std::size_t{1} << static_cast<unsigned>(edge.column);
}

void Jpda::sweep_forward(std::span<const Edge> edges, int rows) {
  forward_.assign((static_cast<std::size_t>(rows) + 1) * subsets_, kNever);
  forward_[0] = 0;
  std::size_t edge = 0;
  for (int row = 0; row < rows; ++row) {
    std::copy_n(&forward_[at(row, 0)], subsets_, &forward_[at(row + 1, 0)]);
    for (; edge < edges.size() && edges[edge].row == row; ++edge) {
      const Edge& e = edges[edge];
      for (std::size_t set = 0; set < subsets_; ++set) {
        if ((set & bit(e)) != 0 || forward_[at(row, set)] == kNever) continue;
        double& sum = forward_[at(row + 1, set | bit(e))];
        sum = log_add(sum, forward_[at(row, set)] + e.log_ratio);
      }
    }
  }
}

void Jpda::sweep_backward(std::span<const Edge> edges, int rows) {
  backward_.assign((static_cast<std::size_t>(rows) + 1) * subsets_, 0);
  std::size_t edge = edges.size();
  for (int row = rows - 1; row >= 0; --row) {
    std::copy_n(&backward_[at(row + 1, 0)], subsets_, &backward_[at(row, 0)]);
    for (; edge > 0 && edges[edge - 1].row == row; --edge) {
      const Edge& e = edges[edge - 1];
      for (std::size_t set = 0; set < subsets_; ++set) {
        if ((set & bit(e)) != 0) continue;
        double& sum = backward_[at(row, set)];
        sum = log_add(sum, backward_[at(row + 1, set | bit(e))] + e.log_ratio);
      }
    }
  }
}

/// P(row takes nothing) = sum_S forward(row, S) backward(row+1, S) / backward(0, {}).
double Jpda::row_is_free(int row) const {
  double sum = 0;
  for (std::size_t set = 0; set < subsets_; ++set) {
    if (forward_[at(row, set)] == kNever) continue;
    sum += std::exp(forward_[at(row, set)] + backward_[at(row + 1, set)] - backward_[0]);
  }
  return sum;
}

/// P(no row takes the column): all ends without it.
double Jpda::column_is_free(int column, int rows) const {
  double sum = 0;
  for (std::size_t set = 0; set < subsets_; ++set) {
    if ((set >> static_cast<unsigned>(column) & 1U) != 0) continue;
    sum += std::exp(forward_[at(rows, set)] - backward_[0]);
  }
  return sum;
}

}  // namespace scanfuse::associate
