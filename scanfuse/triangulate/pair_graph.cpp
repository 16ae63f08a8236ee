#include "scanfuse/triangulate/pair_graph.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>
#include <variant>

#include "scanfuse/core/disjoint_sets.hpp"
#include "scanfuse/core/parallel.hpp"

namespace scanfuse::triangulate {
namespace {

using Joined = PairGraph::Joined;
constexpr double kMargin = 2;  ///< nats: for places near the edge of a field of view

/// ln rho + ln|2 pi P| / 2 (for costs that count them) + what all sensors that look there charge
/// for missing it.
double base_of(const Location& at, const GrowthScene& growth) {
  const ScenePrior& prior = growth.prior;
  double base = 0;
  for (std::size_t s = 0; s < growth.scene.sensors.size(); ++s) {
    if (in_field_of_view(growth.scene.sensors[s], at.position_m)) {
      base += prior.sensors[s].log_missed;
    }
  }
  if (!std::holds_alternative<EvidenceCost>(growth.cost)) return base;
  base += prior.log_intensity + 1.5 * kLogTwoPi + std::log(at.covariance_m2.determinant()) / 2;
  if (prior.flat) {
    base += std::log(prior.volume_m[2][1] - prior.volume_m[2][0]) -
            (kLogTwoPi + std::log(prior.place.covariance(2, 2))) / 2;
  }
  return base;
}

double worth_of(const LineOfSight& line, const ScenePrior& prior) {
  const SensorPrior& sensor = prior.sensors[static_cast<std::size_t>(line.sensor)];
  return sensor.log_detected - sensor.log_missed - sensor.log_clutter - line.log_spread();
}

void add_nodes(PairGraph& graph, std::span<const LinesOfSensor> sensors, const ScenePrior& prior) {
  for (const LinesOfSensor& sensor : sensors) {
    graph.lines.insert(graph.lines.end(), sensor.lines.begin(), sensor.lines.end());
    graph.places.insert(graph.places.end(), sensor.places.begin(), sensor.places.end());
  }
  for (const LineOfSight& line : graph.lines) graph.worth.push_back(worth_of(line, prior));
  graph.joined.resize(graph.size());
}

/// Pairs of a node with nodes of later sensors; base: NaN where they are nearly parallel.
std::vector<Joined> pairs_of(const PairGraph& graph, std::size_t node, std::size_t line,
                             std::span<const LinesOfSensor> sensors,
                             const std::vector<EpipolarIndex>& indices, std::size_t sensor,
                             std::span<const std::size_t> firsts, const GrowthScene& growth) {
  std::vector<Joined> found;
  const LineOfSight& mine = sensors[sensor].lines[line];
  for (std::size_t other = sensor + 1; other < sensors.size(); ++other) {
    indices[other - sensor - 1].for_partners(mine, growth.sigmas, [&](std::int32_t j) {
      const std::size_t partner = firsts[other] + static_cast<std::size_t>(j);
      const std::array lines{graph.lines[node], graph.lines[partner]};
      Joined joined{static_cast<std::int32_t>(partner), std::numeric_limits<double>::quiet_NaN()};
      if (!nearly_parallel(lines[0], lines[1])) {
        const auto met = meeting(lines[0], lines[1], growth.sigmas);
        if (!met) return;
        const auto at = most_likely(lines, met->middle_m, growth.prior.height());
        if (!at || at->chi2 > growth.gate.of(degrees_of_freedom(lines, growth.prior))) return;
        joined.base = base_of(*at, growth);
      }
      found.push_back(joined);
    });
  }
  std::ranges::sort(found, {}, &Joined::node);
  return found;
}

void add_pairs(PairGraph& graph, std::span<const LinesOfSensor> sensors,
               const std::vector<std::vector<EpipolarIndex>>& pairs, const GrowthScene& growth,
               int threads) {
  std::vector<std::size_t> firsts{0};
  for (const LinesOfSensor& s : sensors) firsts.push_back(firsts.back() + s.lines.size());
  std::vector<std::vector<Joined>> forward(graph.size());
  parallel_for(graph.size(), threads, [&](std::size_t node) {
    const auto sensor = static_cast<std::size_t>(graph.lines[node].sensor);
    forward[node] = pairs_of(graph, node, node - firsts[sensor], sensors, pairs[sensor], sensor,
                             firsts, growth);
  });
  double most = -std::numeric_limits<double>::infinity();
  for (const auto& list : forward) {
    for (const Joined& j : list) most = std::isnan(j.base) ? most : std::max(most, j.base);
  }
  // A hypothesis with parallel lines holds another pair that meets.
  for (std::size_t a = 0; a < forward.size(); ++a) {
    for (Joined& j : forward[a]) {
      if (std::isnan(j.base)) j.base = most;
      graph.joined[static_cast<std::size_t>(j.node)].push_back(
          {static_cast<std::int32_t>(a), j.base});
    }
  }
  for (std::size_t a = 0; a < forward.size(); ++a) {
    graph.joined[a].insert(graph.joined[a].end(), forward[a].begin(), forward[a].end());
  }
}

/// The best worth of each sensor that is joined to both, added up.
double support_of(const PairGraph& graph, std::int32_t a, std::int32_t b) {
  const auto& one = graph.joined[static_cast<std::size_t>(a)];
  const auto& other = graph.joined[static_cast<std::size_t>(b)];
  double sum = 0, best = 0;
  std::int32_t sensor = -1;
  for (std::size_t i = 0, j = 0; i < one.size() && j < other.size();) {
    if (one[i].node != other[j].node) {
      one[i].node < other[j].node ? ++i : ++j;
      continue;
    }
    const auto node = static_cast<std::size_t>(one[i].node);
    if (graph.lines[node].sensor != sensor) {
      sum += best;
      best = 0;
      sensor = graph.lines[node].sensor;
    }
    best = std::max(best, graph.worth[node]);
    ++i, ++j;
  }
  return sum + best;
}

/// Drops pairs whose bound is not positive; whether there were any.
bool drop_pairs(PairGraph& graph, int threads) {
  std::vector<std::vector<Joined>> kept(graph.size());
  parallel_for(graph.size(), threads, [&](std::size_t a) {
    const auto node = static_cast<std::int32_t>(a);
    for (const Joined& j : graph.joined[a]) {
      const double bound = j.base + graph.worth[a] + graph.worth[static_cast<std::size_t>(j.node)] +
                           support_of(graph, node, j.node);
      if (bound > -kMargin) kept[a].push_back(j);
    }
  });
  bool dropped = false;
  for (std::size_t a = 0; a < kept.size(); ++a) {
    dropped = dropped || kept[a].size() != graph.joined[a].size();
  }
  graph.joined.swap(kept);
  return dropped;
}

void find_components(PairGraph& graph) {
  DisjointSets sets;
  sets.reset(graph.size());
  for (std::size_t a = 0; a < graph.size(); ++a) {
    for (const Joined& j : graph.joined[a]) {
      sets.join(static_cast<std::uint32_t>(a), static_cast<std::uint32_t>(j.node));
    }
  }
  graph.component.resize(graph.size());
  for (std::size_t a = 0; a < graph.size(); ++a) {
    graph.component[a] = static_cast<std::int32_t>(sets.find(static_cast<std::uint32_t>(a)));
  }
}

/// The node and its neighbours, one of them left out if need be, where they are one hypothesis.
std::vector<std::int32_t> team_of(const PairGraph& graph, std::size_t node,
                                  const GrowthScene& growth) {
  std::vector<std::int32_t> team{static_cast<std::int32_t>(node)};
  std::int32_t sensor = -1;
  for (const Joined& j : graph.joined[node]) {
    const std::int32_t other = graph.lines[static_cast<std::size_t>(j.node)].sensor;
    if (other == sensor) return {};
    sensor = other;
    team.push_back(j.node);
  }
  constexpr std::size_t kLeast = 4;  // to tell who of them is off
  for (int left_out = 0; left_out < 2 && team.size() > 1; ++left_out) {
    std::vector<LineOfSight> lines;
    lines.reserve(team.size());
    for (const auto n : team) lines.push_back(graph.lines[static_cast<std::size_t>(n)]);
    const auto at = most_likely(lines, growth.prior.height());
    if (!at) return {};
    if (at->chi2 <= growth.gate.of(degrees_of_freedom(lines, growth.prior))) {
      std::ranges::sort(team);
      return team;
    }
    const auto off = [&](const LineOfSight& line) {
      const auto fit = agreement_of(line, *at);
      return fit ? fit->distance : std::numeric_limits<double>::infinity();
    };
    const auto worst = std::ranges::max_element(lines, {}, off) - lines.begin();
    if (worst == 0 || lines.size() <= kLeast) return {};
    team.erase(team.begin() + worst);
  }
  return {};
}

}  // namespace

PairGraph pair_graph(std::span<const LinesOfSensor> sensors,
                     const std::vector<std::vector<EpipolarIndex>>& pairs,
                     const GrowthScene& growth, int threads) {
  PairGraph graph;
  add_nodes(graph, sensors, growth.prior);
  add_pairs(graph, sensors, pairs, growth, threads);
  while (drop_pairs(graph, threads)) {
  }
  find_components(graph);
  graph.team.resize(graph.size());
  parallel_for(graph.size(), threads,
               [&](std::size_t node) { graph.team[node] = team_of(graph, node, growth); });
  return graph;
}

/// worth + base / n, where n sensors are joined to it and base is the best of its pairs: over at
/// most n nodes of a hypothesis that adds up to no less than the least base of its pairs.
std::vector<double> covering_prices(const PairGraph& graph) {
  std::vector<double> prices(graph.size(), 0);
  for (std::size_t node = 0; node < prices.size(); ++node) {
    if (graph.joined[node].empty()) continue;
    double base = -std::numeric_limits<double>::infinity();
    int sensors = 1;
    std::int32_t last = -1;
    for (const Joined& j : graph.joined[node]) {
      base = std::max(base, j.base);
      const std::int32_t sensor = graph.lines[static_cast<std::size_t>(j.node)].sensor;
      if (sensor != last) ++sensors;
      last = sensor;
    }
    prices[node] = std::max(0.0, graph.worth[node] + (base > 0 ? base / 2 : base / sensors));
  }
  return prices;
}

}  // namespace scanfuse::triangulate
