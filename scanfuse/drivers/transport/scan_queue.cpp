#include "scanfuse/drivers/transport/scan_queue.hpp"

#include <algorithm>
#include <utility>

namespace scanfuse::drivers {

void ScanQueue::push(LiveScan scan) {
  {
    const std::lock_guard lock(mutex_);
    const auto of_sensor = [&](const LiveScan& s) { return s.sensor == scan.sensor; };
    const auto count = static_cast<std::size_t>(std::ranges::count_if(waiting_, of_sensor));
    if (count >= per_sensor_) {
      ++dropped_[scan.sensor];
      waiting_.erase(std::ranges::find_if(waiting_, of_sensor));
    }
    waiting_.push_back(std::move(scan));
  }
  filled_.notify_one();
}

std::optional<LiveScan> ScanQueue::pop(std::chrono::milliseconds patience) {
  std::unique_lock lock(mutex_);
  filled_.wait_for(lock, patience, [&] { return closed_ || !waiting_.empty(); });
  if (waiting_.empty()) return std::nullopt;
  LiveScan scan = std::move(waiting_.front());
  waiting_.pop_front();
  return scan;
}

void ScanQueue::close() {
  {
    const std::lock_guard lock(mutex_);
    closed_ = true;
  }
  filled_.notify_all();
}

std::int64_t ScanQueue::dropped(std::size_t sensor) const {
  const std::lock_guard lock(mutex_);
  const auto found = dropped_.find(sensor);
  return found == dropped_.end() ? 0 : found->second;
}

}  // namespace scanfuse::drivers
