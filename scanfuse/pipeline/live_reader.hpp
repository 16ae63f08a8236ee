#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "scanfuse/pipeline/live_stream.hpp"

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

/// Live sensors that scanfuse speaks to itself. With several sensors a scan's stamp is that of its
/// last beam, and at least that of the scan before: a tracker takes scans in order of time, and
/// they come when they end. The times of the beams themselves stay what they are.
/// Mounts come as static transforms base_link -> sensor.
class LiveReader final : public LiveStream {
 public:
  /// Sensors of the same name are told apart by a number. An empty list is an error.
  [[nodiscard]] static Result<std::unique_ptr<LiveReader>> create(
      std::vector<LiveSource> sources, const LiveReaderOptions& options = {});

  [[nodiscard]] const io::RecordingInfo& info() const override { return info_; }
  [[nodiscard]] std::optional<io::Event> next_within(drivers::Milliseconds patience) override;
  [[nodiscard]] const Diagnostics& diagnostics() const override;
  [[nodiscard]] std::vector<std::pair<std::string, drivers::SensorStatus>> status() const override;

 private:
  explicit LiveReader(std::size_t scans_waiting) : queue_(scans_waiting) {}
  void put_in_order(Scan& scan);

  io::RecordingInfo info_;
  drivers::ScanQueue queue_;
  std::vector<TransformSample> mounts_;
  bool mounted_ = false;
  std::optional<Time> newest_;
  std::vector<std::unique_ptr<drivers::LiveSensor>> sensors_;  ///< last: ends before the queue
  mutable Diagnostics diagnostics_;
};

}  // namespace scanfuse::pipeline
