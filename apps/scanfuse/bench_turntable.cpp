#include "bench_turntable.hpp"

#include <fmt/format.h>

#include <Eigen/Cholesky>
#include <algorithm>
#include <chrono>

#include "scanfuse/calibrate/rig_error.hpp"
#include "scanfuse/core/parallel.hpp"
#include "scanfuse/simulate/turntable_features.hpp"

namespace scanfuse::app {
namespace {

using calibrate::Systematic;
using calibrate::TurntableCalibration;
using calibrate::TurntableMethod;
using calibrate::TurntableOptions;
using simulate::TurntableNoise;

/// The axis's and the lidar's parameters; the first ten of the rig.
constexpr int kJudged = 10;

struct Outcome {
  TurntableErrors squares{};  ///< means over the seeds
  int runs = 0;
  int failed = 0;
  double covered = 0;  ///< share of 95 % intervals that hold the truth
  double nees = 0;     ///< against the bound, per parameter
  double chi2 = 0;
  double line_chi2 = 0;
  calibrate::TurntableTable1 table1;
  double seconds = 0;
};

struct Run {
  std::optional<TurntableCalibration> result;
  Rig truth;
  double seconds = 0;
};

void add(const Run& run, const calibrate::RigCovariance& bound, Outcome& sum) {
  if (!run.result) {
    ++sum.failed;
    return;
  }
  ++sum.runs;
  const TurntableErrors squares = squared_errors(run.truth, run.result->rig);
  for (std::size_t k = 0; k < squares.size(); ++k) sum.squares[k] += squares[k];
  const Eigen::Matrix<double, kJudged, 1> delta =
      calibrate::difference(run.truth, run.result->rig).head<kJudged>();
  const auto& C = run.result->covariance_hessian;
  for (int k = 0; k < kJudged; ++k) {
    if (std::abs(delta[k]) <= 1.959964 * std::sqrt(C(k, k))) sum.covered += 1.0 / kJudged;
  }
  const Eigen::Matrix<double, kJudged, kJudged> B = bound.topLeftCorner<kJudged, kJudged>();
  sum.nees += delta.dot(B.ldlt().solve(delta)) / kJudged;
  sum.chi2 += run.result->chi2_per_dof;
  sum.line_chi2 += run.result->line_chi2_per_dof;
  sum.table1.centre_mm.mean += run.result->table1.centre_mm.mean;
  sum.table1.z_axis_deg.mean += run.result->table1.z_axis_deg.mean;
  sum.table1.x_axis_deg.mean += run.result->table1.x_axis_deg.mean;
  sum.seconds += run.seconds;
}

Outcome run_turntable(const TurntableNoise& noise, const TurntableOptions& options,
                      const calibrate::RigCovariance& bound, const SeedRange& seeds, int threads) {
  std::vector<Run> runs(static_cast<std::size_t>(seeds.count));
  parallel_for(runs.size(), threads, [&](std::size_t i) {
    const auto data = simulate::simulate_turntable_features({}, noise, seeds.first + i);
    const auto start = std::chrono::steady_clock::now();
    auto result = calibrate::calibrate_turntable(data.features, options);
    runs[i].seconds =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    runs[i].truth = data.world.rig;
    if (result) runs[i].result = std::move(*result);
  });
  Outcome sum;
  for (const auto& run : runs) add(run, bound, sum);
  const double n = std::max(sum.runs, 1);
  for (double& square : sum.squares) square /= n;
  for (double* value :
       {&sum.covered, &sum.nees, &sum.chi2, &sum.line_chi2, &sum.seconds,
        &sum.table1.centre_mm.mean, &sum.table1.z_axis_deg.mean, &sum.table1.x_axis_deg.mean}) {
    *value /= n;
  }
  return sum;
}

Result<calibrate::RigCovariance> bound_of(const TurntableNoise& noise,
                                          const TurntableOptions& options) {
  TurntableNoise none{0, 0, 0, 0};
  none.range_bias_m = noise.range_bias_m;
  const auto data = simulate::simulate_turntable_features({}, none, 1);
  calibrate::TurntableNoiseModel model{noise.corner_px, noise.stripe_px, noise.range_m,
                                       noise.turntable_rad};
  return calibrate::turntable_bound(data.features, data.world.rig, data.world.camera_from_board,
                                    model, options);
}

TurntableOptions by(TurntableMethod method) {
  TurntableOptions options;
  options.method = method;
  return options;
}

std::string name_of(TurntableMethod method) {
  for (const auto& [name, choice] : choices(method)) {
    if (choice == method) return name;
  }
  return "?";
}

/// White noise: every method, the bound, consistency, the paper's own table.
void add_white(std::vector<BenchRow>& rows, const calibrate::RigCovariance& bound,
               const SeedRange& seeds, int threads) {
  const Rig truth = simulate::turntable_world().rig;
  const auto expected = expected_squares(truth, bound);
  std::vector<Outcome> all;
  for (const auto method :
       {TurntableMethod::kLiu2023, TurntableMethod::kClosedForm, TurntableMethod::kJoint}) {
    all.push_back(run_turntable({}, by(method), bound, seeds, threads));
  }
  for (std::size_t k = 0; k < kTurntableErrors.size(); ++k) {
    const TurntableError& error = kTurntableErrors[k];
    for (std::size_t m = 0; m < 3; ++m) {
      rows.push_back({fmt::format("{}: {}", error.name, choices(TurntableMethod{})[m].first),
                      std::sqrt(all[m].squares[k]), error.unit,
                      m == 2 ? at_most(error.target) : Target{}});
    }
    rows.push_back(
        {fmt::format("{}: Cramer-Rao bound", error.name), std::sqrt(expected[k]), error.unit});
  }
  const Outcome& joint = all[2];
  rows.push_back({"joint: RMS over the Cramer-Rao bound, all parameters", std::sqrt(joint.nees), "",
                  at_most(1.15)});
  double worst = 0;
  for (std::size_t k = 0; k < expected.size(); ++k) {
    worst = std::max(worst, std::sqrt(joint.squares[k] / expected[k]));
  }
  rows.push_back({"joint: the same, worst of the figures above", worst, ""});
  rows.push_back(
      {"joint: 95 % intervals that hold the truth", joint.covered, "", between(0.92, 0.98)});
  rows.push_back(
      {"joint: chi2 per degree of freedom, all points", joint.chi2, "", between(0.97, 1.03)});
  rows.push_back(
      {"joint: chi2 per degree of freedom, whole lines", joint.line_chi2, "", between(0.97, 1.03)});
  int failed = 0;
  for (const auto& outcome : all) failed += outcome.failed;
  rows.push_back({"runs that failed", static_cast<double>(failed), "", at_most(0)});
  const auto& table1 = all[0].table1;
  rows.push_back({"self-residual as in [Liu2023, Table 1] (1.12), no accuracy: centre",
                  table1.centre_mm.mean, "mm"});
  rows.push_back({"the same (0.203): z axis", table1.z_axis_deg.mean, "deg"});
  rows.push_back({"the same (0.662): x axis", table1.x_axis_deg.mean, "deg"});
}

void add_correlated(std::vector<BenchRow>& rows, const calibrate::RigCovariance& bound,
                    const SeedRange& seeds, int threads) {
  TurntableNoise noise;
  noise.stripe_line_px = 0.2;
  noise.range_line_m = 0.0003;
  for (const auto method :
       {TurntableMethod::kLiu2023, TurntableMethod::kClosedForm, TurntableMethod::kJoint}) {
    const auto outcome = run_turntable(noise, by(method), bound, seeds, threads);
    const bool joint = method == TurntableMethod::kJoint;
    const auto row = [&](std::size_t k, double target) {
      rows.push_back({fmt::format("lines share errors of 0.2 px, 0.3 mm: {}: {}",
                                  kTurntableErrors[k].name, name_of(method)),
                      std::sqrt(outcome.squares[k]), kTurntableErrors[k].unit,
                      joint && target > 0 ? at_most(target) : Target{}});
    };
    row(0, 0.06);
    row(1, 0);
    row(2, 0.25);
    if (!joint) continue;
    rows.push_back({"lines share errors: 95 % intervals that hold the truth", outcome.covered, "",
                    between(0.92, 0.98)});
  }
}

void add_bias(std::vector<BenchRow>& rows, const calibrate::RigCovariance& bound,
              const SeedRange& seeds, int threads) {
  TurntableNoise noise;
  noise.range_bias_m = 0.002;
  const auto row = [&](const std::string& name, const TurntableOptions& options, Target target) {
    const auto outcome = run_turntable(noise, options, bound, seeds, threads);
    rows.push_back({fmt::format("range bias of 2 mm: lidar centre: {}", name),
                    std::sqrt(outcome.squares[2]), "mm", target});
    return outcome;
  };
  row("liu2023", by(TurntableMethod::kLiu2023), {});
  TurntableOptions off = by(TurntableMethod::kJoint);
  off.range_bias = Systematic::kOff;
  row("joint, bias taken for 0", off, {});
  row("joint, bias found by itself", by(TurntableMethod::kJoint), at_most(0.25));
}

/// Where the time goes, on one thread at a time of the seeds.
void add_speed(std::vector<BenchRow>& rows, const calibrate::RigCovariance& bound,
               std::uint64_t seed) {
  const auto closed = run_turntable({}, by(TurntableMethod::kClosedForm), bound, {seed, 3}, 1);
  const auto joint = run_turntable({}, by(TurntableMethod::kJoint), bound, {seed, 3}, 1);
  rows.push_back(
      {"87 positions from features to the joint result", joint.seconds, "s", at_most(1)});
  rows.push_back({"of it: lines, boards, poses, closed form", closed.seconds, "s"});
  rows.push_back({"of it: refinement, noise, jackknife", joint.seconds - closed.seconds, "s"});
}

}  // namespace

Result<std::vector<BenchRow>> bench_turntable(const SeedRange& seeds, int threads) {
  const auto bound = bound_of({}, {});
  if (!bound) return tl::unexpected(bound.error());
  std::vector<BenchRow> rows;
  add_white(rows, *bound, seeds, threads);
  add_correlated(rows, *bound, seeds, threads);
  add_bias(rows, *bound, seeds, threads);
  add_speed(rows, *bound, seeds.first);
  for (auto& row : bench_turntable_images(seeds, threads)) rows.push_back(std::move(row));
  return rows;
}

}  // namespace scanfuse::app
