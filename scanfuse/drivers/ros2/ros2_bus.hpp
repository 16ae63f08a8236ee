#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "scanfuse/core/result.hpp"
#include "scanfuse/drivers/bytes.hpp"

namespace scanfuse::drivers {

/// A topic by its ROS 2 name and type: "/scan", "sensor_msgs/msg/LaserScan".
struct Ros2Topic {
  std::string name;
  std::string type;
};

/// The profiles that ROS 2 users know.
enum class Ros2Qos {
  kSensorData,  ///< best effort, volatile: what is lost is lost
  kReliable,    ///< reliable, volatile
  kLatched,     ///< reliable, transient local: late joiners get the last one, as of /tf_static
};

struct Ros2Options {
  /// Of the DDS; without one ROS_DOMAIN_ID, else 0.
  std::optional<int> domain;
};

/// Called in a thread of the middleware, one message at a time for each topic: CDR with its
/// encapsulation header, as the other side wrote it. It is checked by who decodes it.
using TakeMessage = std::function<void(ByteView)>;

/// A participant of ROS 2's data bus (DDS, by Eclipse Cyclone), without ROS: messages in and out as
/// CDR bytes, under the names that ROS 2 gives its topics and types on the wire ("rt/scan",
/// "sensor_msgs::msg::dds_::LaserScan_") [design.ros2.org, "Topic and Service name mapping to
/// DDS"]. ROS_LOCALHOST_ONLY=1, ROS_AUTOMATIC_DISCOVERY_RANGE=LOCALHOST and CYCLONEDDS_URI hold.
/// Safe to use from several threads.
class Ros2Bus {
 public:
  /// An error where scanfuse was built without Cyclone DDS, or there is no network.
  [[nodiscard]] static Result<std::unique_ptr<Ros2Bus>> join(const Ros2Options& options = {});
  virtual ~Ros2Bus() = default;

  /// Types under which others publish the topic now, sorted; empty until one has been found.
  [[nodiscard]] virtual std::vector<std::string> types_of(const std::string& name) const = 0;
  /// What this participant publishes itself does not come back. Returns a number for `matched`.
  [[nodiscard]] virtual Result<std::size_t> subscribe(const Ros2Topic& topic, Ros2Qos qos,
                                                      TakeMessage take) = 0;
  [[nodiscard]] virtual Result<std::size_t> advertise(const Ros2Topic& topic, Ros2Qos qos) = 0;
  /// `bytes` as `io::ros::EncodedMessage` has them; `topic` as `advertise` numbered it.
  [[nodiscard]] virtual Result<void> publish(std::size_t topic, ByteView bytes) = 0;
  /// How many publishers a subscription hears, or subscribers an advertised topic has.
  [[nodiscard]] virtual int matched(std::size_t topic) const = 0;
};

/// "/scan" for "scan" and "/scan"; an error where ROS 2 would not take the name.
[[nodiscard]] Result<std::string> ros2_topic_name(const std::string& text);
/// "sensor_msgs::msg::dds_::LaserScan_" for "sensor_msgs/msg/LaserScan", and back.
[[nodiscard]] std::string dds_type_name(const std::string& ros_type);
[[nodiscard]] std::string ros2_type_name(const std::string& dds_type);
/// What ROS_DOMAIN_ID says: 0 where it is not set, an error where it is no number from 0 to 232.
[[nodiscard]] Result<int> ros2_domain();

}  // namespace scanfuse::drivers
