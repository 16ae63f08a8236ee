#pragma once

#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "command.hpp"
#include "scanfuse/pipeline/live_reader.hpp"
#include "scanfuse/pipeline/ros2_reader.hpp"
#include "scanfuse/pipeline/scan_feed.hpp"

namespace scanfuse::app {

/// The live sensors, or topics of ROS 2, that a command was told of.
struct LiveRequest {
  std::vector<std::string> sensors;  ///< URLs
  bool ros2 = false;                 ///< join ROS 2's bus
  std::vector<std::string> topics;   ///< of ROS 2, instead of sensors
  std::string ego_topic;             ///< of ROS 2; empty: from tf
  [[nodiscard]] bool empty() const { return sensors.empty() && topics.empty(); }
  std::vector<std::string> mounts;  ///< "X_M,Y_M,YAW_RAD", one a sensor in their order
  bool standing = false;            ///< nothing tells the ego's motion since there is none
  double seconds = 0;               ///< stops after so long; 0: at Ctrl-C
  int waiting = 2;                  ///< scans of one sensor that may wait
};

void add_live_options(CLI::App& app, LiveRequest& request);

struct LiveInput {
  std::unique_ptr<pipeline::LiveStream> stream;
  std::shared_ptr<drivers::Ros2Bus> bus;  ///< where ROS 2 was asked for
  pipeline::FeedOptions feed;
};

/// Starts reading all sensors, or all topics.
[[nodiscard]] Result<LiveInput> open_live(const LiveRequest& request);

/// How each sensor did, as `--json` tells it.
[[nodiscard]] nlohmann::json sensors_json(const pipeline::LiveStream& stream);
/// The same for people, on stderr.
void print_sensors(const pipeline::LiveStream& stream);

/// Known devices and the forms of their URLs, for a command's help.
[[nodiscard]] std::string sensors_help();

}  // namespace scanfuse::app
