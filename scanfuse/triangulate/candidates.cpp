#include "scanfuse/triangulate/candidates.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <numeric>

#include "scanfuse/core/parallel.hpp"
#include "scanfuse/triangulate/contested_growth.hpp"
#include "scanfuse/triangulate/lines_by_sensor.hpp"

namespace scanfuse::triangulate {
namespace {

/// Everything about a scan that growing a hypothesis looks at.
struct Search {
  const PassiveScene& scene;
  const ScenePrior& prior;
  const Cost& cost;
  const std::vector<LinesOfSensor>& sensors;
  const std::vector<std::vector<EpipolarIndex>>& pairs;  ///< [a][b - a - 1]
  Gate gate;
  double sigmas = 0;  ///< of a pair's miss
  std::int64_t most = 0;
  std::atomic<std::int64_t> found{0};

  [[nodiscard]] bool too_many() const { return found.load(std::memory_order_relaxed) > most; }
};

/// Grows hypotheses from one line of sight: a partner, then sensor after sensor.
class Grower {
 public:
  Grower(Search& search, Candidates& out) : search_(search), out_(out) {}

  void grow_from(std::size_t sensor, std::size_t line) {
    const LinesOfSensor& first = search_.sensors[sensor];
    for (partner_ = sensor + 1; partner_ < search_.sensors.size(); ++partner_) {
      const LinesOfSensor& second = search_.sensors[partner_];
      search_.pairs[sensor][partner_ - sensor - 1].for_partners(
          first.lines[line], search_.sigmas, [&](std::int32_t j) {
            ++out_.tried;
            const auto place = static_cast<std::size_t>(j);
            const auto met = meeting(first.lines[line], second.lines[place], search_.sigmas);
            if (!met) return;
            lines_ = {first.lines[line], second.lines[place]};
            members_ = {first.places[line], second.places[place]};
            take(met->middle_m, sensor + 1);
          });
    }
  }

 private:
  /// Locates what lines_ holds, keeps it, and grows it by the sensors from `next` on.
  void take(const Eigen::Vector3d& start_m, std::size_t next) {
    if (search_.too_many()) return;
    const auto at = most_likely(lines_, start_m, search_.prior.height());
    if (!at || at->chi2 > search_.gate.of(degrees_of_freedom(lines_, search_.prior))) return;
    const double weight = weight_of(search_.cost, {lines_, *at}, search_.scene, search_.prior);
    if (weight > 0) keep(weight);
    for (std::size_t c = next; c < search_.sensors.size(); ++c) {
      if (c != partner_) grow_by(c, *at);
    }
  }

  /// Before the partner come only lines that could not be a partner themselves: those parallel to
  /// the first. So each hypothesis is found once.
  void grow_by(std::size_t sensor, const Location& at) {
    const LinesOfSensor& next = search_.sensors[sensor];
    const double range = (at.position_m - next.origin_m).norm();
    const double blur = std::sqrt(at.covariance_m2.trace()) / std::max(range, 1e-6);
    const double reach = kSlack * std::sqrt(search_.gate.of(2)) * (next.widest_rad + blur);
    next.by_azimuth.for_near(at.position_m, reach, [&](std::int32_t j) {
      const LineOfSight& line = next.lines[static_cast<std::size_t>(j)];
      if (!agrees(line, at)) return;
      if (sensor < partner_ && meeting(lines_.front(), line, search_.sigmas)) return;
      const auto place = std::upper_bound(
          lines_.begin(), lines_.end(), line.sensor,
          [](std::int32_t s, const LineOfSight& other) { return s < other.sensor; });
      const auto slot = place - lines_.begin();
      lines_.insert(place, line);
      members_.insert(members_.begin() + slot, next.places[static_cast<std::size_t>(j)]);
      take(at.position_m, sensor + 1);
      lines_.erase(lines_.begin() + slot);
      members_.erase(members_.begin() + slot);
    });
  }

