#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "bench_passive_runs.hpp"
#include "process_memory.hpp"
#include "scanfuse/core/parallel.hpp"
#include "scanfuse/estimate/consistency.hpp"
#include "scanfuse/report/class_report.hpp"
#include "scanfuse/triangulate/candidates.hpp"
#include "scanfuse/triangulate/closest_points.hpp"

namespace scanfuse::app {
namespace {

using report::Chart;
using report::ReportTable;
using report::Series;
using simulate::PassiveOptions;
using triangulate::CostMethod;

constexpr int kChartWidth_px = 400;
constexpr int kChartHeight_px = 300;

/// Charts and figures of one page, gathered.
struct Curves {
  std::vector<BenchRow> rows;
  std::vector<Chart> charts;
  std::vector<ReportTable> tables;
};

PassiveOptions line_of(int targets, double spacing_m, double noise_rad) {
  PassiveOptions options;
  options.targets = targets;
  options.spacing_m = spacing_m;
  options.noise_rad = noise_rad;
  return options;
}

/// Rate of exact tuples against the distance between neighbours, a curve a cost and the oracle's.
void add_rates(Curves& curves, int targets, const std::vector<double>& spacings_km,
               double noise_rad, const SeedRange& seeds, int threads) {
  const std::string scene = fmt::format("{} targets, {:g} mrad", targets, noise_rad * 1e3);
  Chart chart{scene + ": rate of exact tuples",
              "distance between neighbours [km]",
              "rate",
              {},
              kChartWidth_px,
              kChartHeight_px};
  ReportTable table{scene + ", rate by distance [km]", {"cost"}, {}};
  for (const double d : spacings_km) table.columns.push_back(fmt::format("{:g}", d));
  const auto add = [&](const std::string& name, Series::Style style, auto&& rate_at) {
    Series series{name, {}, style};
    std::vector<std::string> cells{name};
    for (const double d : spacings_km) {
      const double rate = rate_at(line_of(targets, d * 1e3, noise_rad));
      series.points.emplace_back(d, rate);
      cells.push_back(fmt::format("{:.3f}", rate));
      curves.rows.push_back({fmt::format("{}, {:g} km: {}", scene, d, name), rate, "exact"});
    }
    chart.series.push_back(std::move(series));
    table.rows.push_back(std::move(cells));
  };
  for (const auto& [name, method] : choices(CostMethod{})) {
    add(name, Series::Style::kLine, [&, cost = method](const PassiveOptions& options) {
      return run_passive(options, seeds, threads, cost).score.exact_rate();
    });
  }
  add("places known", Series::Style::kDashed,
      [&](const PassiveOptions& options) { return passive_oracle_rate(options, seeds); });
  table.note = fmt::format("{} runs a figure, seeds {} on.", seeds.count, seeds.first);
  curves.charts.push_back(std::move(chart));
  curves.tables.push_back(std::move(table));
}

/// Median time and hypotheses of a scan, and the most memory that any took, against how many
/// targets or sensors there are.
void add_growth(Curves& curves, const std::string& what, const std::vector<int>& counts,
                int PassiveOptions::* member, const PassiveOptions& base, const SeedRange& seeds) {
  Series seconds{"whole scan", {}, Series::Style::kLine};
  Series solver{"solver", {}, Series::Style::kDashed};
  Series columns{"hypotheses", {}, Series::Style::kLine};
  Series memory{"most of all scenes", {}, Series::Style::kLine};
  ReportTable table{"Growth with " + what,
                    {what, "scan, median [ms]", "solver, median [ms]", "hypotheses, median",
                     "memory, most [MB]", "not proved"},
                    {}};
  for (const int count : counts) {
    PassiveOptions options = base;
    options.*member = count;
    forget_peak_memory();
    const double held_mb = resident_mb();
    const auto outcome = run_passive(options, seeds, 1, CostMethod::kEvidence);
    const double scan_ms = median_of(outcome.seconds) * 1e3;
    const double solver_ms = median_of(outcome.solver_seconds) * 1e3;
    const double most = median_of(outcome.columns);
    const double taken_mb = std::max(0.0, peak_memory_mb() - held_mb);
    seconds.points.emplace_back(count, scan_ms);
    solver.points.emplace_back(count, solver_ms);
    columns.points.emplace_back(count, most / 1e3);
    memory.points.emplace_back(count, taken_mb);
    table.rows.push_back({fmt::format("{}", count), fmt::format("{:.2f}", scan_ms),
                          fmt::format("{:.2f}", solver_ms), fmt::format("{:.0f}", most),
                          fmt::format("{:.1f}", taken_mb),
                          fmt::format("{} of {}", outcome.unproved, outcome.seconds.size())});
    curves.rows.push_back({fmt::format("{} {}: whole scan, median", count, what), scan_ms, "ms"});
    curves.rows.push_back({fmt::format("{} {}: hypotheses, median", count, what), most, ""});
    curves.rows.push_back({fmt::format("{} {}: memory, most", count, what), taken_mb, "MB"});
  }
  table.note = fmt::format(
      "One thread, wall time, {} scenes a row from seed {} on: PD {:g}, {:g} mrad, {:g} false "
      "alarms a "
      "sensor, "
      "40 x 40 x 11 km.",
      seeds.count, seeds.first, base.detection_probability, base.noise_rad * 1e3,
      base.false_alarms);
  curves.charts.push_back({"Time of a scan against " + what,
                           what,
                           "ms",
                           {seconds, solver},
                           kChartWidth_px,
                           kChartHeight_px});
  curves.charts.push_back({"Hypotheses against " + what,
                           what,
                           "thousands",
                           {columns},
                           kChartWidth_px,
                           kChartHeight_px});
  curves.charts.push_back(
      {"Memory against " + what, what, "MB", {memory}, kChartWidth_px, kChartHeight_px});
  curves.tables.push_back(std::move(table));
}

/// Pairs of lines of two sensors that pass each other within the gate though no target made both.
double false_pairs(const simulate::PassiveRecording& recording, double gate_sigmas) {
  const auto& bearings = recording.scans[0].bearings;
  const auto lines = triangulate::lines_of_sight(recording.scans[0], recording.scene);
  std::int64_t pairs = 0;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    for (std::size_t j = 0; j < lines.size(); ++j) {
      if (bearings[i].sensor != 0 || bearings[j].sensor != 1) continue;
      if (*bearings[i].truth >= 0 && bearings[i].truth == bearings[j].truth) continue;
      const auto met = triangulate::closest_points(lines[i], lines[j]);
      pairs += met && met->sigmas_apart <= gate_sigmas;
    }
  }
  return static_cast<double>(pairs);
}

/// The ambiguity law. A line of one sensor is half a great circle at most on the sphere of the
/// other, from the direction of the first sensor to that of the line, a quarter turn on average; a
/// bearing fits by chance that lies within the gate to either side of it. Both sensors' noise adds
/// up, as for a point equally far from both.
double predicted_pairs(double bearings_each, double gate_sigmas, double sigma_rad,
                       double field_of_view_sr) {
  const double gate_area_sr = kPi / 2 * 2 * gate_sigmas * std::sqrt(2) * sigma_rad;
  return bearings_each * bearings_each * gate_area_sr / field_of_view_sr;
}

void add_ambiguity(Curves& curves, const std::vector<int>& counts, double noise_rad,
                   const SeedRange& seeds) {
  const double gate =
      std::sqrt(estimate::chi_square_quantile(triangulate::CandidateOptions{}.gate_probability, 1));
  Series law{"N^2 gate area / field of view", {}, Series::Style::kDashed};
  Series noise{"counted, bearings all around", {}, Series::Style::kDots};
  Series targets{"counted, targets in 40 x 40 x 11 km", {}, Series::Style::kLine};
  ReportTable table{fmt::format("False matches of a pair of sensors, {:g} mrad", noise_rad * 1e3),
                    {"bearings of each", "predicted", "counted, all around", "counted, targets"},
                    {}};
  for (const int count : counts) {
    PassiveOptions all_around = passive_crowd(1, noise_rad);
    all_around.targets = 0;
    all_around.sensors = 2;
    all_around.false_alarms = count;
    PassiveOptions real = all_around;
    real.targets = count;
    real.false_alarms = 0;
    double sums[2] = {0, 0};
    for (int k = 0; k < seeds.count; ++k) {
      const auto seed = seeds.first + static_cast<std::uint64_t>(k);
      if (const auto scene = simulate::simulate_passive(all_around, seed)) {
        sums[0] += false_pairs(*scene, gate);
      }
      if (const auto scene = simulate::simulate_passive(real, seed)) {
        sums[1] += false_pairs(*scene, gate);
      }
    }
    const double predicted = predicted_pairs(count, gate, noise_rad, 4 * kPi);
    const double counted = sums[0] / seeds.count, crowded = sums[1] / seeds.count;
    law.points.emplace_back(count, predicted);
    noise.points.emplace_back(count, counted);
    targets.points.emplace_back(count, crowded);
    table.rows.push_back({fmt::format("{}", count), fmt::format("{:.1f}", predicted),
                          fmt::format("{:.1f}", counted), fmt::format("{:.1f}", crowded)});
    curves.rows.push_back(
        {fmt::format("false matches of a pair, {} bearings each, all around", count),
         counted,
         "pairs",
         {},
         predicted,
         "law"});
    curves.rows.push_back({fmt::format("false matches of a pair, {} targets", count),
                           crowded,
                           "pairs",
                           {},
                           predicted,
                           "law"});
  }
  table.note = fmt::format(
      "The law: false matches of each bearing = N x gate area / field of view, so N times that in "
      "all; gate area = (pi / 2) x 2 g sqrt(2) sigma for g = {:.2f}, field of view 4 pi sr. "
      "Bearings "
      "of targets that fly low crowd near the horizon, which is a smaller field of view. Each "
      "further sensor divides what is left of false matches once more by field of view over gate "
      "area: where N times that share passes 1, more sensors are needed.",
      gate);
  curves.charts.push_back(
      {fmt::format("False matches of a pair of sensors, {:g} mrad", noise_rad * 1e3),
       "bearings of each sensor",
       "pairs",
       {law, noise, targets},
       kChartWidth_px,
       kChartHeight_px});
  curves.tables.push_back(std::move(table));
}

}  // namespace

