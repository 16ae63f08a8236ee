#include "scanfuse/drivers/clock_map.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace scanfuse::drivers {
namespace {

constexpr std::size_t kBlocks = 60;        // seconds that the line is laid below
constexpr std::size_t kFewestBlocks = 10;  // before a drift is told
constexpr double kSteepest = 1e-3;         // no quartz is that far off
constexpr double kAgreeS = 0.02;
constexpr Duration kLongestSweep = std::chrono::seconds(10);

}  // namespace

Duration Unwrapper::unwrap(Duration counter) {
  if (last_) {
    const auto turns = std::llround(to_seconds(*last_ - counter) / to_seconds(period_));
    counter += turns * period_;
  }
  last_ = counter;
  return counter;
}

void ClockMap::start(Duration sent, Time received) {
  started_ = true;
  first_sent_ = sent;
  first_received_ = received;
  slope_ = lowest_s_ = 0;
  blocks_.clear();
  block_.reset();
  doubts_ = 0;
}

Time ClockMap::stamp(Duration event, Duration sent, Time received) {
  if (event > sent || sent - event > kLongestSweep) event = sent;
  if (!started_) start(sent, received);
  double at_s = to_seconds(sent - first_sent_);
  const double delay_s = to_seconds(received - first_received_) - at_s;
  const double error_s = delay_s - line_at(at_s);
  if (std::abs(error_s) <= to_seconds(kJump)) {
    doubts_ = 0;
    learn(at_s, delay_s);
  } else if (has_jumped(sent, error_s)) {
    ++jumps_;
    start(sent, received);
    at_s = 0;
  } else {
    return received - (sent - event);
  }
  return first_received_ + (event - first_sent_) + duration_from_seconds(line_at(at_s));
}

bool ClockMap::has_jumped(Duration sent, double error_s) {
  if (doubts_ == 0 || std::abs(error_s - doubt_error_s_) > kAgreeS || sent < doubt_since_) {
    doubts_ = 0;
    doubt_since_ = sent;
  }
  doubt_error_s_ = error_s;
  ++doubts_;
  if (error_s < 0) return doubts_ >= 3;
  return doubts_ >= 5 && sent - doubt_since_ >= std::chrono::seconds(1);
}

void ClockMap::learn(double at_s, double delay_s) {
  const auto block = static_cast<std::int64_t>(std::floor(at_s));
  if (block != block_) {
    block_ = block;
    fit();
    if (blocks_.size() == kBlocks) blocks_.pop_front();
    blocks_.emplace_back(at_s, delay_s);
  } else if (delay_s - slope_ * at_s < blocks_.back().second - slope_ * blocks_.back().first) {
    blocks_.back() = {at_s, delay_s};
  }
  lowest_s_ = std::min(lowest_s_, delay_s - slope_ * at_s);
}

/// The median slope between seconds [Sen1968], and the line of that slope below all of them.
void ClockMap::fit() {
  if (blocks_.empty()) return;
  std::vector<double> slopes;
  for (std::size_t i = 0; blocks_.size() >= kFewestBlocks && i < blocks_.size(); ++i) {
    for (std::size_t j = i + 1; j < blocks_.size(); ++j) {
      const double apart_s = blocks_[j].first - blocks_[i].first;
      if (apart_s > 0) slopes.push_back((blocks_[j].second - blocks_[i].second) / apart_s);
    }
  }
  if (!slopes.empty()) {
    const auto middle = slopes.begin() + static_cast<std::ptrdiff_t>(slopes.size() / 2);
    std::nth_element(slopes.begin(), middle, slopes.end());
    slope_ = std::clamp(*middle, -kSteepest, kSteepest);
  }
  lowest_s_ = std::numeric_limits<double>::infinity();
  for (const auto& [at_s, delay_s] : blocks_) {
    lowest_s_ = std::min(lowest_s_, delay_s - slope_ * at_s);
  }
}

}  // namespace scanfuse::drivers