  [[nodiscard]] bool agrees(const LineOfSight& line, const Location& at) const {
    const auto fit = agreement_of(line, at);
    return fit && fit->distance <= kSlack * search_.gate.of(line.dimensions());
  }

  void keep(double weight) {
    out_.members.insert(out_.members.end(), members_.begin(), members_.end());
    out_.starts.push_back(out_.members.size());
    out_.weights.push_back(weight);
    search_.found.fetch_add(1, std::memory_order_relaxed);
  }

  Search& search_;
  Candidates& out_;
  std::vector<LineOfSight> lines_;
  std::vector<std::int32_t> members_;
  std::size_t partner_ = 0;
};

std::vector<std::vector<EpipolarIndex>> indices_of_pairs(
    const std::vector<LinesOfSensor>& sensors) {
  std::vector<std::vector<EpipolarIndex>> pairs(sensors.size());
  for (std::size_t a = 0; a < sensors.size(); ++a) {
    for (std::size_t b = a + 1; b < sensors.size(); ++b) {
      pairs[a].emplace_back(sensors[a].origin_m, sensors[b].lines);
    }
  }
  return pairs;
}

/// Whether the indices hold out more pairs than `most`. Nothing is counted where there cannot be.
bool too_many_pairs(const Search& search, std::int64_t most) {
  const auto& sensors = search.sensors;
  std::int64_t possible = 0;
  for (std::size_t a = 0; a < sensors.size(); ++a) {
    for (std::size_t b = a + 1; b < sensors.size(); ++b) {
      possible += std::ssize(sensors[a].lines) * std::ssize(sensors[b].lines);
    }
  }
  if (possible <= most) return false;
  std::int64_t pairs = 0;
  for (std::size_t a = 0; a < sensors.size(); ++a) {
    for (const LineOfSight& line : sensors[a].lines) {
      for (const EpipolarIndex& index : search.pairs[a]) {
        index.for_partners(line, search.sigmas, [&](std::int32_t) { ++pairs; });
      }
      if (pairs > most) return true;
    }
  }
  return false;
}

/// All hypotheses at one gate; more than search.most: how many they are is all that can be used.
Candidates grow_all(Search& search, int threads) {
  constexpr std::size_t kChunk = 32;
  std::vector<std::pair<std::size_t, std::size_t>> firsts;
  for (std::size_t s = 0; s + 1 < search.sensors.size(); ++s) {
    for (std::size_t i = 0; i < search.sensors[s].lines.size(); ++i) firsts.emplace_back(s, i);
  }
  std::vector<Candidates> parts((firsts.size() + kChunk - 1) / kChunk);
  parallel_for(parts.size(), threads, [&](std::size_t part) {
    Grower grower(search, parts[part]);
    const std::size_t end = std::min(firsts.size(), (part + 1) * kChunk);
    for (std::size_t k = part * kChunk; k < end && !search.too_many(); ++k) {
      grower.grow_from(firsts[k].first, firsts[k].second);
    }
  });
  Candidates all;
  for (const Candidates& part : parts) {
    const std::size_t base = all.members.size();
    all.members.insert(all.members.end(), part.members.begin(), part.members.end());
    all.weights.insert(all.weights.end(), part.weights.begin(), part.weights.end());
    for (std::size_t k = 1; k < part.starts.size(); ++k) {
      all.starts.push_back(base + part.starts[k]);
    }
    all.tried += part.tried;
  }
  return all;
}

/// Without the columns that weigh no more than a column of theirs with one bearing less.
Candidates without_dominated(const Candidates& all) {
  std::vector<std::uint32_t> order(all.size());
  std::iota(order.begin(), order.end(), 0U);
  const auto less = [&](std::span<const std::int32_t> a, std::span<const std::int32_t> b) {
    return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end());
  };
  std::sort(order.begin(), order.end(),
            [&](auto a, auto b) { return less(all.column(a), all.column(b)); });
  std::vector<std::int32_t> fewer;
  const auto weight_without = [&](std::span<const std::int32_t> column, std::size_t left_out) {
    fewer.assign(column.begin(), column.end());
    fewer.erase(fewer.begin() + static_cast<std::ptrdiff_t>(left_out));
    const auto at = std::lower_bound(order.begin(), order.end(), fewer,
                                     [&](auto k, const auto& f) { return less(all.column(k), f); });
    return at != order.end() && std::ranges::equal(all.column(*at), fewer) ? all.weights[*at] : 0;
  };
  Candidates kept;
  for (std::size_t k = 0; k < all.size(); ++k) {
    const auto column = all.column(k);
    bool dominated = false;
    for (std::size_t m = 0; m < column.size() && column.size() > 2 && !dominated; ++m) {
      dominated = weight_without(column, m) >= all.weights[k];
    }
    if (dominated) continue;
    kept.members.insert(kept.members.end(), column.begin(), column.end());
    kept.starts.push_back(kept.members.size());
    kept.weights.push_back(all.weights[k]);
  }
  return kept;
}

bool leaves_out_subsets(const Search& search, const CandidateOptions& options) {
  const auto with =
      std::ranges::count_if(search.sensors, [](const auto& s) { return !s.lines.empty(); });
  return with >= options.many_sensors && !std::holds_alternative<RenyiLiteralCost>(search.cost);
}

Candidates grow_contested(const Search& search, const CandidateOptions& options, int threads) {
  const GrowthScene growth{search.scene, search.prior, search.cost, search.gate, search.sigmas};
  const PairGraph graph = pair_graph(search.sensors, search.pairs, growth, threads);
  GrownColumns grown = grow_where_contested(graph, growth, options.steps_per_bearing, threads);
  Candidates all;
  all.starts = std::move(grown.starts);
  all.members = std::move(grown.members);
  all.weights = std::move(grown.weights);
  all.tried = grown.steps;
  const auto prices = covering_prices(graph);
  for (std::size_t node = 0; node < graph.size(); ++node) {
    if (!grown.cut[node]) continue;
    all.cut.push_back(graph.places[node]);
    all.cut_prices.push_back(prices[node]);
  }
  return all;
}

}  // namespace

