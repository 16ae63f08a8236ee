#include <algorithm>
#include <numeric>
#include <tuple>

#include "scanfuse/associate/associate.hpp"

namespace scanfuse::associate {
namespace {

/// Sorted, each once.
void make_distinct(std::vector<int>& values) {
  std::sort(values.begin(), values.end());
  values.erase(std::unique(values.begin(), values.end()), values.end());
}

int place_of(const std::vector<int>& sorted, int value) {
  return static_cast<int>(std::lower_bound(sorted.begin(), sorted.end(), value) - sorted.begin());
}

/// One track or one detection alone in its component: the cheapest pair is the answer.
template <class Edges>
bool is_star(const Edges& edges) {
  const auto& first = edges[0].pair;
  return std::ranges::all_of(edges, [&](const auto& e) { return e.pair.track == first.track; }) ||
         std::ranges::all_of(edges,
                             [&](const auto& e) { return e.pair.detection == first.detection; });
}

}  // namespace

Assignment assign_global(int tracks, int detections, std::span<const Candidate> candidates,
                         double unassigned_cost) {
  return Associator()(Method::kGlobal, tracks, detections, candidates, unassigned_cost);
}

void Associator::global(std::span<const Candidate> candidates, double unassigned_cost) {
  sort_edges(candidates, unassigned_cost);
  for (std::size_t first = 0; first < edges_.size();) {
    std::size_t last = first;
    while (last < edges_.size() && edges_[last].component == edges_[first].component) ++last;
    const std::span<const Edge> component(&edges_[first], last - first);
    if (is_star(component)) {
      solve_star(component);
    } else {
      solve_component(component, unassigned_cost);
    }
    first = last;
  }
}

/// Candidates worth less than staying alone, component by component.
void Associator::sort_edges(std::span<const Candidate> candidates, double unassigned_cost) {
  const int tracks = static_cast<int>(assignment_.detection_of_track.size());
  parents_.resize(assignment_.detection_of_track.size() + assignment_.track_of_detection.size());
  std::iota(parents_.begin(), parents_.end(), 0);
  for (const Candidate& c : candidates) {
    if (c.cost < unassigned_cost) join_nodes(c.track, tracks + c.detection);
  }
  edges_.clear();
  for (const Candidate& c : candidates) {
    if (c.cost < unassigned_cost) edges_.push_back({root(c.track), c});
  }
  std::sort(edges_.begin(), edges_.end(), [](const Edge& a, const Edge& b) {
    return std::tie(a.component, a.pair.track, a.pair.detection) <
           std::tie(b.component, b.pair.track, b.pair.detection);
  });
}

int Associator::root(int node) {
  while (parents_[node] != node) node = parents_[node] = parents_[parents_[node]];
  return node;
}

/// The lower root wins, so a component is named by its lowest track.
void Associator::join_nodes(int a, int b) {
  a = root(a);
  b = root(b);
  parents_[std::max(a, b)] = std::min(a, b);
}

void Associator::solve_component(std::span<const Edge> edges, double unassigned_cost) {
  rows_.clear();
  columns_.clear();
  for (const Edge& edge : edges) {
    rows_.push_back(edge.pair.track);
    columns_.push_back(edge.pair.detection);
  }
  make_distinct(rows_);
  make_distinct(columns_);
  costs_.assign(rows_.size() * columns_.size(), unassigned_cost);
  Eigen::Map<Eigen::MatrixXd> cost(costs_.data(), static_cast<Eigen::Index>(rows_.size()),
                                   static_cast<Eigen::Index>(columns_.size()));
  for (const Edge& edge : edges) {
    cost(place_of(rows_, edge.pair.track), place_of(columns_, edge.pair.detection)) =
        edge.pair.cost;
  }
  const auto column_of_row = solve_(cost);
  for (std::size_t row = 0; row < rows_.size(); ++row) {
    const int column = column_of_row[row];
    if (column < 0 || cost(static_cast<Eigen::Index>(row), column) >= unassigned_cost) continue;
    pair(rows_[row], columns_[column]);
  }
}

void Associator::solve_star(std::span<const Edge> edges) {
  const auto best =
      std::ranges::min_element(edges, {}, [](const Edge& edge) { return edge.pair.cost; });
  pair(best->pair.track, best->pair.detection);
}

}  // namespace scanfuse::associate
