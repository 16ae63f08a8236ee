#include <gmock/gmock.h>
#include <unistd.h>

#include <chrono>
#include <cstdlib>
#include <mutex>
#include <thread>

#include "scanfuse/io/ros/decode.hpp"
#include "scanfuse/io/ros/encode_results.hpp"
#include "scanfuse/pipeline/ros2_reader.hpp"
#include "scanfuse/pipeline/ros2_results.hpp"

// Two participants on loopback: everything but the network between two machines.
namespace scanfuse::pipeline {
namespace {

using drivers::Ros2Bus;
using drivers::Ros2Qos;
using ::testing::HasSubstr;

constexpr auto kLong = std::chrono::seconds(10);

class Ros2 : public ::testing::Test {
 protected:
  void SetUp() override {
    ::setenv("ROS_LOCALHOST_ONLY", "1", 1);
    // Of its own, so that tests side by side do not hear each other.
    const drivers::Ros2Options options{100 + static_cast<int>(::getpid() % 100)};
    auto joined = Ros2Bus::join(options);
    if (!joined && joined.error().code == Error::Code::kUnsupported) {
      GTEST_SKIP() << joined.error().message;
    }
    ASSERT_TRUE(joined) << joined.error().message;
    ours_ = std::move(*joined);
    theirs_ = Ros2Bus::join(options).value();
  }

  /// Says a message until the other side has taken one event of it, or long enough.
  std::optional<io::Event> say_until_heard(Ros2Reader& reader, std::size_t topic,
                                           const io::ros::EncodedMessage& message) {
    for (const auto end = Clock::now() + kLong; Clock::now() < end;) {
      EXPECT_TRUE(theirs_->publish(topic, message.bytes));
      if (auto event = reader.next_within(drivers::Milliseconds(50))) return event;
    }
    return std::nullopt;
  }