PassiveCurves bench_passive_curves(const SeedRange& seeds, int threads) {
  Curves curves;
  std::vector<double> spacings_km;
  for (int k = 0; k <= 10; ++k) spacings_km.push_back(0.2 * k);
  for (const double noise_rad : {0.005, 0.01}) {
    add_rates(curves, 2, spacings_km, noise_rad, seeds, threads);
  }
  const SeedRange fewer{seeds.first, std::max(seeds.count / 20, 1)};
  for (const double noise_rad : {0.005, 0.01}) {
    add_rates(curves, 20, {0.5, 1.0, 1.5}, noise_rad, fewer, threads);
  }
  const SeedRange some{seeds.first, std::max(seeds.count / 200, 1)};
  PassiveOptions base = passive_crowd(0.9, 0.001);
  add_growth(curves, "targets", {10, 20, 50, 100, 200, 400, 800}, &PassiveOptions::targets, base,
             some);
  base.targets = 100;
  add_growth(curves, "sensors", {2, 3, 4, 5, 6, 8, 10, 12}, &PassiveOptions::sensors, base, some);
  add_ambiguity(curves, {10, 20, 50, 100, 200, 400}, 0.001, some);
  const std::string note =
      "Rates against the distance between targets, as figures 1 and 2 of [Lu2015] (targets from "
      "(20, 20, 8) km on along x, sensors of equal noise, PD 1, no clutter), what a scan costs, "
      "and "
      "how many false matches to expect. With equal sensors the costs hardly differ.";
  return {std::move(curves.rows),
          report::figures_page("scanfuse bench passive", note, curves.tables, curves.charts)};
}

}  // namespace scanfuse::app
