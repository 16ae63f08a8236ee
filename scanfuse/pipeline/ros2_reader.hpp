#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "scanfuse/drivers/ros2/ros2_bus.hpp"
#include "scanfuse/pipeline/live_stream.hpp"

namespace scanfuse::pipeline {

struct Ros2ReaderOptions {
  std::vector<std::string> topics;  ///< of scans, of the ego's motion; tf comes by itself
  std::size_t scans_waiting = 2;    ///< of one topic; older ones give way
};

/// What others publish on ROS 2's bus, as a stream of events. A topic is subscribed to, best
/// effort, once somebody publishes it: only then is its type known, and a second type on a topic
/// would disturb other nodes. /tf and /tf_static are listened to from the start.
class Ros2Reader final : public LiveStream {
 public:
  /// Names as ROS 2 takes them; an empty list is an error.
  [[nodiscard]] static Result<std::unique_ptr<Ros2Reader>> create(
      std::shared_ptr<drivers::Ros2Bus> bus, const Ros2ReaderOptions& options);

  [[nodiscard]] const io::RecordingInfo& info() const override { return info_; }
  [[nodiscard]] std::optional<io::Event> next_within(drivers::Milliseconds patience) override;
  [[nodiscard]] const Diagnostics& diagnostics() const override;
  /// Of the topics asked for, then of tf.
  [[nodiscard]] std::vector<std::pair<std::string, drivers::SensorStatus>> status() const override;

 private:
  struct Message {
    drivers::Bytes bytes;
    Time received;
    drivers::SteadyTime last_byte;
    std::size_t sensor = 0;
  };
  using Queue = drivers::NewestQueue<Message>;
  struct Topic {
    drivers::Ros2Topic topic;
    std::optional<std::size_t> subscription;  ///< empty: nobody publishes it yet
    drivers::SensorStatus status;
    std::int64_t frames = 0;
  };
  Ros2Reader(std::shared_ptr<drivers::Ros2Bus> bus, std::size_t scans_waiting)
      : bus_(std::move(bus)), queue_(std::make_shared<Queue>(scans_waiting)) {}
  [[nodiscard]] Result<void> subscribe(std::size_t index, drivers::Ros2Qos qos);
  /// Subscribes to what is published by now.
  void look_around();
  [[nodiscard]] std::optional<io::Event> decode(const Message& message);

  io::RecordingInfo info_;
  std::shared_ptr<drivers::Ros2Bus> bus_;
  std::shared_ptr<Queue> queue_;  ///< shared with callbacks of the bus, which may live longer
  std::vector<Topic> topics_;
  drivers::SteadyTime looked_;
  mutable Diagnostics diagnostics_;
};

}  // namespace scanfuse::pipeline