  using Clock = std::chrono::steady_clock;
  std::shared_ptr<Ros2Bus> ours_;
  std::shared_ptr<Ros2Bus> theirs_;
};

Scan small_scan() {
  Scan scan;
  scan.stamp = Time(std::chrono::seconds(1'700'000'000));
  scan.frame_id = "laser";
  scan.beams = BeamPattern{};
  scan.beams->columns = 4;
  scan.beams->first_azimuth_rad = -0.3;
  scan.beams->step_rad = 0.2;
  scan.beams->max_range_m = 50;
  for (int i = 0; i < 4; ++i) {
    const double azimuth = -0.3 + 0.2 * i;
    Return point;
    point.x_m = static_cast<float>(5 * std::cos(azimuth));
    point.y_m = static_cast<float>(5 * std::sin(azimuth));
    point.beam = i;
    scan.returns.push_back(point);
  }
  return scan;
}

StepResult one_track() {
  StepResult step;
  step.stamp = Time(std::chrono::seconds(1'700'000'000));
  Track track;
  track.id = 7;
  track.status = TrackStatus::kConfirmed;
  track.object_class = ObjectClass::kCyclist;
  track.class_probability = 0.75;
  track.box.centre_m = {3, 4};
  track.box.length_m = 1.8;
  track.box.width_m = 0.6;
  track.height_m = 1.7;
  step.tracks = {track, track};
  step.tracks[1].status = TrackStatus::kTentative;
  return step;
}

TEST_F(Ros2, AScanComesThroughAsItWasSaid) {
  auto reader = Ros2Reader::create(ours_, {{"scan"}, 2});
  ASSERT_TRUE(reader) << reader.error().message;
  const auto topic =
      theirs_->advertise({"/scan", "sensor_msgs/msg/LaserScan"}, Ros2Qos::kSensorData);
  ASSERT_TRUE(topic) << topic.error().message;
  const auto event = say_until_heard(**reader, *topic, io::ros::encode_cdr(small_scan()));
  ASSERT_TRUE(event);
  EXPECT_EQ(event->topic, "/scan");
  const auto* scan = std::get_if<Scan>(&event->payload);
  ASSERT_NE(scan, nullptr);
  EXPECT_EQ(scan->stamp, small_scan().stamp);
  EXPECT_EQ(scan->frame_id, "laser");
  ASSERT_EQ(scan->returns.size(), 4U);
  EXPECT_FLOAT_EQ(scan->returns[2].y_m, small_scan().returns[2].y_m);
  const auto status = (*reader)->status().front();
  EXPECT_EQ(status.first, "/scan");
  EXPECT_TRUE(status.second.connected);
  EXPECT_GE(status.second.scans, 1);
}

TEST_F(Ros2, ACloudLargerThanAPacketComesThrough) {
  Scan scan = small_scan();
  scan.beams.reset();
  scan.returns.clear();
  for (int i = 0; i < 20'000; ++i) {
    Return point;
    point.x_m = static_cast<float>(1 + 0.001 * i);
    point.beam = i;
    scan.returns.push_back(point);
  }
  auto reader = Ros2Reader::create(ours_, {{"/points"}, 2}).value();
  const auto topic =
      theirs_->advertise({"/points", "sensor_msgs/msg/PointCloud2"}, Ros2Qos::kReliable).value();
  const auto event = say_until_heard(*reader, topic, io::ros::encode_cdr(scan));
  ASSERT_TRUE(event);
  const auto& heard = std::get<Scan>(event->payload);
  ASSERT_EQ(heard.returns.size(), scan.returns.size());
  EXPECT_EQ(heard.returns.back().x_m, scan.returns.back().x_m);
}

// A static transform was said once, before we joined.
TEST_F(Ros2, ALateJoinerHearsStaticTransforms) {
  const auto topic =
      theirs_->advertise({"/tf_static", "tf2_msgs/msg/TFMessage"}, Ros2Qos::kLatched).value();
  std::vector<TransformSample> edges(1);
  edges[0].parent = "base_link";
  edges[0].child = "laser";
  edges[0].parent_from_child.translation_m = {1.5, 0, 0.4};
  const auto message = io::ros::encode_cdr(std::span<const TransformSample>(edges));
  ASSERT_TRUE(theirs_->publish(topic, message.bytes));
  auto reader = Ros2Reader::create(ours_, {{"/scan"}, 2}).value();
  std::optional<io::Event> event;
  for (const auto end = Clock::now() + kLong; !event && Clock::now() < end;) {
    event = reader->next_within(drivers::Milliseconds(50));
  }
  ASSERT_TRUE(event);
  const auto& heard = std::get<std::vector<TransformSample>>(event->payload);
  ASSERT_EQ(heard.size(), 1U);
  EXPECT_TRUE(heard[0].is_static);
  EXPECT_EQ(heard[0].child, "laser");
  EXPECT_DOUBLE_EQ(heard[0].parent_from_child.translation_m.z(), 0.4);
}

TEST_F(Ros2, GarbageAndForeignTypesAreToldAndPassedOver) {
  auto reader = Ros2Reader::create(ours_, {{"/scan", "/chatter"}, 2}).value();
  const auto chatter =
      theirs_->advertise({"/chatter", "std_msgs/msg/String"}, Ros2Qos::kReliable).value();
  const auto topic =
      theirs_->advertise({"/scan", "sensor_msgs/msg/LaserScan"}, Ros2Qos::kReliable).value();
  auto broken = io::ros::encode_cdr(small_scan());
  broken.bytes.resize(60);
  for (const auto end = Clock::now() + kLong; Clock::now() < end;) {
    ASSERT_TRUE(theirs_->publish(topic, broken.bytes));
    ASSERT_TRUE(theirs_->publish(chatter, broken.bytes));
    EXPECT_FALSE(reader->next_within(drivers::Milliseconds(50)));
    if (reader->diagnostics().any_damage()) break;
  }
  EXPECT_GT(reader->diagnostics().count("message that cannot be decoded skipped"), 0);
  EXPECT_THAT(reader->status()[1].second.last_error, HasSubstr("std_msgs/msg/String"));
  ASSERT_TRUE(say_until_heard(*reader, topic, io::ros::encode_cdr(small_scan())));
}

TEST_F(Ros2, TracksAreSaidInTheFrameThatRosKnows) {
  auto results = Ros2Results::open(ours_, {"scanfuse", true});
  ASSERT_TRUE(results) << results.error().message;
  std::mutex mutex;
  std::map<std::string, std::vector<std::byte>> heard;
  const auto listen = [&](const char* name, const char* type, Ros2Qos qos) {
    const auto take = [&, name](drivers::ByteView bytes) {
      const std::lock_guard lock(mutex);
      heard[name].assign(bytes.begin(), bytes.end());
    };
    ASSERT_TRUE(theirs_->subscribe({name, type}, qos, take));
  };
  listen("/scanfuse/tracks", "vision_msgs/msg/Detection3DArray", Ros2Qos::kReliable);
  listen("/scanfuse/markers", "visualization_msgs/msg/MarkerArray", Ros2Qos::kSensorData);
  listen("/scanfuse/sick/scan", "sensor_msgs/msg/LaserScan", Ros2Qos::kSensorData);
  listen("/tf", "tf2_msgs/msg/TFMessage", Ros2Qos::kReliable);
  listen("/tf_static", "tf2_msgs/msg/TFMessage", Ros2Qos::kLatched);
  PosedScan posed;
  posed.scan = small_scan();
  posed.scan.sensor = "sick";
  posed.world_frame = "odom";
  posed.ego_frame = "base_link";
  posed.ego_from_sensor.translation_m = {1, 2, 3};
  StepResult step = one_track();
  for (const auto end = Clock::now() + kLong; Clock::now() < end;) {
    results->write(step, posed);
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
    const std::lock_guard lock(mutex);
    if (heard.size() == 5) break;
  }
  const std::lock_guard lock(mutex);
  ASSERT_EQ(heard.size(), 5U);
  step.coordinate_frame = "odom";
  EXPECT_EQ(heard["/scanfuse/tracks"], io::ros::encode_detections(step).bytes);
  EXPECT_EQ(heard["/scanfuse/markers"], io::ros::encode_markers(step).bytes);
  const auto tf =
      io::ros::decode_message({"/tf", "tf2_msgs/msg/TFMessage", "cdr", ""}, heard["/tf"]);
  const auto& moving = std::get<std::vector<TransformSample>>(tf->payload);
  ASSERT_EQ(moving.size(), 1U) << "what is tentative is not shown";
  EXPECT_EQ(moving[0].parent, "odom");
  EXPECT_EQ(moving[0].child, "track_7");
  const auto fixed = io::ros::decode_message({"/tf_static", "tf2_msgs/msg/TFMessage", "cdr", ""},
                                             heard["/tf_static"]);
  const auto& mounts = std::get<std::vector<TransformSample>>(fixed->payload);
  ASSERT_EQ(mounts.size(), 1U);
  EXPECT_EQ(mounts[0].parent, "base_link");
  EXPECT_EQ(mounts[0].parent_from_child.translation_m.y(), 2);
  EXPECT_TRUE(results->diagnostics().empty());
}

TEST_F(Ros2, WhatWePublishDoesNotComeBack) {
  auto reader = Ros2Reader::create(ours_, {{"/scan"}, 2}).value();
  const auto topic = ours_->advertise({"/tf", "tf2_msgs/msg/TFMessage"}, Ros2Qos::kReliable);
  std::vector<TransformSample> edges(1);
  edges[0].parent = "a";
  edges[0].child = "b";
  for (int i = 0; i < 10; ++i) {
    ASSERT_TRUE(
        ours_->publish(*topic, io::ros::encode_cdr(std::span<const TransformSample>(edges)).bytes));
    EXPECT_FALSE(reader->next_within(drivers::Milliseconds(20)));
  }
}

}  // namespace
}  // namespace scanfuse::pipeline
