#include "scanfuse/triangulate/contested_growth.hpp"

#include <algorithm>
#include <cmath>
#include <variant>

#include "scanfuse/core/parallel.hpp"

namespace scanfuse::triangulate {
namespace {

constexpr double kSure = 7;  ///< nats: a bearing that gains less is left out as well

using Nodes = std::vector<std::int32_t>;

/// Those of ascending nodes that are joined to `node`.
Nodes joined_to(const PairGraph& graph, std::int32_t node, const Nodes& nodes) {
  const auto& joined = graph.joined[static_cast<std::size_t>(node)];
  Nodes both;
  auto at = joined.begin();
  for (const std::int32_t n : nodes) {
    while (at != joined.end() && at->node < n) ++at;
    if (at != joined.end() && at->node == n) both.push_back(n);
  }
  return both;
}

/// Grows all hypotheses that begin with one node.
class ContestedGrower {
 public:
  enum class LeaveOut { kContested, kNothing };

  ContestedGrower(const PairGraph& graph, const GrowthScene& growth, GrownColumns& out)
      : graph_(graph), growth_(growth), out_(out) {}

  /// False where more places than allowed would be looked for.
  bool grow_from(std::int32_t node, LeaveOut leave_out, int most_steps) {
    leave_out_ = leave_out;
    steps_left_ = most_steps;
    Nodes skipped, allowed;
    for (const auto& j : graph_.joined[static_cast<std::size_t>(node)]) {
      if (j.node > node) {
        allowed.push_back(j.node);
      } else if (binds(j.node)) {
        skipped.push_back(j.node);
      }
    }
    nodes_ = {node};
    lines_ = {line(node)};
    for (const std::int32_t next : allowed) take(next, nullptr, allowed, skipped);
    return steps_left_ > 0;
  }

 private:
  [[nodiscard]] const LineOfSight& line(std::int32_t node) const {
    return graph_.lines[static_cast<std::size_t>(node)];
  }

  /// Whether it must not be left out where it gains.
  [[nodiscard]] bool binds(std::int32_t node) const {
    return leave_out_ == LeaveOut::kNothing || !team(node).empty();
  }
  [[nodiscard]] const Nodes& team(std::int32_t node) const {
    return graph_.team[static_cast<std::size_t>(node)];
  }

  /// Whether ascending nodes are all of one team with `node`: then so is whatever is made of them.
  [[nodiscard]] bool all_in_team(const Nodes& nodes, std::int32_t node) const {
    return leave_out_ == LeaveOut::kNothing || std::ranges::includes(team(node), nodes);
  }

  /// Whether it would lift the weight of what lines_ holds for sure.
  [[nodiscard]] bool is_missed(std::int32_t node, const Location& at) const {
    return all_in_team(nodes_, node) &&
           gain(node, at) >= (leave_out_ == LeaveOut::kNothing ? 0 : kSure);
  }

  [[nodiscard]] bool agrees(std::int32_t node, const Location& at) const {
    const auto fit = agreement_of(line(node), at);
    return fit && fit->distance <= kSlack * growth_.gate.of(line(node).dimensions());
  }

  [[nodiscard]] double gain(std::int32_t node, const Location& at) const {
    constexpr double kNone = -1e9;
    const LineOfSight& more = line(node);
    const auto fit = agreement_of(more, at);
    if (!fit || fit->distance > kSlack * growth_.gate.of(more.dimensions())) return kNone;
    const auto s = static_cast<std::size_t>(more.sensor);
    const SensorPrior& sensor = growth_.prior.sensors[s];
    if (std::holds_alternative<EvidenceCost>(growth_.cost)) {
      const bool looks = in_field_of_view(growth_.scene.sensors[s], at.position_m);
      return sensor.log_detected - sensor.log_clutter - (looks ? sensor.log_missed : 0) -
             (more.dimensions() * kLogTwoPi + std::log(fit->determinant) + fit->distance) / 2;
    }
    std::vector<LineOfSight> all = lines_;
    all.insert(std::ranges::upper_bound(all, more.sensor, {}, &LineOfSight::sensor), more);
    const auto with = most_likely(all, at.position_m, growth_.prior.height());
    if (!with) return kNone;
    return weight({all, *with}) - weight({lines_, at});
  }

  [[nodiscard]] double weight(const Hypothesis& h) const {
    return weight_of(growth_.cost, h, growth_.scene, growth_.prior);
  }

