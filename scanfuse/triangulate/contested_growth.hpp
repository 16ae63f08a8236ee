#pragma once

#include <cstdint>
#include <vector>

#include "scanfuse/triangulate/pair_graph.hpp"

namespace scanfuse::triangulate {

struct GrownColumns {
  std::vector<std::size_t> starts{0};
  std::vector<std::int32_t> members;  ///< places in BearingScan::bearings
  std::vector<double> weights;
  std::vector<char> cut;   ///< by node: hypotheses of its component were left out unproved
  std::int64_t steps = 0;  ///< places looked for
};

/// Hypotheses of many sensors. Every subset of a target's bearings is a hypothesis too, 2^S of
/// them; nearly all are of no use. In an optimum a hypothesis leaves out a bearing b that would
/// lift its weight only where another one of the optimum holds b. Where all hypotheses with b are
/// parts of one (its team, PairGraph), that other one is a part of the same target, and the two
/// together weigh more than apart: one target less to believe in, and its misses. So hypotheses
/// within a team hold all of it, but for bearings that gain less than kSure nats. That is a rule
/// and no proof: gains are judged before the hypothesis is complete.
///
/// From every first bearing `most_steps` places are looked for; where that is not enough, again
/// without leaving out any that gains, and `cut` says that the columns may lack the best.
[[nodiscard]] GrownColumns grow_where_contested(const PairGraph& graph, const GrowthScene& growth,
                                                int most_steps, int threads);

}  // namespace scanfuse::triangulate