std::vector<LineOfSight> lines_of_sight(const BearingScan& scan, const PassiveScene& scene) {
  std::vector<LineOfSight> lines;
  lines.reserve(scan.bearings.size());
  for (const Bearing& bearing : scan.bearings) {
    lines.push_back(
        line_of_sight(scene.sensors[static_cast<std::size_t>(bearing.sensor)], bearing));
  }
  return lines;
}

Candidates find_candidates(const BearingScan& scan, const PassiveScene& scene,
                           const ScenePrior& prior, const Cost& cost,
                           const CandidateOptions& options, int threads) {
  constexpr double kNarrower[] = {1, 0.99, 0.9, 0.5};
  const auto sensors = lines_by_sensor(lines_of_sight(scan, scene), scene);
  const auto pairs = indices_of_pairs(sensors);
  Candidates all;
  for (const double share : kNarrower) {
    const double probability = options.gate_probability * share;
    const Gate gate(probability, scene.sensors.size());
    Search search{
        scene, prior, cost, sensors, pairs, gate, std::sqrt(gate.of(1)), options.most_candidates,
        {}};
    all.too_many = too_many_pairs(search, options.most_pairs);
    if (!all.too_many) {
      all = leaves_out_subsets(search, options) ? grow_contested(search, options, threads)
                                                : grow_all(search, threads);
    }
    all.gate_probability = probability;
    all.too_many = all.too_many || search.too_many();
    if (!all.too_many) break;
  }
  Candidates kept = all.too_many ? Candidates{} : without_dominated(all);
  kept.tried = all.tried;
  kept.gate_probability = all.gate_probability;
  kept.too_many = all.too_many;
  kept.cut = std::move(all.cut);
  kept.cut_prices = std::move(all.cut_prices);
  return kept;
}

}  // namespace scanfuse::triangulate
