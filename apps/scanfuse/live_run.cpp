#include "live_run.hpp"

#include <algorithm>
#include <chrono>
#include <nlohmann/json.hpp>
#include <set>

#include "command.hpp"

namespace scanfuse::app {
namespace {

using SteadyClock = std::chrono::steady_clock;

/// What changes from scan to scan, counted.
class LiveTally {
 public:
  void add(const StepResult& step, SteadyClock::time_point last_byte) {
    const auto now = SteadyClock::now();
    outcome_.latencies.add(to_seconds(now - last_byte));
    if (++outcome_.scans > 1) {
      outcome_.longest_gap_s = std::max(outcome_.longest_gap_s, to_seconds(now - last_step_));
    }
    last_step_ = now;
    for (const Track& track : step.tracks) {
      // Ids count up: only those past the last one counted are new.
      if (track.status == TrackStatus::kTentative) continue;
      if (confirmed_.insert(track.id).second) ++outcome_.tracks;
    }
    while (confirmed_.size() > kRemembered) confirmed_.erase(confirmed_.begin());
  }
  [[nodiscard]] LiveOutcome take() { return std::move(outcome_); }

 private:
  /// More are never alive at once; without a bound an endless run would fill the memory.
  static constexpr std::size_t kRemembered = 4096;
  LiveOutcome outcome_;
  std::set<std::int64_t> confirmed_;
  SteadyClock::time_point last_step_;
};

}  // namespace

void LatencyHistogram::add(double seconds) {
  const auto band = static_cast<std::size_t>(std::max(0.0, seconds) / kBandS);
  ++bands_[std::min(band, bands_.size() - 1)];
  ++count_;
  longest_s_ = std::max(longest_s_, seconds);
}

double LatencyHistogram::quantile(double share) const {
  if (count_ == 0) return 0;
  if (share >= 1) return longest_s_;
  auto left = static_cast<std::int64_t>(share * static_cast<double>(count_));
  for (std::size_t i = 0; i < bands_.size(); ++i) {
    left -= bands_[i];
    if (left < 0) return std::min(kBandS * static_cast<double>(i + 1), longest_s_);
  }
  return longest_s_;
}

Result<LiveOutcome> run_live(pipeline::ScanFeed& feed, pipeline::LiveStream& stream,
                             const pipeline::PerceptionOptions& options, double seconds,
                             const TakeStep& take, const std::function<void()>& waiting) {
  constexpr double kPatienceS = 3;
  const auto start = SteadyClock::now();
  bool is_patient = static_cast<bool>(waiting);
  stream.stop_when([&] {
    const double waited_s = to_seconds(SteadyClock::now() - start);
    if (is_patient && waited_s > kPatienceS) {
      is_patient = false;
      waiting();
    }
    return interrupted || (seconds > 0 && waited_s >= seconds);
  });
  pipeline::Perception perception(options);
  LiveTally tally;
  while (true) {
    auto posed = feed.next();
    if (!posed) return tl::unexpected(posed.error());
    if (!*posed) break;
    is_patient = false;
    const StepResult& step = perception.step(**posed);
    if (auto done = take(step, **posed); !done) return tl::unexpected(done.error());
    tally.add(step, stream.last_byte());
  }
  LiveOutcome outcome = tally.take();
  outcome.diagnostics = feed.diagnostics();
  outcome.diagnostics.merge(perception.diagnostics());
  return outcome;
}

nlohmann::json latency_json(const LiveOutcome& outcome) {
  return {{"median", outcome.latency_s(0.5)},
          {"p99", outcome.latency_s(0.99)},
          {"longest", outcome.latency_s(1)}};
}

}  // namespace scanfuse::app
