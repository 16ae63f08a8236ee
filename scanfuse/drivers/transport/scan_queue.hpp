#pragma once

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <deque>
#include <map>
#include <mutex>
#include <optional>
#include <utility>

#include "scanfuse/types/scan.hpp"

namespace scanfuse::drivers {

using SteadyTime = std::chrono::steady_clock::time_point;

/// Between the threads that receive and the one that tracks. Never blocks who pushes: of each
/// sensor (`T::sensor`) a bounded number of items wait, the newest win, and what gave way is
/// counted.
template <class T>
class NewestQueue {
 public:
  explicit NewestQueue(std::size_t per_sensor) : per_sensor_(per_sensor) {}

  /// Of this sensor another number may wait.
  void allow(std::size_t sensor, std::size_t most) {
    const std::lock_guard lock(mutex_);
    exceptions_[sensor] = most;
  }
  void push(T item) {
    {
      const std::lock_guard lock(mutex_);
      const auto of_sensor = [&](const T& other) { return other.sensor == item.sensor; };
      const auto exception = exceptions_.find(item.sensor);
      const std::size_t most = exception == exceptions_.end() ? per_sensor_ : exception->second;
      if (static_cast<std::size_t>(std::ranges::count_if(waiting_, of_sensor)) >= most) {
        ++dropped_[item.sensor];
        waiting_.erase(std::ranges::find_if(waiting_, of_sensor));
      }
      waiting_.push_back(std::move(item));
    }
    filled_.notify_one();
  }
  /// What has waited longest; nothing when none came within `patience`, or after `close`.
  [[nodiscard]] std::optional<T> pop(std::chrono::milliseconds patience) {
    std::unique_lock lock(mutex_);
    filled_.wait_for(lock, patience, [&] { return closed_ || !waiting_.empty(); });
    if (waiting_.empty()) return std::nullopt;
    T item = std::move(waiting_.front());
    waiting_.pop_front();
    return item;
  }
  /// Lets `pop` return at once from now on.
  void close() {
    {
      const std::lock_guard lock(mutex_);
      closed_ = true;
    }
    filled_.notify_all();
  }
  /// Items that gave way to newer ones.
  [[nodiscard]] std::int64_t dropped(std::size_t sensor) const {
    const std::lock_guard lock(mutex_);
    const auto found = dropped_.find(sensor);
    return found == dropped_.end() ? 0 : found->second;
  }

 private:
  std::size_t per_sensor_;
  mutable std::mutex mutex_;
  std::condition_variable filled_;
  std::deque<T> waiting_;
  std::map<std::size_t, std::size_t> exceptions_;
  std::map<std::size_t, std::int64_t> dropped_;
  bool closed_ = false;
};

/// A scan as it came from a sensor.
struct LiveScan {
  Scan scan;
  Time received;         ///< of its last byte, by this machine's clock
  SteadyTime last_byte;  ///< the same, to measure how long it took from there
  std::size_t sensor = 0;
};

using ScanQueue = NewestQueue<LiveScan>;

}  // namespace scanfuse::drivers
