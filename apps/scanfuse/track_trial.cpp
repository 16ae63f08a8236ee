#include "track_trial.hpp"

#include "scanfuse/simulate/simulate.hpp"

namespace scanfuse::app {
namespace {

constexpr std::int64_t kHiddenFrom = 62;
constexpr std::int64_t kHiddenUntil = 74;

/// The track that follows target 1 just before it is hidden is the one just after.
bool keeps_identity(const evaluate::Evaluation& score) {
  std::int64_t before = -1, after = -2;
  for (const auto& [frame, track] : score.identities_of(1)) {
    if (frame < kHiddenFrom) before = track;
    if (frame > kHiddenUntil + 5 && after == -2) after = track;
  }
  return before == after;
}

}  // namespace

evaluate::EvaluateOptions lu2018_scoring() {
  evaluate::EvaluateOptions scoring;
  scoring.gospa_c_m = 3;
  scoring.amota_levels = 0;
  scoring.min_visible_points = 3;
  scoring.region_y0_m = -2;
  scoring.region_y1_m = 5.4;
  return scoring;
}

Result<TrackTrial> run_trial(std::string_view scenario, std::uint64_t seed,
                             const pipeline::PerceptionOptions& options,
                             const evaluate::EvaluateOptions& scoring) {
  auto simulation = simulate::Simulation::create(scenario, seed);
  if (!simulation) return tl::unexpected(simulation.error());
  pipeline::Perception perception(options);
  pipeline::PoseBuffer ego;
  std::vector<simulate::SimulatedFrame> frames;
  while (auto frame = simulation->next()) {
    ego.add(frame->ego.stamp, frame->ego.pose);
    frames.push_back(std::move(*frame));
  }
  std::vector<StepResult> steps;
  std::vector<TruthFrame> truth;
  for (auto& frame : frames) {
    pipeline::PosedScan posed;
    posed.scan = std::move(frame.scan);
    posed.world_from_ego = frame.ego.pose;
    posed.ego_from_sensor = simulation->ego_from_sensor();
    posed.twist = ego.twist_at(posed.scan.stamp);
    steps.push_back(perception.step(posed));
    truth.push_back(std::move(frame.truth));
  }
  TrackTrial trial;
  trial.score = evaluate::evaluate(steps, truth, scoring);
  trial.identity_kept = keeps_identity(trial.score);
  return trial;
}

}  // namespace scanfuse::app
