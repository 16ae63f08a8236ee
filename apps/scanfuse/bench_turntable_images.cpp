#include <fmt/format.h>
#include <unistd.h>

#include <chrono>
#include <filesystem>

#include "bench_turntable.hpp"
#include "scanfuse/calibrate/cloud/assemble.hpp"
#include "scanfuse/calibrate/cloud/measure.hpp"
#include "scanfuse/pipeline/turntable_session.hpp"
#include "scanfuse/simulate/turntable_scans.hpp"
#include "turntable_files.hpp"

namespace scanfuse::app {
namespace {

namespace fs = std::filesystem;
using calibrate::TurntableCalibration;

constexpr int kMostSessions = 5;
constexpr int kPlacements = 10;
constexpr double kDiameter_m = 0.14;

/// A folder of its own that goes with it.
class Scratch {
 public:
  Scratch()
      : path_(fs::temp_directory_path() / fmt::format("scanfuse-bench-turntable-{}", getpid())) {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
    fs::create_directories(path_, ignored);
  }
  ~Scratch() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }
  Scratch(const Scratch&) = delete;
  Scratch& operator=(const Scratch&) = delete;
  [[nodiscard]] const fs::path& path() const { return path_; }

 private:
  fs::path path_;
};

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

struct SessionRun {
  TurntableErrors squares{};
  std::size_t used = 0;
  std::size_t positions = 0;
  calibrate::TurntableRms rms;
  double chi2 = 0;
  double seconds_files = 0, seconds_boards = 0, seconds_stripes = 0, seconds_joint = 0, seconds = 0;
  std::vector<double> disc_mm;       ///< errors of the diameter
  std::vector<double> disc_sigmas;   ///< the same over what the measure states
  std::vector<double> outermost_mm;  ///< of the circle through the outermost points
  std::string fault;
};

void measure_discs(const simulate::SimulatedTurntable& made, const Rig& rig, std::uint64_t seed,
                   int threads, SessionRun& run) {
  const auto sweeps = simulate::simulate_disc_sweeps(made.world, {}, kPlacements, seed, threads);
  for (const auto& sweep : sweeps) {
    std::vector<TurntablePosition> positions(sweep.scans.size());
    for (std::size_t k = 0; k < positions.size(); ++k) {
      positions[k].turntable_rad = sweep.turntable_rad[k];
      positions[k].scan = sweep.scans[k];
    }
    const auto cloud = calibrate::assemble(positions, rig);
    if (!cloud) continue;
    const auto disc = calibrate::measure_disc(cloud->cloud, {}, {}, rig);
    if (!disc) continue;
    const double error = disc->diameter_m.value - kDiameter_m;
    run.disc_mm.push_back(1e3 * error);
    run.disc_sigmas.push_back(error / disc->diameter_m.sigma());
    run.outermost_mm.push_back(1e3 * (disc->outermost_diameter_m - kDiameter_m));
  }
}

/// One session through files: rendered, written, read, calibrated.
SessionRun run_session(std::uint64_t seed, int threads) {
  SessionRun run;
  const Scratch scratch;
  auto made = simulate::simulate_turntable_features({}, {}, seed);
  const auto scans = simulate::simulate_scans(made.world, {}, seed, made.turned_rad, threads);
  for (std::size_t k = 0; k < scans.size(); ++k) made.features.positions[k].scan = scans[k];
  const SessionImageOptions images{{}, false, seed, threads, {}};
  Result<void> wrote = write_session_about(scratch.path(), made);
  if (wrote) wrote = write_session_scans(scratch.path(), made);
  if (wrote) wrote = write_session_images(scratch.path(), made, images);
  if (!wrote) {
    run.fault = wrote.error().message;
    return run;
  }
  pipeline::SessionLoadOptions options;
  options.threads = threads;
  const auto start = std::chrono::steady_clock::now();
  const auto session = pipeline::load_turntable_session(scratch.path(), options);
  const auto loaded = std::chrono::steady_clock::now();
  const auto result = session ? calibrate::calibrate_turntable(session->features)
                              : Result<TurntableCalibration>(tl::unexpected(session.error()));
  if (!result) {
    run.fault = result.error().message;
    return run;
  }
  run.seconds = seconds_since(start);
  run.seconds_joint = seconds_since(loaded);
  run.seconds_files = session->seconds_files;
  run.seconds_boards = session->seconds_boards;
  run.seconds_stripes = session->seconds_stripes;
  run.squares = squared_errors(made.world.rig, result->rig);
  run.used = static_cast<std::size_t>(result->positions_used);
  run.positions = result->positions.size();
  run.rms = result->rms;
  run.chi2 = result->line_chi2_per_dof;
  measure_discs(made, result->rig, seed, threads, run);
  return run;
}

struct Spread {
  double mean = 0, deviation = 0, rms = 0;
};

Spread spread_of(const std::vector<double>& values) {
  Spread spread;
  const auto n = static_cast<double>(values.size());
  for (const double value : values) {
    spread.mean += value / n;
    spread.rms += value * value / n;
  }
  spread.deviation = std::sqrt(std::max(spread.rms - spread.mean * spread.mean, 0.0));
  spread.rms = std::sqrt(spread.rms);
  return spread;
}

std::vector<double> all_of(const std::vector<SessionRun>& runs,
                           std::vector<double> SessionRun::* which) {
  std::vector<double> all;
  for (const auto& run : runs) all.insert(all.end(), (run.*which).begin(), (run.*which).end());
  return all;
}

void add_errors(std::vector<BenchRow>& rows, const std::vector<SessionRun>& runs) {
  const auto mean = [&](auto&& value) {
    return mean_of(runs, [&](const SessionRun& run) {
      return run.fault.empty() ? std::optional<double>(value(run)) : std::nullopt;
    });
  };
  for (std::size_t k = 0; k < kTurntableErrors.size(); ++k) {
    const auto& error = kTurntableErrors[k];
    rows.push_back({fmt::format("from rendered images: {}: joint", error.name),
                    std::sqrt(mean([&](const SessionRun& run) { return run.squares[k]; })),
                    error.unit, at_most(error.target)});
  }
  const auto row = [&](const char* name, const char* unit, auto&& value) {
    rows.push_back({fmt::format("from rendered images: {}", name), mean(value), unit});
  };
  row("positions used, of 87", "", [](const SessionRun& r) { return static_cast<double>(r.used); });
  row("rms of corners", "px", [](const SessionRun& r) { return r.rms.corner_px; });
  row("rms of stripe points", "px", [](const SessionRun& r) { return r.rms.stripe_px; });
  row("rms of returns", "mm", [](const SessionRun& r) { return r.rms.lidar_mm; });
  double failed = 0;
  for (const auto& run : runs) failed += run.fault.empty() ? 0 : 1;
  rows.push_back({"from rendered images: runs that failed", failed, "", at_most(0)});
  const double seconds = mean([](const SessionRun& r) { return r.seconds; });
  rows.push_back({"87 positions from images to the joint result", seconds, "s", at_most(3)});
  row("of it: session and scans", "s", [](const SessionRun& r) { return r.seconds_files; });
  row("of it: boards", "s", [](const SessionRun& r) { return r.seconds_boards; });
  row("of it: images and stripes", "s", [](const SessionRun& r) { return r.seconds_stripes; });
  row("of it: calibration", "s", [](const SessionRun& r) { return r.seconds_joint; });
}

void add_discs(std::vector<BenchRow>& rows, const std::vector<SessionRun>& runs) {
  const auto errors = spread_of(all_of(runs, &SessionRun::disc_mm));
  const auto outermost = spread_of(all_of(runs, &SessionRun::outermost_mm));
  const auto sigmas = spread_of(all_of(runs, &SessionRun::disc_sigmas));
  double missing = 0;
  for (const auto& run : runs) missing += kPlacements - static_cast<double>(run.disc_mm.size());
  rows.push_back(
      {"disc of 140 mm, ten placements a session: bias", errors.mean, "mm", between(-0.3, 0.3)});
  rows.push_back({"disc: standard deviation", errors.deviation, "mm", at_most(0.3)});
  rows.push_back({"disc: error over its stated uncertainty, rms", sigmas.rms, ""});
  rows.push_back({"disc: outermost points, bias (paper -1.51)", outermost.mean, "mm"});
  rows.push_back({"disc: outermost points, deviation (paper 2.87)", outermost.deviation, "mm"});
  rows.push_back({"disc: placements that were not measured", missing, "", at_most(0)});
}

}  // namespace

std::vector<BenchRow> bench_turntable_images(const SeedRange& seeds, int threads) {
  std::vector<SessionRun> runs;
  for (int k = 0; k < std::min(seeds.count, kMostSessions); ++k) {
    runs.push_back(run_session(seeds.first + static_cast<std::uint64_t>(k), threads));
  }
  std::vector<BenchRow> rows;
  add_errors(rows, runs);
  add_discs(rows, runs);
  return rows;
}

}  // namespace scanfuse::app
