#pragma once

#include <cstdint>
#include <deque>
#include <optional>
#include <utility>

#include "scanfuse/core/time.hpp"

namespace scanfuse::drivers {

/// Counts on where a device's counter of limited width starts again at 0: `unwrap` gives a value
/// that does not, the one nearest to the value before.
class Unwrapper {
 public:
  explicit Unwrapper(Duration period) : period_(period) {}
  [[nodiscard]] Duration unwrap(Duration counter);

 private:
  Duration period_;
  std::optional<Duration> last_;
};

/// Tells UTC from a device's own clock: received = device + offset + drift * device + delay, with a
/// delay that is never negative. Offset and drift are of the line below all of the last minute's
/// receptions, so that delays of transport do not reach the stamps. All it knows of UTC is the
/// receptions given: in a recording these are the recording's.
///
/// A device clock that jumps (a restart, a synchronisation) shows as receptions that disagree with
/// the line by more than `kJump`: three in agreement if they seem to come before they were sent,
/// else a second's worth. The map then starts anew, and counts it. Until then stamps are
/// told by the receptions alone.
class ClockMap {
 public:
  static constexpr Duration kJump = std::chrono::milliseconds(100);

  /// When `event` was by UTC, told by a message sent at `sent` (both by the device's clock, within
  /// 70 years of 0) and received at `received`. An event that is said to be after its message, or
  /// more than 10 s before, is taken for the sending itself.
  [[nodiscard]] Time stamp(Duration event, Duration sent, Time received);
  [[nodiscard]] std::int64_t jumps() const { return jumps_; }
  /// How much faster than UTC the device's clock is told to run, in seconds a second.
  [[nodiscard]] double drift() const { return -slope_; }

 private:
  void start(Duration sent, Time received);
  void learn(double at_s, double delay_s);
  void fit();
  /// Whether receptions that disagree have agreed among each other for long enough.
  [[nodiscard]] bool has_jumped(Duration sent, double error_s);
  [[nodiscard]] double line_at(double at_s) const { return lowest_s_ + slope_ * at_s; }

  bool started_ = false;
  Duration first_sent_{};
  Time first_received_{};
  double slope_ = 0;
  double lowest_s_ = 0;
  /// (seconds, delay) of the least delayed message of each second, relative to the first message.
  std::deque<std::pair<double, double>> blocks_;
  std::optional<std::int64_t> block_;  ///< the second that the last of them is of
  double doubt_error_s_ = 0;
  Duration doubt_since_{};
  int doubts_ = 0;
  std::int64_t jumps_ = 0;
};

}  // namespace scanfuse::drivers
