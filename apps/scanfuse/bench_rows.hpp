#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "scanfuse/core/result.hpp"

namespace scanfuse::app {

/// What the project has promised of a figure: a bound from below, from above, both or none.
struct Target {
  std::optional<double> low = std::nullopt;
  std::optional<double> high = std::nullopt;
  [[nodiscard]] bool any() const { return low || high; }
  [[nodiscard]] bool met_by(double value) const {
    return (!low || value >= *low) && (!high || value <= *high);
  }
};
[[nodiscard]] inline Target at_least(double value) { return {.low = value}; }
[[nodiscard]] inline Target at_most(double value) { return {.high = value}; }
[[nodiscard]] inline Target between(double low, double high) { return {low, high}; }

/// What the data behind a figure served for.
inline constexpr const char* kChoseConstants = "chose constants";
inline constexpr const char* kReportingOnly = "reporting only";

/// One figure of a benchmark, as `scanfuse bench NAME --json` prints it.
struct BenchRow {
  std::string name;
  double value = 0;
  std::string unit;
  Target target = {};
  std::optional<double> peer = std::nullopt;  ///< of another program or method, where known
  std::string peer_name = {};
  std::string role = {};     ///< of the data: "chose constants" or "reporting only"
  std::string skipped = {};  ///< not empty: nothing was measured, and why
  [[nodiscard]] bool met() const { return target.met_by(value); }
};

/// The mean of what `value(trial)` tells, an optional number, over the trials that tell it; not a
/// number where none does.
template <class Trial, class Value>
[[nodiscard]] double mean_of(const std::vector<Trial>& trials, Value&& value) {
  double sum = 0;
  int count = 0;
  for (const Trial& trial : trials) {
    const std::optional<double> v = value(trial);
    if (!v) continue;
    sum += *v;
    ++count;
  }
  return count > 0 ? sum / count : std::nan("");
}

/// The upper one of two middles; not a number where there are none.
[[nodiscard]] inline double median_of(std::vector<double> values) {
  if (values.empty()) return std::nan("");
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// Which random scenes a benchmark draws: seeds first, first + 1, ...
struct SeedRange {
  std::uint64_t first = 1000;
  int count = 300;
};

/// Share of vehicles that each way of segmentation cuts out right against range, with and without a
/// stray return at 195 m; point IoU on random scenes; time per scan. Seeds 1-50 served for tuning.
[[nodiscard]] std::vector<BenchRow> bench_segment(const SeedRange& seeds = {});

/// The three scenarios of [Lu2018] by the chain of a preset with changes ("section.option=value"),
/// against truth. `threads` 0: one per core.
[[nodiscard]] Result<std::vector<BenchRow>> bench_track(const SeedRange& seeds,
                                                        const std::string& preset,
                                                        const std::vector<std::string>& changes,
                                                        int threads);

/// How well road users are told apart in the scenarios road-users and mixed-streets (seeds 1000
/// higher), by tracks of the preset road-users with changes, and by the intervals of [Guo] in its
/// place. What is counted stands at evaluate::ClassScore. Seeds 1 to 999 are for learning.
[[nodiscard]] Result<std::vector<BenchRow>> bench_detect(const SeedRange& seeds,
                                                         const std::vector<std::string>& changes,
                                                         int threads);

/// How long one scan of four layers, or one, and 440 columns takes on one core, the whole chain and
/// each of its stages (thread CPU time, which other processes do not lengthen; wall time beside
/// it), and how the time of clustering grows with the number of points, 1 k to 1 M.
[[nodiscard]] Result<std::vector<BenchRow>> bench_speed(std::uint64_t seed,
                                                        const std::string& preset,
                                                        const std::vector<std::string>& changes);

/// Bearings of passive sensors joined into targets: each cost's rate of tuples that are right,
/// misses and clutter, positions against the Cramer-Rao bound, cameras, the solver. No constant was
/// chosen on any of its seeds.
[[nodiscard]] std::vector<BenchRow> bench_passive(const SeedRange& seeds, int threads);

/// Curves of the same: rates against the distance between targets, time and hypotheses against
/// their number and that of the sensors, false matches against the ambiguity law.
struct PassiveCurves {
  std::vector<BenchRow> rows;
  std::string page;  ///< HTML
};
[[nodiscard]] PassiveCurves bench_passive_curves(const SeedRange& seeds, int threads);

/// Calibration of a lidar on a turntable, simulated, against truth [Liu2023]: errors by
/// every method beside the Cramer-Rao bound, coverage, errors that lines share, range bias, time;
/// the same from rendered images, with a disc measured.
[[nodiscard]] Result<std::vector<BenchRow>> bench_turntable(const SeedRange& seeds, int threads);

/// Where the recordings of `bench real` lie.
struct RealData {
  std::string folder;      ///< with datmo/ and road/kitti_seq0000/; empty: none given
  std::string full_scans;  ///< .bin files of the sequence; empty: road/kitti_seq0000/velodyne
};

/// Tracks on recordings of real scenes against motion capture and labels, by the commands that
/// docs/real-recordings.md states. What is not there is a row that says so.
[[nodiscard]] Result<std::vector<BenchRow>> bench_real(const RealData& data, int threads);

/// Three simulated sensors (SICK, ibeo, 16 layers) at full rate over loopback for `seconds`, with
/// faults: from last byte to tracks, memory, stalls, and whether every fault was counted.
[[nodiscard]] Result<std::vector<BenchRow>> bench_live(double seconds, const std::string& preset);

}  // namespace scanfuse::app
