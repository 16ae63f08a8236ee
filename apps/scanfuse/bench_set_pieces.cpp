#include "bench_set_pieces.hpp"

#include <fmt/format.h>
#include <time.h>

#include <algorithm>
#include <cmath>

#include "scanfuse/core/parallel.hpp"
#include "scanfuse/pipeline/config.hpp"
#include "scanfuse/simulate/set_pieces.hpp"
#include "scanfuse/simulate/simulate.hpp"
#include "track_trial.hpp"

namespace scanfuse::app {
namespace {

BenchRow upper_bounded(std::string name, double value, std::string unit, double target) {
  return {std::move(name), value, std::move(unit), at_most(target)};
}

BenchRow lower_bounded(std::string name, double value, std::string unit, double target) {
  return {std::move(name), value, std::move(unit), at_least(target)};
}

TruthFrame truth_of(const simulate::SetPiece& piece, const simulate::SceneFrame& scene,
                    std::int64_t frame) {
  TruthFrame truth{scene.stamp, frame, "world", {}};
  for (std::size_t i = 0; i < scene.truth.size(); ++i) {
    TruthObject object;
    object.id = static_cast<std::int64_t>(i) + 1;
    object.object_class = piece.movers[i].object_class;
    object.position_m = {scene.truth[i](0), scene.truth[i](2)};
    truth.objects.push_back(object);
  }
  return truth;
}

std::int64_t identity_changes(const simulate::SetPiece& piece, const track::TrackerOptions& options,
                              std::uint64_t seed) {
  track::Tracker tracker(options);
  std::vector<StepResult> steps;
  std::vector<TruthFrame> truth;
  for (const auto& scene : simulate::play(piece.movers, {}, seed)) {
    StepResult step;
    step.stamp = scene.stamp;
    step.frame = static_cast<std::int64_t>(steps.size());
    step.tracks = tracker.step(scene.stamp, scene.detections);
    truth.push_back(truth_of(piece, scene, step.frame));
    steps.push_back(std::move(step));
  }
  evaluate::EvaluateOptions scoring;
  const bool walkers = piece.movers.front().object_class == ObjectClass::kPedestrian;
  scoring.similarity_m = scoring.match_m = walkers ? 1 : 2;
  scoring.match_similarity = 0;
  return evaluate::evaluate(steps, truth, scoring).clear.identity_switches;
}

/// What the scenario's truth gives the tracker directly: every object with three returns.
evaluate::Evaluation perfectly_detected(simulate::Simulation simulation,
                                        const track::TrackerOptions& options,
                                        const evaluate::EvaluateOptions& scoring) {
  track::Tracker tracker(options);
  std::vector<StepResult> steps;
  std::vector<TruthFrame> truth;
  while (auto frame = simulation.next()) {
    StepResult step;
    step.stamp = frame->scan.stamp;
    step.frame = frame->scan.frame;
    const Eigen::Vector2d viewer =
        (frame->ego.pose * simulation.ego_from_sensor()).translation_m.head<2>();
    for (const auto& object : frame->truth.objects) {
      if (object.visible_points.value_or(0) < scoring.min_visible_points) continue;
      if (auto detection = simulate::perfect_detection(object)) {
        detection->seen_from_m = viewer;
        step.detections.push_back(*detection);
      }
    }
    step.tracks = tracker.step(step.stamp, step.detections);
    truth.push_back(std::move(frame->truth));
    steps.push_back(std::move(step));
  }
  return evaluate::evaluate(steps, truth, scoring);
}

struct BendTrial {
  evaluate::Evaluation chain, perfect;
};

Result<BendTrial> run_bend(const std::string& scenario, std::uint64_t seed,
                           const pipeline::PerceptionOptions& config) {
  evaluate::EvaluateOptions scoring;
  scoring.gospa_c_m = 3;
  scoring.min_visible_points = 3;
  auto chain = run_trial(scenario, seed, config, scoring);
  if (!chain) return tl::unexpected(chain.error());
  auto simulation = simulate::Simulation::create(scenario, seed);
  if (!simulation) return tl::unexpected(simulation.error());
  return BendTrial{std::move(chain->score),
                   perfectly_detected(std::move(*simulation), config.track, scoring)};
}

std::vector<BenchRow> bend_rows(const std::string& name, const std::vector<BendTrial>& trials,
                                double mota) {
  using T = const BendTrial&;
  const auto mean = [&](auto&& value) { return mean_of(trials, value); };
  const auto switches = [](const evaluate::Evaluation& e) -> std::optional<double> {
    return static_cast<double>(e.clear.identity_switches);
  };
  const auto plain = [](std::string row, double value, std::string unit) {
    return BenchRow{std::move(row), value, std::move(unit)};
  };
  return {
      lower_bounded(name + " MOTA", mean([](T t) { return t.chain.clear.mota; }), "", mota),
      upper_bounded(name + " identity switches a run", mean([&](T t) { return switches(t.chain); }),
                    "", 0.3),
      plain(name + " position RMSE", mean([](T t) { return t.chain.rmse.position_m; }), "m"),
      plain(name + " velocity RMSE", mean([](T t) { return t.chain.rmse.velocity_m_per_s; }),
            "m/s"),
      lower_bounded(name + " perfect detections, MOTA",
                    mean([](T t) { return t.perfect.clear.mota; }), "", mota),
      upper_bounded(name + " perfect detections, identity switches a run",
                    mean([&](T t) { return switches(t.perfect); }), "", 0.3),
      plain(name + " perfect detections, velocity RMSE",
            mean([](T t) { return t.perfect.rmse.velocity_m_per_s; }), "m/s"),
  };
}

double thread_us() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) * 1e6 + static_cast<double>(now.tv_nsec) * 1e-3;
}

