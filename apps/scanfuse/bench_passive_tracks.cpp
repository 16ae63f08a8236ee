#include <fmt/format.h>

#include <Eigen/Dense>

#include "bench_passive_runs.hpp"
#include "scanfuse/core/parallel.hpp"
#include "scanfuse/evaluate/evaluate.hpp"
#include "track_passive.hpp"

namespace scanfuse::app {
namespace {

using simulate::PassiveOptions;
using simulate::PassiveRecording;
using triangulate::PassiveTrackOptions;

constexpr double kNear_m = 500;

std::vector<TruthFrame> truth_of(const PassiveRecording& recording) {
  std::vector<TruthFrame> frames;
  for (std::size_t k = 0; k < recording.scans.size(); ++k) {
    TruthFrame frame;
    frame.stamp = recording.scans[k].stamp;
    frame.frame = recording.scans[k].scan;
    for (std::size_t t = 0; t < recording.targets[k].size(); ++t) {
      const auto& target = recording.targets[k][t];
      TruthObject object;
      object.id = static_cast<std::int64_t>(t);
      object.position_m = target.position_m.head<2>();
      object.z_m = target.position_m.z();
      object.velocity_m_per_s = target.velocity_m_per_s.head<2>();
      frame.objects.push_back(object);
    }
    frames.push_back(std::move(frame));
  }
  return frames;
}

struct PassiveTrackTrial {
  evaluate::Evaluation score;
  double worst_gap = 0;
  double nees = 0;  ///< sum, of the six states of confirmed tracks near a target
  std::int64_t samples = 0;
};

void add_nees(PassiveTrackTrial& trial, const triangulate::PassiveStep& step,
              const std::vector<simulate::PassiveTarget>& targets) {
  for (const auto& track : step.tracks) {
    if (!track.confirmed) continue;
    for (const auto& target : targets) {
      Eigen::Matrix<double, 6, 1> off = track.state.mean;
      off.head<3>() -= target.position_m;
      off.tail<3>() -= target.velocity_m_per_s;
      if (off.head<3>().norm() > kNear_m) continue;
      trial.nees += off.dot(track.state.covariance.ldlt().solve(off));
      ++trial.samples;
    }
  }
}

PassiveTrackTrial run_passive_trial(const PassiveRecording& recording,
                                    const PassiveTrackOptions& options) {
  triangulate::AssociationOptions association;
  association.posterior = false;
  triangulate::PassiveTracker tracker(recording.scene, options, association);
  PassiveTrackTrial trial;
  std::vector<StepResult> steps;
  for (std::size_t k = 0; k < recording.scans.size(); ++k) {
    const auto step = tracker.step(recording.scans[k]);
    if (!step) break;
    steps.push_back(as_step(recording.scans[k], *step));
    trial.worst_gap = std::max(trial.worst_gap, step->gap);
    add_nees(trial, *step, recording.targets[k]);
  }
  evaluate::EvaluateOptions scoring;
  scoring.match_m = scoring.similarity_m = kNear_m;
  scoring.gospa_c_m = 2 * kNear_m;
  trial.score = evaluate::evaluate(steps, truth_of(recording), scoring);
  return trial;
}

std::vector<PassiveTrackTrial> run_passive_trials(const PassiveOptions& scene,
                                                  const PassiveTrackOptions& options,
                                                  const SeedRange& seeds, int threads) {
  std::vector<PassiveTrackTrial> trials(static_cast<std::size_t>(seeds.count));
  parallel_for(trials.size(), threads, [&](std::size_t k) {
    const auto recording = simulate::simulate_passive(scene, seeds.first + k);
    if (recording) trials[k] = run_passive_trial(*recording, options);
  });
  return trials;
}

double nees_of(const std::vector<PassiveTrackTrial>& trials) {
  double sum = 0, samples = 0;
  for (const auto& trial : trials) {
    sum += trial.nees;
    samples += static_cast<double>(trial.samples);
  }
  return sum / samples;
}

}  // namespace

void add_passive_tracks(std::vector<BenchRow>& rows, const SeedRange& seeds, int threads) {
  PassiveOptions scene;
  scene.targets = 10;
  scene.target_layout = simulate::TargetLayout::kRandom;
  scene.speed_m_per_s = 200;
  scene.scans = 60;
  scene.detection_probability = 0.9;
  scene.false_alarms = 5;
  using T = const PassiveTrackTrial&;
  PassiveTrackOptions apart;
  apart.association = triangulate::TrackAssociation::kFixesFirst;
  const auto joint = run_passive_trials(scene, {}, seeds, threads);
  const auto fixes = run_passive_trials(scene, apart, seeds, threads);
  const auto mota = [](T t) { return t.score.clear.mota; };
  const auto gospa = [](T t) { return t.score.sets.gospa_m; };
  const auto switches = [](const std::vector<PassiveTrackTrial>& trials) {
    double sum = 0;
    for (T t : trials) sum += static_cast<double>(t.score.clear.identity_switches);
    return sum;
  };
  const std::string name = "tracks of 10 targets, PD 0.9, 5 false alarms, 5 mrad";
  rows.push_back(
      {name + ": MOTA", mean_of(joint, mota), "", {}, mean_of(fixes, mota), "fixes first"});
  rows.push_back({name + ": identity switches, all runs",
                  switches(joint),
                  "",
                  {},
                  switches(fixes),
                  "fixes first"});
  rows.push_back(
      {name + ": GOSPA", mean_of(joint, gospa), "m", {}, mean_of(fixes, gospa), "fixes first"});
  const auto rmse = mean_of(joint, [](T t) { return t.score.rmse.position_m; });
  rows.push_back({name + ": position RMSE", rmse, "m"});
  const auto gap = mean_of(joint, [](T t) { return std::optional(t.worst_gap); });
  rows.push_back({name + ": largest gap of a scan, mean", gap, "", at_most(1e-6)});
  PassiveTrackOptions matched;
  matched.sigma_accel = matched.sigma_accel_z = 0.01;
  rows.push_back({name + ": NEES, matched noise (6 is right)",
                  nees_of(run_passive_trials(scene, matched, seeds, threads)), "", between(5, 7)});
  rows.push_back({name + ": NEES, noise of targets that turn", nees_of(joint), ""});
}

}  // namespace scanfuse::app
