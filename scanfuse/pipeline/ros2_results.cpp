#include "scanfuse/pipeline/ros2_results.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "scanfuse/io/ros/encode_results.hpp"

namespace scanfuse::pipeline {
namespace {

constexpr const char* kTfType = "tf2_msgs/msg/TFMessage";

/// What encoders take of a step, in a frame of ROS.
StepResult in_frame(const StepResult& step, std::string frame) {
  StepResult named;
  named.stamp = step.stamp;
  named.coordinate_frame = std::move(frame);
  named.tracks = step.tracks;
  return named;
}

/// A part of a topic's name: what ROS 2 does not take becomes "_".
std::string topic_part(std::string name) {
  const auto is_plain = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
  };
  std::ranges::replace_if(name, [&](char c) { return !is_plain(c); }, '_');
  name.erase(std::ranges::unique(name, [](char a, char b) { return a == '_' && b == '_'; }).begin(),
             name.end());
  if (name.empty() || (name[0] >= '0' && name[0] <= '9')) name.insert(0, "sensor");
  return name;
}

}  // namespace

Result<Ros2Results> Ros2Results::open(std::shared_ptr<drivers::Ros2Bus> bus,
                                      const Ros2ResultsOptions& options) {
  const auto name = drivers::ros2_topic_name(options.name);
  if (!name) return tl::unexpected(name.error());
  Ros2Results results(std::move(bus), options);
  results.options_.name = *name;
  struct Wanted {
    std::size_t* number;
    drivers::Ros2Topic topic;
    drivers::Ros2Qos qos;
  };
  const std::array<Wanted, 4> all{{
      {&results.tracks_,
       {*name + "/tracks", "vision_msgs/msg/Detection3DArray"},
       drivers::Ros2Qos::kReliable},
      {&results.markers_,
       {*name + "/markers", "visualization_msgs/msg/MarkerArray"},
       drivers::Ros2Qos::kReliable},
      {&results.tf_, {"/tf", kTfType}, drivers::Ros2Qos::kReliable},
      {&results.tf_static_, {"/tf_static", kTfType}, drivers::Ros2Qos::kLatched},
  }};
  for (const auto& [number, topic, qos] : std::span(all).first(options.with_scans ? 4 : 3)) {
    const auto added = results.bus_->advertise(topic, qos);
    if (!added) return tl::unexpected(added.error());
    *number = *added;
  }
  return results;
}

void Ros2Results::write(const StepResult& step, const PosedScan& posed) {
  const StepResult named =
      in_frame(step, step.coordinate_frame == "ego" ? posed.ego_frame : posed.world_frame);
  if (options_.with_scans) {
    write_mount(posed);
    write_scan(posed);
  }
  auto edges = io::ros::track_transforms(named);
  if (posed.ego_from_scans) {
    edges.push_back({step.stamp, posed.world_frame, posed.ego_frame, posed.world_from_ego, false});
  }
  if (!edges.empty() && bus_->matched(tf_) > 0) send(tf_, io::ros::encode_cdr(std::span(edges)));
  if (bus_->matched(tracks_) > 0) send(tracks_, io::ros::encode_detections(named));
  if (bus_->matched(markers_) > 0) send(markers_, io::ros::encode_markers(named));
}

void Ros2Results::write_mount(const PosedScan& posed) {
  const std::string& frame = posed.scan.frame_id;
  if (frame == posed.ego_frame || mounts_.contains(frame)) return;
  mounts_[frame] = {posed.scan.stamp, posed.ego_frame, frame, posed.ego_from_sensor, true};
  // Late joiners get the last message alone: it says all mounts.
  std::vector<TransformSample> edges;
  for (const auto& [name, edge] : mounts_) edges.push_back(edge);
  send(tf_static_, io::ros::encode_cdr(std::span<const TransformSample>(edges)));
}

void Ros2Results::write_scan(const PosedScan& posed) {
  const auto message = io::ros::encode_cdr(posed.scan);
  const bool is_cloud = message.type.ends_with("PointCloud2");
  const std::string name =
      options_.name + "/" + topic_part(posed.scan.sensor) + (is_cloud ? "/points" : "/scan");
  auto topic = scans_.find(name);
  if (topic == scans_.end()) {
    const auto added = bus_->advertise({name, message.type}, drivers::Ros2Qos::kReliable);
    if (!added) {
      diagnostics_.note("ROS 2 topic that cannot be published", added.error().message);
      return;
    }
    topic = scans_.emplace(name, *added).first;
  }
  send(topic->second, message);
}

void Ros2Results::send(std::size_t topic, const io::ros::EncodedMessage& message) {
  if (auto sent = bus_->publish(topic, message.bytes); !sent) {
    diagnostics_.note("message to ROS 2 that was not sent", sent.error().message);
  }
}

}  // namespace scanfuse::pipeline