/// Cars 8 m apart on a square lattice that drive the same way at 10 m/s.
std::vector<Detection> lattice(int cars, int frame, RandomStream& random) {
  const int side = static_cast<int>(std::ceil(std::sqrt(cars)));
  std::vector<Detection> detections;
  for (int i = 0; i < cars; ++i) {
    const int row = i / side, place = i % side;
    const Eigen::Vector2d at(8.0 * place + 0.8 * frame + random.normal(0, 0.1),
                             8.0 * row + random.normal(0, 0.1));
    detections.push_back(simulate::box_detection(at, 0, {at, {10, 0}}, 0.1));
  }
  return detections;
}

/// The median of 60 steps, after ten to warm up.
double step_us(int cars, const track::TrackerOptions& options) {
  RandomStream random(1);
  track::Tracker tracker(options);
  std::vector<double> times;
  for (int frame = 0; frame < 70; ++frame) {
    const auto detections = lattice(cars, frame, random);
    const double start = thread_us();
    tracker.step(time_from_seconds(0.08 * frame), detections);
    if (frame >= 10) times.push_back(thread_us() - start);
  }
  return median_of(std::move(times));
}

}  // namespace

std::vector<BenchRow> bench_set_pieces(const track::TrackerOptions& options, int runs) {
  std::vector<BenchRow> rows;
  for (const auto& piece : simulate::set_pieces()) {
    std::int64_t changes = 0;
    for (int run = 0; run < runs; ++run) {
      changes += identity_changes(piece, options, 100 + static_cast<std::uint64_t>(run));
    }
    rows.push_back(upper_bounded(fmt::format("{}, identity changes a run", piece.name),
                                 static_cast<double>(changes) / runs, "", piece.allowed));
  }
  return rows;
}

Result<std::vector<BenchRow>> bench_bends(const SeedRange& range,
                                          const pipeline::PerceptionOptions& config, int threads) {
  auto with_cyclist = pipeline::preset("road-users");
  if (!with_cyclist) return tl::unexpected(with_cyclist.error());
  with_cyclist->track.motion = config.track.motion;
  std::vector<BenchRow> rows;
  for (const bool cyclist : {false, true}) {
    const std::string name = cyclist ? "curved-road-cyclist" : "curved-road";
    const auto seeds = static_cast<std::size_t>(range.count);
    std::vector<Result<BendTrial>> outcomes(seeds, BendTrial{});
    parallel_for(seeds, threads, [&](std::size_t i) {
      outcomes[i] = run_bend(name, range.first + i, cyclist ? *with_cyclist : config);
    });
    std::vector<BendTrial> trials;
    for (auto& outcome : outcomes) {
      if (!outcome) return tl::unexpected(outcome.error());
      trials.push_back(std::move(*outcome));
    }
    const auto more = bend_rows(name, trials, cyclist ? 0.75 : 0.85);
    rows.insert(rows.end(), more.begin(), more.end());
  }
  return rows;
}

std::vector<BenchRow> bench_tracker_speed(const track::TrackerOptions& options) {
  return {lower_bounded("tracker alone, 10 cars a frame", 1e6 / step_us(10, options), "frames/s",
                        20000),
          upper_bounded("tracker alone, 2000 cars a frame", step_us(2000, options) / 1000, "ms CPU",
                        10)};
}

}  // namespace scanfuse::app
