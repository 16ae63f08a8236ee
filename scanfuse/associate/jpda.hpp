#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <tuple>
#include <utility>
#include <vector>

#include "scanfuse/core/options.hpp"

/// Joint probabilistic data association: not one assignment, but how probable each pair is when all
/// joint assignments are counted [Fortmann1983]. Sees only numbers.
namespace scanfuse::associate {

/// A pair inside the gate.
struct GatedPair {
  int track = 0;
  int detection = 0;
  double log_likelihood = 0;  ///< ln N(z; h(x), S): per unit of the measurement space
};

/// What approximates a crowd: a component with too many tracks and detections to be exact.
enum class CrowdMethod { kBeliefPropagation, kCheap };

constexpr auto choices(CrowdMethod) {
  using enum CrowdMethod;
  return std::array{std::pair{"belief_propagation", kBeliefPropagation},
                    std::pair{"cheap", kCheap}};
}

struct JpdaOptions {
  double detection_probability = 0.9;
  double gate_probability = 1;    ///< share of right pairs that the gate lets through
  double clutter_density = 1e-3;  ///< false detections per unit of the measurement space and scan
  int exact_up_to = 8;            ///< tracks or detections of a component, whichever are fewer
  CrowdMethod crowd = CrowdMethod::kBeliefPropagation;

  static constexpr auto fields() {
    using O = JpdaOptions;
    return std::tuple{
        Field{"detection_probability", &O::detection_probability, 0.01, 0.9999,
              "a track is detected with this probability"},
        Field{"gate_probability", &O::gate_probability, 0.5, 1.0,
              "share of right pairs that the gate lets through"},
        Field{"clutter_density", &O::clutter_density, 1e-12, 1e6,
              "false detections per unit of the measurement space and scan"},
        Field{"exact_up_to", &O::exact_up_to, 1, 12,
              "components with more tracks and detections than this are approximated"},
        Field{"crowd", &O::crowd, "what approximates those"},
    };
  }
};

/// Marginal probabilities. Of a track: `missed` and those of its pairs sum to one. Of a detection:
/// those of its pairs sum to at most one, the rest is clutter.
struct Marginals {
  std::vector<double> pair;    ///< in the order of the pairs given
  std::vector<double> missed;  ///< by track
};

/// Weighs every joint assignment, where a track takes at most one detection and a detection goes to
/// at most one track, by
///
///   prod over its pairs of r_td,   r_td = P_D exp(log_likelihood) / (lambda (1 - P_D P_G))
///
/// and adds up the weights of those that hold a pair. The graph of pairs falls into connected
/// components. Exact by a dynamic programme over subsets of the fewer (tracks or detections) where
/// these are at most `exact_up_to`: the work is pairs * 2^fewer. Beyond, belief propagation
/// [Williams2014], messages between tracks and detections until they settle:
///
///   mu_td = r_td / (1 + sum_(d' != d) r_td' nu_td')      nu_td = 1 / (1 + sum_(t' != t) mu_t'd)
///   beta_td = r_td nu_td / (1 + sum_d' r_td' nu_td')
///
/// or in one pass the cheap formula [Fitzgerald1986], whose mean error in simulated crowds is three
/// to seven times as large (docs/motion-models.md):
///
///   beta_td = r_td / (1 + sum_d' r_td' + sum_t' r_t'd - r_td)
///
/// Both keep the sums that `Marginals` promises; both are exact for one track or one detection
/// alone, belief propagation wherever the pairs close no circle.
///
/// Sums are taken of logarithms about their largest term: likelihoods of any size are fine, ties of
/// thousands of nats included. Pairs in any order, none twice, log-likelihoods
/// finite or -inf (what is NaN counts as -inf); 0 < P_D < 1.
class Jpda {
 public:
  /// Valid until the next call. Memory is kept: grown once, nothing is allocated.
  const Marginals& operator()(int tracks, int detections, std::span<const GatedPair> pairs,
                              const JpdaOptions& options);

 private:
  /// A pair in its component: `row` and `column` count from zero there.
  struct Edge {
    int component;
    int row, column;
    double log_ratio;
    std::size_t pair;
  };
  void find_components(int tracks, int detections, std::span<const GatedPair> pairs,
                       const JpdaOptions& options);
  int root(int node);
  void solve(std::span<Edge> edges, std::span<const GatedPair> pairs, const JpdaOptions& options);
  void exact(std::span<const Edge> edges, int rows, int columns);
  void sweep_forward(std::span<const Edge> edges, int rows);
  void sweep_backward(std::span<const Edge> edges, int rows);
  [[nodiscard]] double row_is_free(int row) const;
  [[nodiscard]] double column_is_free(int column, int rows) const;
  [[nodiscard]] std::size_t at(int row, std::size_t set) const;
  static std::size_t bit(const Edge& edge);
  void cheap(std::span<const Edge> edges, int rows, int columns);
  void propagate(std::span<const Edge> edges, int columns);
  template <class Side, class Term, class Take>
  void for_each_list(std::span<const std::size_t> order, Side&& side, Term&& term, Take&& take);
  void keep_detections_below_one(std::span<const Edge> edges, int columns);
  static int renumber(std::span<Edge> edges, int Edge::* side, std::vector<int>& numbers);

  Marginals marginals_;
  std::vector<int> parents_;
  std::vector<Edge> edges_;
  std::vector<int> numbers_;
  std::size_t subsets_ = 1;
  std::vector<double> forward_, backward_;  ///< by row and subset of columns, logarithms
  std::vector<double> row_sums_, column_sums_;
  std::vector<double> to_detection_, to_track_;  ///< ln mu, ln nu, by edge
  std::vector<double> terms_, others_;           ///< of one row or column
  std::vector<std::size_t> by_row_, by_column_;  ///< edges in these orders
};

/// The same in one call.
[[nodiscard]] Marginals joint_probabilities(int tracks, int detections,
                                            std::span<const GatedPair> pairs,
                                            const JpdaOptions& options = {});

}  // namespace scanfuse::associate
