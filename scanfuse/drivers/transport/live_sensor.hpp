#pragma once

#include <atomic>
#include <memory>
#include <mutex>
#include <stop_token>
#include <string>
#include <thread>

#include "scanfuse/core/diagnostics.hpp"
#include "scanfuse/drivers/transport/scan_queue.hpp"
#include "scanfuse/drivers/transport/wire.hpp"

namespace scanfuse::drivers {

struct LiveOptions {
  Milliseconds first_wait{100};     ///< before connecting again; doubles from try to try
  Milliseconds longest_wait{5000};  ///< at most so long
  Milliseconds connect_patience{2000};
  Milliseconds silence{2000};  ///< a sensor that says nothing for so long is connected to anew
};

/// How a sensor does.
struct SensorStatus {
  bool connected = false;
  std::int64_t scans = 0;
  std::int64_t bytes = 0;
  std::int64_t connections = 0;
  std::int64_t dropped = 0;  ///< scans that gave way in the queue
  std::string last_error;
  Diagnostics diagnostics;  ///< of the driver and the connection
};

/// Reads one sensor in a thread of its own and puts its scans into a queue, until it is destroyed.
/// Connects again when the connection ends, does not come about or says nothing, after waits that
/// double.
class LiveSensor {
 public:
  LiveSensor(SensorUrl url, std::size_t index, const DriverOptions& driver, ScanQueue& queue,
             const LiveOptions& options = {});
  ~LiveSensor();
  LiveSensor(const LiveSensor&) = delete;
  LiveSensor& operator=(const LiveSensor&) = delete;

  [[nodiscard]] SensorStatus status() const;
  [[nodiscard]] const SensorUrl& url() const { return url_; }

 private:
  void run(const std::stop_token& stop);
  /// Until the connection ends; whether it brought any scan.
  bool read_from(const Wire& wire, const std::stop_token& stop);
  /// Whether the wire took the replies.
  bool take(const Wire& wire, ByteView bytes);
  void sleep(Milliseconds time) const;
  void say_goodbye(const Wire& wire);
  void note(std::string_view what, std::string_view where);

  SensorUrl url_;
  std::size_t index_;
  ScanQueue* queue_;
  LiveOptions options_;
  WakeUp wake_;
  mutable std::mutex mutex_;  ///< of what follows
  std::unique_ptr<Driver> driver_;
  SensorStatus status_;
  std::jthread thread_;  ///< last: stops before the rest goes
};

}  // namespace scanfuse::drivers
