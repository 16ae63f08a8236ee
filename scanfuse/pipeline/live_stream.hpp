#pragma once

#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "scanfuse/drivers/transport/live_sensor.hpp"
#include "scanfuse/io/recording.hpp"

namespace scanfuse::pipeline {

/// Sensors that are running, as a recording that goes on until `stop_when`. For one thread.
class LiveStream : public io::RecordingReader {
 public:
  /// The next event; nothing at the end. Waits.
  [[nodiscard]] Result<std::optional<io::Event>> next() override {
    while (!is_over_()) {
      if (auto event = next_within(drivers::Milliseconds{50})) return event;
    }
    return std::nullopt;
  }
  /// The same, but waits only so long.
  [[nodiscard]] virtual std::optional<io::Event> next_within(drivers::Milliseconds patience) = 0;

  /// Asked between events, and every 50 ms while none come: `next` ends once it is true.
  void stop_when(std::function<bool()> condition) { is_over_ = std::move(condition); }
  /// When the last byte came of the event that `next` gave last.
  [[nodiscard]] drivers::SteadyTime last_byte() const { return last_byte_; }
  /// How each sensor or topic does, by name.
  [[nodiscard]] virtual std::vector<std::pair<std::string, drivers::SensorStatus>> status()
      const = 0;

 protected:
  drivers::SteadyTime last_byte_;

 private:
  std::function<bool()> is_over_ = [] { return false; };
};

}  // namespace scanfuse::pipeline