  /// Adds `next`, one of `allowed`. `skipped`: binding nodes before the last member that are joined
  /// to all members.
  void take(std::int32_t next, const Location* at, const Nodes& allowed, const Nodes& skipped) {
    const LineOfSight& more = line(next);
    if (steps_left_ <= 0) return;
    nodes_.push_back(next);
    lines_.push_back(more);
    if (const auto place = locate(at)) {
      Nodes later, passed = skipped;
      for (const std::int32_t n : allowed) {
        if (n > next) later.push_back(n);
        if (n < next && binds(n)) passed.push_back(n);
      }
      Nodes fitting = joined_to(graph_, next, later);
      std::erase_if(fitting, [&](std::int32_t n) { return !agrees(n, *place); });
      extend(*place, fitting, joined_to(graph_, next, passed));
    }
    nodes_.pop_back();
    lines_.pop_back();
  }

  std::optional<Location> locate(const Location* before) {
    --steps_left_;
    ++out_.steps;
    auto at = before != nullptr ? most_likely(lines_, before->position_m, growth_.prior.height())
                                : most_likely(lines_, growth_.prior.height());
    if (at && at->chi2 > growth_.gate.of(degrees_of_freedom(lines_, growth_.prior))) at.reset();
    return at;
  }

  /// Keeps what is held unless a binding node is missing, and grows it. Nothing grows where all
  /// that could come is of a team with a node that is missing: it would be missing there too.
  void extend(const Location& at, const Nodes& allowed, const Nodes& skipped) {
    bool complete = true;
    for (const std::int32_t n : skipped) {
      if (!is_missed(n, at)) continue;
      complete = false;
      if (all_in_team(allowed, n)) return;
    }
    std::int32_t last_sensor = graph_.lines.back().sensor;
    for (const std::int32_t next : allowed) {
      if (line(next).sensor > last_sensor) break;
      if (binds(next) && is_missed(next, at)) {
        complete = false;
        if (all_later_in_team(allowed, next)) last_sensor = line(next).sensor;
      }
      take(next, &at, allowed, skipped);
    }
    if (!complete) return;
    const double w = weight({lines_, at});
    if (w > 0) keep(w);
  }

  [[nodiscard]] bool all_later_in_team(const Nodes& nodes, std::int32_t node) const {
    Nodes later;
    std::ranges::copy_if(nodes, std::back_inserter(later),
                         [&](std::int32_t n) { return line(n).sensor > line(node).sensor; });
    return all_in_team(later, node);
  }

  void keep(double weight) {
    for (const std::int32_t n : nodes_) {
      out_.members.push_back(graph_.places[static_cast<std::size_t>(n)]);
    }
    out_.starts.push_back(out_.members.size());
    out_.weights.push_back(weight);
  }

  const PairGraph& graph_;
  const GrowthScene& growth_;
  GrownColumns& out_;
  LeaveOut leave_out_ = LeaveOut::kContested;
  int steps_left_ = 0;
  Nodes nodes_;
  std::vector<LineOfSight> lines_;
};

void forget_columns(GrownColumns& columns) {
  columns.starts.resize(1);
  columns.members.clear();
  columns.weights.clear();
}

}  // namespace

GrownColumns grow_where_contested(const PairGraph& graph, const GrowthScene& growth, int most_steps,
                                  int threads) {
  using LeaveOut = ContestedGrower::LeaveOut;
  std::vector<GrownColumns> parts(graph.size());
  std::vector<char> cut(graph.size(), 0);  // by component
  parallel_for(parts.size(), threads, [&](std::size_t node) {
    ContestedGrower grower(graph, growth, parts[node]);
    const auto first = static_cast<std::int32_t>(node);
    if (grower.grow_from(first, LeaveOut::kContested, most_steps)) return;
    forget_columns(parts[node]);
    grower.grow_from(first, LeaveOut::kNothing, most_steps);
    parts[node].cut = {1};
  });
  GrownColumns all;
  for (std::size_t node = 0; node < parts.size(); ++node) {
    const GrownColumns& part = parts[node];
    const std::size_t base = all.members.size();
    all.members.insert(all.members.end(), part.members.begin(), part.members.end());
    all.weights.insert(all.weights.end(), part.weights.begin(), part.weights.end());
    for (std::size_t k = 1; k < part.starts.size(); ++k) {
      all.starts.push_back(base + part.starts[k]);
    }
    all.steps += part.steps;
    if (!part.cut.empty()) cut[static_cast<std::size_t>(graph.component[node])] = 1;
  }
  for (const std::int32_t c : graph.component) all.cut.push_back(cut[static_cast<std::size_t>(c)]);
  return all;
}

}  // namespace scanfuse::triangulate
