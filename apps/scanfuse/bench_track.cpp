#include <cmath>

#include "bench_rows.hpp"
#include "bench_set_pieces.hpp"
#include "scanfuse/core/parallel.hpp"
#include "scanfuse/pipeline/config.hpp"
#include "track_trial.hpp"

namespace scanfuse::app {
namespace {

constexpr int kScenarios = 3;

class Rows {
 public:
  explicit Rows(std::string scenario) : scenario_(std::move(scenario)) {}
  void add(const std::string& name, double value, const std::string& unit, Target target = {}) {
    rows_.push_back({scenario_ + " " + name, value, unit, target});
  }
  [[nodiscard]] std::vector<BenchRow> take() { return std::move(rows_); }

 private:
  std::string scenario_;
  std::vector<BenchRow> rows_;
};

std::vector<BenchRow> rows_of(int scenario, const std::vector<TrackTrial>& trials) {
  Rows rows("lu2018-" + std::to_string(scenario));
  const auto mean = [&](auto&& value) { return mean_of(trials, value); };
  using T = const TrackTrial&;
  rows.add("MOTA", mean([](T t) { return t.score.clear.mota; }), "", at_least(0.90));
  double switches = 0;
  for (const auto& trial : trials) {
    switches += static_cast<double>(trial.score.clear.identity_switches);
  }
  rows.add("identity switches, all runs", switches, "", at_most(0));
  rows.add("position RMSE", mean([](T t) { return t.score.rmse.position_m; }), "m", at_most(0.20));
  const auto velocity = mean([](T t) { return t.score.rmse.velocity_m_per_s; });
  rows.add("velocity RMSE", velocity, "m/s", scenario == 1 ? at_most(0.30) : Target{});
  rows.add("GOSPA", mean([](T t) { return t.score.sets.gospa_m; }), "m", at_most(0.5));
  rows.add("median NEES", mean([](T t) { return t.score.consistency.nees_median; }), "",
           between(2, 6));
  rows.add("false tracks per frame", mean([](T t) { return t.score.ghosts_per_frame; }), "",
           at_most(0.1));
  rows.add("recall", mean([](T t) -> std::optional<double> {
             const auto& c = t.score.clear;
             return static_cast<double>(c.true_positives) /
                    static_cast<double>(c.true_positives + c.false_negatives);
           }),
           "");
  rows.add("heading RMSE mod pi", mean([](T t) { return t.score.rmse.heading_mod_pi_rad; }), "rad");
  if (scenario == 2) {
    rows.add("target 1 keeps its identity through frames 62 to 74",
             mean([](T t) -> std::optional<double> { return t.identity_kept ? 1 : 0; }), "share",
             at_least(0.95));
  }
  return rows.take();
}

}  // namespace

Result<std::vector<BenchRow>> bench_track(const SeedRange& range, const std::string& preset,
                                          const std::vector<std::string>& changes, int threads) {
  auto config = pipeline::preset(preset);
  if (!config) return tl::unexpected(config.error());
  for (const auto& assignment : changes) {
    if (auto done = set_config(*config, assignment); !done) return tl::unexpected(done.error());
  }
  const auto seeds = static_cast<std::size_t>(range.count);
  std::vector<Result<TrackTrial>> outcomes(kScenarios * seeds, TrackTrial{});
  parallel_for(outcomes.size(), threads, [&](std::size_t i) {
    const auto scenario = "lu2018-" + std::to_string(i / seeds + 1);
    outcomes[i] = run_trial(scenario, range.first + i % seeds, *config, lu2018_scoring());
  });
  std::vector<BenchRow> rows;
  for (int scenario = 0; scenario < kScenarios; ++scenario) {
    std::vector<TrackTrial> trials;
    for (std::size_t s = 0; s < seeds; ++s) {
      auto& outcome = outcomes[static_cast<std::size_t>(scenario) * seeds + s];
      if (!outcome) return tl::unexpected(outcome.error());
      trials.push_back(std::move(*outcome));
    }
    const auto more = rows_of(scenario + 1, trials);
    rows.insert(rows.end(), more.begin(), more.end());
  }
  const auto append = [&](const std::vector<BenchRow>& more) {
    rows.insert(rows.end(), more.begin(), more.end());
  };
  auto bends = bench_bends(range, *config, threads);
  if (!bends) return bends;
  append(*bends);
  append(bench_set_pieces(config->track, 5 * range.count));
  return rows;
}

}  // namespace scanfuse::app
