#pragma once

#include <functional>
#include <nlohmann/json_fwd.hpp>

#include "scanfuse/pipeline/live_stream.hpp"
#include "scanfuse/pipeline/perception.hpp"
#include "scanfuse/pipeline/scan_feed.hpp"

namespace scanfuse::app {

/// Counts how often a latency fell into each of many narrow bands, in bounded memory.
class LatencyHistogram {
 public:
  void add(double seconds);
  /// The upper end of the band that `share` of all are not beyond; 1: the longest itself. 0 where
  /// there is none.
  [[nodiscard]] double quantile(double share) const;
  [[nodiscard]] std::int64_t count() const { return count_; }

 private:
  static constexpr double kBandS = 20e-6;
  std::vector<std::int64_t> bands_ = std::vector<std::int64_t>(50'000);  ///< to one second
  std::int64_t count_ = 0;
  double longest_s_ = 0;
};

struct LiveOutcome {
  std::int64_t scans = 0;
  std::int64_t tracks = 0;     ///< that were ever confirmed
  LatencyHistogram latencies;  ///< from last byte to tracks handed over
  double longest_gap_s = 0;    ///< between two results
  Diagnostics diagnostics;
  [[nodiscard]] double latency_s(double share) const { return latencies.quantile(share); }
};

using TakeStep = std::function<Result<void>(const StepResult&, const pipeline::PosedScan&)>;

/// Tracks what the sensors see until Ctrl-C, or for `seconds` (0: no end), or until `take` fails.
/// `stream` is the one inside `feed`. `waiting` is called once, should no scan come for a while.
[[nodiscard]] Result<LiveOutcome> run_live(pipeline::ScanFeed& feed, pipeline::LiveStream& stream,
                                           const pipeline::PerceptionOptions& options,
                                           double seconds, const TakeStep& take,
                                           const std::function<void()>& waiting = {});

[[nodiscard]] nlohmann::json latency_json(const LiveOutcome& outcome);

}  // namespace scanfuse::app
