#include "scanfuse/evaluate/align.hpp"

#include <algorithm>
#include <map>

namespace scanfuse::evaluate {
namespace {

/// Half the median interval between steps; 50 ms where there is none.
Duration half_scan_period(std::span<const StepResult> steps) {
  std::vector<Time> stamps;
  for (const auto& step : steps) stamps.push_back(step.stamp);
  std::sort(stamps.begin(), stamps.end());
  std::vector<Duration> gaps;
  for (std::size_t i = 1; i < stamps.size(); ++i) {
    if (stamps[i] > stamps[i - 1]) gaps.push_back(stamps[i] - stamps[i - 1]);
  }
  if (gaps.empty()) return std::chrono::milliseconds(50);
  std::nth_element(gaps.begin(), gaps.begin() + static_cast<long>(gaps.size() / 2), gaps.end());
  return gaps[gaps.size() / 2] / 2;
}

Duration apart(Time a, Time b) { return a < b ? b - a : a - b; }

class TimeAligner {
 public:
  TimeAligner(std::span<const StepResult> steps, std::span<const TruthFrame> truth)
      : steps_(steps), truth_(truth), limit_(half_scan_period(steps)), used_(steps.size(), false) {
    for (int i = 0; i < static_cast<int>(steps.size()); ++i) {
      by_frame_.emplace(steps[i].frame, i);
      by_stamp_.emplace(steps[i].stamp, i);
    }
  }

  Alignment run() {
    Alignment result{std::vector<int>(truth_.size(), -1), frames_tell()};
    auto& steps = result.step_of_truth;
    for (std::size_t k = 0; result.by_frame && k < truth_.size(); ++k) {
      take(steps[k], same_frame(truth_[k]));
    }
    for (std::size_t k = 0; k < truth_.size(); ++k) {
      if (steps[k] < 0) take(steps[k], same_stamp(truth_[k]));
    }
    return result;
  }

 private:
  /// Of several steps with that number (several sensors), the free one nearest in time.
  [[nodiscard]] int same_frame(const TruthFrame& frame) const {
    int best = -1;
    const auto [begin, end] = by_frame_.equal_range(frame.frame);
    for (auto it = begin; it != end; ++it) {
      const int step = it->second;
      if (used_[step]) continue;
      if (best < 0 ||
          apart(steps_[step].stamp, frame.stamp) < apart(steps_[best].stamp, frame.stamp))
        best = step;
    }
    return best;
  }

  [[nodiscard]] int same_stamp(const TruthFrame& frame) const {
    int best = -1;
    const auto consider = [&](int step) {
      const Duration gap = apart(steps_[step].stamp, frame.stamp);
      if (used_[step] || gap > limit_) return;
      if (best < 0 || gap < apart(steps_[best].stamp, frame.stamp)) best = step;
    };
    const auto begin = by_stamp_.lower_bound(frame.stamp - limit_);
    const auto end = by_stamp_.upper_bound(frame.stamp + limit_);
    for (auto it = begin; it != end; ++it) consider(it->second);
    return best;
  }

  /// Whether frame numbers mean the same on both sides: their stamps agree, or stamps tell nothing.
  [[nodiscard]] bool frames_tell() const {
    std::size_t numbered = 0, agreeing = 0, timed = 0;
    for (const auto& frame : truth_) {
      if (const int step = same_frame(frame); step >= 0) {
        ++numbered;
        if (apart(steps_[step].stamp, frame.stamp) <= limit_) ++agreeing;
      }
      if (same_stamp(frame) >= 0) ++timed;
    }
    return 2 * agreeing >= numbered || 2 * timed < truth_.size();
  }

  void take(int& place, int step) {
    place = step;
    if (step >= 0) used_[step] = true;
  }

  std::span<const StepResult> steps_;
  std::span<const TruthFrame> truth_;
  Duration limit_;
  std::vector<bool> used_;
  std::multimap<std::int64_t, int> by_frame_;
  std::multimap<Time, int> by_stamp_;
};

}  // namespace

Alignment align_in_time(std::span<const StepResult> steps, std::span<const TruthFrame> truth) {
  return TimeAligner(steps, truth).run();
}

}  // namespace scanfuse::evaluate
