#pragma once

#include <array>
#include <span>
#include <utility>
#include <vector>

#include "scanfuse/associate/jpda.hpp"
#include "scanfuse/core/assignment.hpp"

/// Who belongs to whom. Sees only numbers: rows, columns, costs.
namespace scanfuse::associate {

/// A pair inside the gate, and what it costs to believe in it.
struct Candidate {
  int track = 0;
  int detection = 0;
  double cost = 0;
};

/// One to one; -1 stands for none.
struct Assignment {
  std::vector<int> detection_of_track;
  std::vector<int> track_of_detection;
};

/// `kJpda` weighs all pairs; its assignment is only who is hit by what most likely.
enum class Method { kGlobal, kNearest, kDetectionGreedy, kJpda };

constexpr auto choices(Method) {
  using enum Method;
  return std::array{std::pair{"global", kGlobal}, std::pair{"nearest", kNearest},
                    std::pair{"detection_greedy", kDetectionGreedy}, std::pair{"jpda", kJpda}};
}

/// The assignment of least total cost, where a pair left open costs `unassigned_cost` and so no
/// pair of that cost or more is made. The graph of candidates falls into connected components; each
/// is solved on its own, so the work grows with the crowd around an object and not with the scene.
/// Candidates in any order, finite costs, no pair twice; the result does not depend on the order.
[[nodiscard]] Assignment assign_global(int tracks, int detections,
                                       std::span<const Candidate> candidates,
                                       double unassigned_cost);

/// Takes pairs from the cheapest on, each track and detection once. Ties: lower track, then
/// detection.
[[nodiscard]] Assignment assign_nearest(int tracks, int detections,
                                        std::span<const Candidate> candidates,
                                        double unassigned_cost);

/// [Lu2018, sections 3.1 and 3.2]: one detection after the other takes the nearest filter that is
/// still free. Depends on the order of the detections, as printed.
[[nodiscard]] Assignment assign_detection_greedy(int tracks, int detections,
                                                 std::span<const Candidate> candidates,
                                                 double unassigned_cost);

[[nodiscard]] Assignment associate(Method method, int tracks, int detections,
                                   std::span<const Candidate> candidates, double unassigned_cost);

/// All of them with memory that is kept from scan to scan: grown once, nothing is allocated.
///
/// With `kJpda` the odds of a pair against none are exp((unassigned_cost - cost) / 2): the cost
/// m^2 + ln det S is -2 ln N(z; h(x), S) but for a constant, so `unassigned_cost` stands for
/// 2 ln(P_D / (2 pi lambda (1 - P_D P_G))). `shares` then tells the probability of each pair. A
/// track is hit when that is likelier than not, by its likeliest detection, which others may have
/// too; a detection is some track's when that is likelier than not.
class Associator {
 public:
  /// Valid until the next call.
  const Assignment& operator()(Method method, int tracks, int detections,
                               std::span<const Candidate> candidates, double unassigned_cost);

  /// Of the last call with `kJpda`: `pair` in the order of the candidates.
  [[nodiscard]] const Marginals& shares() const { return *shares_; }

 private:
  struct Edge {
    int component;
    Candidate pair;
  };
  void global(std::span<const Candidate> candidates, double unassigned_cost);
  void nearest(std::span<const Candidate> candidates, double unassigned_cost);
  void detection_greedy(std::span<const Candidate> candidates, double unassigned_cost);
  void jpda(int tracks, int detections, std::span<const Candidate> candidates,
            double unassigned_cost);
  void sort_edges(std::span<const Candidate> candidates, double unassigned_cost);
  int root(int node);
  void join_nodes(int a, int b);
  void solve_component(std::span<const Edge> edges, double unassigned_cost);
  void solve_star(std::span<const Edge> edges);
  void pair(int track, int detection);

  Assignment assignment_;
  std::vector<Candidate> sorted_;
  std::vector<int>
      parents_;  ///< union-find over tracks (0 .. tracks - 1) and detections (tracks ..)
  std::vector<Edge> edges_;
  std::vector<int> rows_, columns_;  ///< of a component: its tracks, its detections
  std::vector<double> costs_;
  AssignmentSolver solve_;
  Jpda jpda_;
  std::vector<GatedPair> pairs_;
  const Marginals* shares_ = nullptr;
  std::vector<double> claimed_, likeliest_;  ///< by detection, by track
};

}  // namespace scanfuse::associate
