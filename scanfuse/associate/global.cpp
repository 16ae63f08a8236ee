#include <algorithm>
#include <numeric>
#include <tuple>

#include "scanfuse/associate/associate.hpp"
#include "scanfuse/core/assignment.hpp"

namespace scanfuse::associate {
namespace {

/// Union-find over tracks (0 .. tracks - 1) and detections (tracks ..).
class Forest {
 public:
  explicit Forest(int nodes) : parent_(nodes) { std::iota(parent_.begin(), parent_.end(), 0); }

  int root(int node) {
    while (parent_[node] != node) node = parent_[node] = parent_[parent_[node]];
    return node;
  }
  /// The lower root wins, so a component is named by its lowest track.
  void join(int a, int b) {
    a = root(a);
    b = root(b);
    parent_[std::max(a, b)] = std::min(a, b);
  }

 private:
  std::vector<int> parent_;
};

struct Edge {
  int component;
  Candidate pair;
};

/// Candidates worth less than staying alone, component by component.
std::vector<Edge> sorted_edges(int tracks, int detections, std::span<const Candidate> candidates,
                               double unassigned_cost) {
  Forest forest(tracks + detections);
  for (const Candidate& pair : candidates) {
    if (pair.cost < unassigned_cost) forest.join(pair.track, tracks + pair.detection);
  }
  std::vector<Edge> edges;
  edges.reserve(candidates.size());
  for (const Candidate& pair : candidates) {
    if (pair.cost < unassigned_cost) edges.push_back({forest.root(pair.track), pair});
  }
  std::sort(edges.begin(), edges.end(), [](const Edge& a, const Edge& b) {
    return std::tie(a.component, a.pair.track, a.pair.detection) <
           std::tie(b.component, b.pair.track, b.pair.detection);
  });
  return edges;
}

std::vector<int> distinct(std::span<const Edge> edges, int Candidate::* member) {
  std::vector<int> values;
  values.reserve(edges.size());
  for (const Edge& edge : edges) values.push_back(edge.pair.*member);
  std::sort(values.begin(), values.end());
  values.erase(std::unique(values.begin(), values.end()), values.end());
  return values;
}

int place_of(const std::vector<int>& sorted, int value) {
  return static_cast<int>(std::lower_bound(sorted.begin(), sorted.end(), value) - sorted.begin());
}

void solve_component(std::span<const Edge> edges, double unassigned_cost, Assignment& assignment) {
  const std::vector<int> rows = distinct(edges, &Candidate::track);
  const std::vector<int> columns = distinct(edges, &Candidate::detection);
  Eigen::MatrixXd cost =
      Eigen::MatrixXd::Constant(static_cast<Eigen::Index>(rows.size()),
                                static_cast<Eigen::Index>(columns.size()), unassigned_cost);
  for (const Edge& edge : edges) {
    cost(place_of(rows, edge.pair.track), place_of(columns, edge.pair.detection)) = edge.pair.cost;
  }
  const std::vector<int> column_of_row = solve_assignment(cost);
  for (std::size_t row = 0; row < rows.size(); ++row) {
    const int column = column_of_row[row];
    if (column < 0 || cost(static_cast<Eigen::Index>(row), column) >= unassigned_cost) continue;
    assignment.detection_of_track[rows[row]] = columns[column];
    assignment.track_of_detection[columns[column]] = rows[row];
  }
}

/// One track or one detection alone in its component: the cheapest pair is the answer.
bool is_star(std::span<const Edge> edges) {
  return std::ranges::all_of(edges,
                             [&](const Edge& e) { return e.pair.track == edges[0].pair.track; }) ||
         std::ranges::all_of(
             edges, [&](const Edge& e) { return e.pair.detection == edges[0].pair.detection; });
}

void solve_star(std::span<const Edge> edges, Assignment& assignment) {
  const auto best =
      std::ranges::min_element(edges, {}, [](const Edge& edge) { return edge.pair.cost; });
  assignment.detection_of_track[best->pair.track] = best->pair.detection;
  assignment.track_of_detection[best->pair.detection] = best->pair.track;
}

}  // namespace

Assignment assign_global(int tracks, int detections, std::span<const Candidate> candidates,
                         double unassigned_cost) {
  Assignment assignment{std::vector<int>(tracks, -1), std::vector<int>(detections, -1)};
  const std::vector<Edge> edges = sorted_edges(tracks, detections, candidates, unassigned_cost);
  for (std::size_t first = 0; first < edges.size();) {
    std::size_t last = first;
    while (last < edges.size() && edges[last].component == edges[first].component) ++last;
    const std::span<const Edge> component(&edges[first], last - first);
    if (is_star(component)) {
      solve_star(component, assignment);
    } else {
      solve_component(component, unassigned_cost, assignment);
    }
    first = last;
  }
  return assignment;
}

}  // namespace scanfuse::associate
