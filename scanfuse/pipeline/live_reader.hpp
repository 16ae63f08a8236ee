#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "scanfuse/drivers/transport/live_sensor.hpp"
#include "scanfuse/io/recording.hpp"

namespace scanfuse::pipeline {

struct LiveSource {
  drivers::SensorUrl url;
  std::optional<Pose3> mount;  ///< ego_from_sensor
  std::string metadata;        ///< of the driver
};

struct LiveReaderOptions {
  std::size_t scans_waiting = 2;  ///< of one sensor; older ones give way
  drivers::LiveOptions connection;
};

/// Live sensors as a recording that goes on until `stop_when`. With several sensors a scan's stamp
/// is that of its last beam, and at least that of the scan before: a tracker takes scans in order
/// of time, and they come when they end. The times of the beams themselves stay what they are.
/// Mounts come as static transforms base_link -> sensor. For one thread.
class LiveReader final : public io::RecordingReader {
 public:
  /// Sensors of the same name are told apart by a number. An empty list is an error.
  [[nodiscard]] static Result<std::unique_ptr<LiveReader>> create(
      std::vector<LiveSource> sources, const LiveReaderOptions& options = {});

  [[nodiscard]] const io::RecordingInfo& info() const override { return info_; }
  /// The next scan; nothing at the end. Waits.
  [[nodiscard]] Result<std::optional<io::Event>> next() override;
  /// The same, but waits only so long.
  [[nodiscard]] std::optional<io::Event> next_within(drivers::Milliseconds patience);
  [[nodiscard]] const Diagnostics& diagnostics() const override;

  /// Asked between scans, and every 50 ms while none come: `next` ends once it is true.
  void stop_when(std::function<bool()> condition) { is_over_ = std::move(condition); }
  /// When the last byte of the scan came that `next` gave last.
  [[nodiscard]] drivers::SteadyTime last_byte() const { return last_byte_; }
  [[nodiscard]] std::vector<std::pair<std::string, drivers::SensorStatus>> status() const;

 private:
  explicit LiveReader(std::size_t scans_waiting) : queue_(scans_waiting) {}
  void put_in_order(Scan& scan);

  io::RecordingInfo info_;
  drivers::ScanQueue queue_;
  std::vector<TransformSample> mounts_;
  bool mounted_ = false;
  std::optional<Time> newest_;
  drivers::SteadyTime last_byte_;
  std::function<bool()> is_over_ = [] { return false; };
  std::vector<std::unique_ptr<drivers::LiveSensor>> sensors_;  ///< last: ends before the queue
  mutable Diagnostics diagnostics_;
};

}  // namespace scanfuse::pipeline
