#pragma once

#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <deque>
#include <map>
#include <mutex>
#include <optional>

#include "scanfuse/types/scan.hpp"

namespace scanfuse::drivers {

using SteadyTime = std::chrono::steady_clock::time_point;

/// A scan as it came from a sensor.
struct LiveScan {
  Scan scan;
  Time received;         ///< of its last byte, by this machine's clock
  SteadyTime last_byte;  ///< the same, to measure how long it took from there
  std::size_t sensor = 0;
};

/// Between the threads that read sensors and the one that tracks. Never blocks a sensor: of each
/// at most `per_sensor` scans wait, the newest win, and what gave way is counted.
class ScanQueue {
 public:
  explicit ScanQueue(std::size_t per_sensor) : per_sensor_(per_sensor) {}

  void push(LiveScan scan);
  /// The scan that has waited longest; nothing when none came within `patience`, or after `close`.
  [[nodiscard]] std::optional<LiveScan> pop(std::chrono::milliseconds patience);
  /// Lets `pop` return at once from now on.
  void close();
  /// Scans that gave way to newer ones.
  [[nodiscard]] std::int64_t dropped(std::size_t sensor) const;

 private:
  std::size_t per_sensor_;
  mutable std::mutex mutex_;
  std::condition_variable filled_;
  std::deque<LiveScan> waiting_;
  std::map<std::size_t, std::int64_t> dropped_;
  bool closed_ = false;
};

}  // namespace scanfuse::drivers
