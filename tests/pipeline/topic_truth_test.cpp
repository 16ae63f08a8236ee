#include "scanfuse/pipeline/topic_truth.hpp"

#include <gtest/gtest.h>

#include "pipeline/list_reader.hpp"

namespace scanfuse::pipeline {
namespace {

io::Event pose_event(const std::string& topic, double seconds, const Pose2& pose) {
  PoseSample sample;
  sample.stamp = at(seconds);
  sample.pose = Pose3::from_planar(pose);
  return {at(seconds), topic, sample};
}

std::vector<StepResult> steps_at(const std::vector<double>& seconds) {
  std::vector<StepResult> steps;
  for (const double t : seconds) {
    StepResult step;
    step.stamp = at(t);
    step.frame = static_cast<std::int64_t>(steps.size());
    steps.push_back(step);
  }
  return steps;
}

/// 2 m/s along y, heading there, ten messages a second for five seconds.
std::vector<io::Event> drive_north(const std::string& topic) {
  std::vector<io::Event> events;
  for (int k = 0; k <= 50; ++k) {
    events.push_back(pose_event(topic, 0.1 * k, {1, 0.2 * k, kPi / 2}));
  }
  return events;
}

TopicTruthOptions one_topic() { return {{"/target"}, ObjectClass::kVehicle, std::nullopt, {}}; }

TEST(TopicTruth, InterpolatesPoseAndVelocityAndMovesToTheCentre) {
  ListReader recording(drive_north("/target"));
  auto options = one_topic();
  options.size_m = Eigen::Vector2d(4, 2);
  options.offset_m = {0.5, 0.25};
  Diagnostics diagnostics;
  const auto truth = truth_from_topics(recording, options, steps_at({1.25}), diagnostics);
  ASSERT_TRUE(truth.has_value()) << truth.error().message;
  const TruthObject& object = truth->at(0).objects.at(0);
  EXPECT_EQ(object.id, 1);
  EXPECT_NEAR(object.position_m.x(), 0.75, 1e-9);
  EXPECT_NEAR(object.position_m.y(), 3.0, 1e-9);
  EXPECT_NEAR(*object.heading_rad, kPi / 2, 1e-9);
  EXPECT_NEAR(object.velocity_m_per_s->x(), 0, 1e-9);
  EXPECT_NEAR(object.velocity_m_per_s->y(), 2, 1e-9);
  EXPECT_EQ(object.length_m, 4);
  EXPECT_TRUE(diagnostics.empty());
}

TEST(TopicTruth, DoesNotExtrapolateNorBridgeGapsAndSaysSo) {
  auto events = drive_north("/target");
  events.erase(events.begin() + 20, events.begin() + 30);
  ListReader recording(std::move(events));
  Diagnostics diagnostics;
  const auto truth =
      truth_from_topics(recording, one_topic(), steps_at({-0.1, 1.0, 2.5, 5.1}), diagnostics);
  ASSERT_TRUE(truth.has_value());
  ASSERT_EQ(truth->size(), 1U);
  EXPECT_EQ(truth->front().frame, 1);
  EXPECT_EQ(diagnostics.count("scan without a true pose: before the first"), 1);
  EXPECT_EQ(diagnostics.count("scan without a true pose: messages are missing"), 1);
  EXPECT_EQ(diagnostics.count("scan without a true pose: after the last"), 1);
}

TEST(TopicTruth, AFrozenPoseIsToldAndNotUsed) {
  std::vector<io::Event> events;
  for (int k = 0; k <= 50; ++k) {
    events.push_back(pose_event("/target", 0.1 * k, {0.2 * std::min(k, 20), 0, 0}));
  }
  ListReader recording(std::move(events));
  Diagnostics diagnostics;
  const auto truth = truth_from_topics(recording, one_topic(), steps_at({1, 3}), diagnostics);
  ASSERT_TRUE(truth.has_value());
  EXPECT_EQ(truth->size(), 1U);
  EXPECT_EQ(diagnostics.count("scan without a true pose: it is frozen"), 1);
}

TEST(TopicTruth, TopicsAreObjectsInTheirOrderAndAFrameNeedsThemAll) {
  auto events = drive_north("/b");
  events.push_back(pose_event("/a", 1, {7, 7, 0}));
  events.push_back(pose_event("/a", 1.1, {7, 7, 0}));
  ListReader recording(std::move(events));
  TopicTruthOptions options = one_topic();
  options.topics = {"/a", "/b"};
  Diagnostics diagnostics;
  const auto truth = truth_from_topics(recording, options, steps_at({0.5, 1.05}), diagnostics);
  ASSERT_TRUE(truth.has_value());
  ASSERT_EQ(truth->size(), 1U);
  EXPECT_EQ(truth->front().objects[0].position_m.x(), 7);
  EXPECT_EQ(truth->front().objects[1].id, 2);
}

TEST(TopicTruth, ATopicWithoutAPoseIsAnErrorThatNamesTheNearest) {
  io::TopicInfo info;
  info.name = "/target";
  ListReader recording(drive_north("/target"), {info});
  TopicTruthOptions options = one_topic();
  options.topics = {"/taget"};
  Diagnostics diagnostics;
  const auto truth = truth_from_topics(recording, options, steps_at({1}), diagnostics);
  ASSERT_FALSE(truth.has_value());
  EXPECT_NE(truth.error().message.find("did you mean '/target'"), std::string::npos);
}

}  // namespace
}  // namespace scanfuse::pipeline
