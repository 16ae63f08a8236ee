#pragma once

#include <map>
#include <memory>
#include <set>
#include <string>

#include "scanfuse/core/diagnostics.hpp"
#include "scanfuse/drivers/ros2/ros2_bus.hpp"
#include "scanfuse/io/ros/encode.hpp"
#include "scanfuse/pipeline/scan_feed.hpp"
#include "scanfuse/types/track.hpp"

namespace scanfuse::pipeline {

struct Ros2ResultsOptions {
  std::string name = "scanfuse";  ///< the topics stand under "/NAME/"
  /// Publish the scans too ("/NAME/SENSOR/scan" as LaserScan, "/NAME/SENSOR/points" as
  /// PointCloud2), and the sensors' mounts on /tf_static: for sensors that ROS does not know.
  bool with_scans = false;
};

/// Publishes tracks on ROS 2's bus: "/NAME/tracks" (vision_msgs/msg/Detection3DArray),
/// "/NAME/markers" (visualization_msgs/msg/MarkerArray) and "/tf" (frames "track_ID"). All reliable
/// and volatile, in the frame that the tracks stand in, by the name that ROS gives it; where the
/// ego's motion comes from the scans, "/tf" tells it too ("odom" to the ego's frame).
class Ros2Results {
 public:
  [[nodiscard]] static Result<Ros2Results> open(std::shared_ptr<drivers::Ros2Bus> bus,
                                                const Ros2ResultsOptions& options);
  /// What nobody listens to is not even encoded; what could not be sent is counted.
  void write(const StepResult& step, const PosedScan& posed);
  [[nodiscard]] const Diagnostics& diagnostics() const { return diagnostics_; }

 private:
  Ros2Results(std::shared_ptr<drivers::Ros2Bus> bus, const Ros2ResultsOptions& options)
      : bus_(std::move(bus)), options_(options) {}
  void write_scan(const PosedScan& posed);
  void write_mount(const PosedScan& posed);
  void send(std::size_t topic, const io::ros::EncodedMessage& message);

  std::shared_ptr<drivers::Ros2Bus> bus_;
  Ros2ResultsOptions options_;
  std::size_t tracks_ = 0;
  std::size_t markers_ = 0;
  std::size_t tf_ = 0;
  std::size_t tf_static_ = 0;
  std::map<std::string, std::size_t> scans_;       ///< by name of the topic
  std::map<std::string, TransformSample> mounts_;  ///< by sensor frame
  Diagnostics diagnostics_;
};

}  // namespace scanfuse::pipeline
