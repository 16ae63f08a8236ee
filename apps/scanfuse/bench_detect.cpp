#include <cmath>

#include "bench_rows.hpp"
#include "scanfuse/core/parallel.hpp"
#include "scanfuse/evaluate/class_score.hpp"
#include "scanfuse/pipeline/config.hpp"
#include "scanfuse/pipeline/pose_buffer.hpp"
#include "scanfuse/simulate/simulate.hpp"

namespace scanfuse::app {
namespace {

/// What one seed of a scenario gives to each chain.
Result<std::vector<evaluate::ClassScore>> score_seed(
    const std::string& scenario, std::uint64_t seed,
    const std::vector<pipeline::PerceptionOptions>& chains) {
  auto simulation = simulate::Simulation::create(scenario, seed);
  if (!simulation) return tl::unexpected(simulation.error());
  pipeline::PoseBuffer ego;
  std::vector<simulate::SimulatedFrame> frames;
  while (auto frame = simulation->next()) {
    ego.add(frame->ego.stamp, frame->ego.pose);
    frames.push_back(std::move(*frame));
  }
  std::vector<evaluate::ClassScore> scores;
  for (const auto& chain : chains) {
    pipeline::Perception perception(chain);
    evaluate::ClassScore score;
    for (const auto& frame : frames) {
      pipeline::PosedScan posed;
      posed.scan = frame.scan;
      posed.world_from_ego = frame.ego.pose;
      posed.ego_from_sensor = simulation->ego_from_sensor();
      posed.twist = ego.twist_at(posed.scan.stamp);
      score.add(perception.step(posed), frame.truth);
    }
    scores.push_back(std::move(score));
  }
  return scores;
}

/// Where the chains are judged: the street that most was learned from, and streets of other kinds.
struct TestSet {
  std::string prefix;
  std::string scenario;
  std::uint64_t seeds_on = 0;  ///< so much is added to the seeds
};
const std::array<TestSet, 2> kTestSets{
    {{"", "road-users", 0}, {"mixed streets, ", "mixed-streets", 1000}}};

/// One score for each chain, over all seeds.
Result<std::vector<evaluate::ClassScore>> score_set(
    const TestSet& set, const SeedRange& range,
    const std::vector<pipeline::PerceptionOptions>& chains, int threads) {
  std::vector<Result<std::vector<evaluate::ClassScore>>> outcomes(
      static_cast<std::size_t>(range.count));
  parallel_for(outcomes.size(), threads, [&](std::size_t i) {
    outcomes[i] = score_seed(set.scenario, range.first + set.seeds_on + i, chains);
  });
  std::vector<evaluate::ClassScore> sums(chains.size());
  for (const auto& outcome : outcomes) {
    if (!outcome) return tl::unexpected(outcome.error());
    for (std::size_t c = 0; c < chains.size(); ++c) sums[c].merge((*outcome)[c]);
  }
  return sums;
}

struct ClassGoal {
  ObjectClass kind;
  const char* name;
  std::array<std::optional<double>, 3> at_least;  ///< to 20, 40, 50 m
};

std::vector<BenchRow> rows_of(const std::string& method, const evaluate::ClassScore& score,
                              bool promised) {
  const std::array<ClassGoal, 3> goals{{{ObjectClass::kVehicle, "car", {0.97, 0.97, 0.97}},
                                        {ObjectClass::kPedestrian, "pedestrian", {0.9, 0.8, {}}},
                                        {ObjectClass::kCyclist, "cyclist", {0.9, 0.8, {}}}}};
  std::vector<BenchRow> rows;
  const auto add = [&](const std::string& name, const std::optional<double>& value,
                       const std::string& unit, const std::optional<double>& target, bool less) {
    BenchRow row{method + " " + name, value.value_or(std::nan("")), unit};
    if (promised && target) row.target = less ? at_most(*target) : at_least(*target);
    rows.push_back(std::move(row));
  };
  for (const auto& goal : goals) {
    for (std::size_t i = 0; i < evaluate::ClassScore::kRanges_m.size(); ++i) {
      const double range_m = evaluate::ClassScore::kRanges_m[i];
      const auto to = fmt::format("{} to {:.0f} m ", goal.name, range_m);
      add(to + "precision", score.precision(goal.kind, range_m), "", goal.at_least[i], false);
      add(to + "recall", score.recall(goal.kind, range_m), "", goal.at_least[i], false);
      add(to + "recall, followed for 1 s", score.recall_of_followed(goal.kind, range_m), "",
          goal.at_least[i], false);
    }
  }
  add("clutter called a road user", score.clutter_per_scan(), "per scan", 0.1, true);
  add("of it, tracks of at least 1 s", score.old_clutter_per_scan(), "per scan", 0.1, true);
  add("of these, second tracks of a road user", score.old_seconds_per_scan(), "per scan", {}, true);
  add("expected calibration error", score.reliability().expected_calibration_error(), "", 0.05,
      true);
  return rows;
}

}  // namespace

Result<std::vector<BenchRow>> bench_detect(const SeedRange& range,
                                           const std::vector<std::string>& changes, int threads) {
  std::vector<pipeline::PerceptionOptions> chains;
  for (const char* method : {"softmax", "guo_intervals"}) {
    auto chain = pipeline::preset("road-users");
    if (!chain) return tl::unexpected(chain.error());
    for (const auto& change : changes) {
      if (auto done = set_config(*chain, change); !done) return tl::unexpected(done.error());
    }
    if (auto done = set_config(*chain, "classify", "method", method); !done) {
      return tl::unexpected(done.error());
    }
    chains.push_back(std::move(*chain));
  }
  std::vector<BenchRow> rows;
  for (const auto& set : kTestSets) {
    auto scores = score_set(set, range, chains, threads);
    if (!scores) return tl::unexpected(scores.error());
    for (std::size_t c = 0; c < chains.size(); ++c) {
      const std::string method = c == 0 ? "softmax" : "intervals of [Guo]";
      const auto more = rows_of(set.prefix + method, (*scores)[c], c == 0);
      rows.insert(rows.end(), more.begin(), more.end());
    }
  }
  return rows;
}

}  // namespace scanfuse::app
