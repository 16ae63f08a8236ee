#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "scanfuse/triangulate/growth.hpp"
#include "scanfuse/triangulate/lines_by_sensor.hpp"

namespace scanfuse::triangulate {

/// A scan as growing sees it.
struct GrowthScene {
  const PassiveScene& scene;
  const ScenePrior& prior;
  const Cost& cost;
  const Gate& gate;
  double sigmas = 0;  ///< of a pair's miss
};

/// Which bearings can be in one hypothesis of positive weight with which others, two by two. Every
/// such hypothesis is a clique of this graph. Nodes are bearings, ascending by sensor.
///
/// A pair that meets at x, with covariance P, bounds all hypotheses that hold it, for their
/// covariance is smaller and their chi-square is not negative:
///
///   w(D) <= base(pair) + sum over D of worth,
///   base = ln rho + sum over sensors that look at x of ln(1 - PD) + ln|2 pi P| / 2,
///   worth of a bearing = ln PD - ln(1 - PD) - ln lambda - ln|2 pi R| / 2.
///
/// A pair whose bound is not positive with the best bearing of every sensor that is joined to both
/// is no pair; that is repeated until no more fall. With many sensors next to nothing is left but
/// bearings of one target, since all that did not see a chance meeting speak against it.
struct PairGraph {
  struct Joined {
    std::int32_t node = 0;
    double base = 0;
  };
  std::vector<LineOfSight> lines;           ///< by node
  std::vector<std::int32_t> places;         ///< by node: in BearingScan::bearings
  std::vector<double> worth;                ///< by node
  std::vector<std::vector<Joined>> joined;  ///< by node, ascending
  /// By node: it and all its neighbours (but one at most) where these are one hypothesis,
  /// ascending; else empty: the node is contested, it may be wanted twice.
  std::vector<std::vector<std::int32_t>> team;
  std::vector<std::int32_t> component;  ///< by node: the smallest node that it is linked to

  [[nodiscard]] std::size_t size() const { return lines.size(); }
};

[[nodiscard]] PairGraph pair_graph(std::span<const LinesOfSensor> sensors,
                                   const std::vector<std::vector<EpipolarIndex>>& pairs,
                                   const GrowthScene& growth, int threads);

/// Prices by node that no hypothesis, found or not, exceeds: the sum over its nodes is at least its
/// weight.
[[nodiscard]] std::vector<double> covering_prices(const PairGraph& graph);

}  // namespace scanfuse::triangulate
