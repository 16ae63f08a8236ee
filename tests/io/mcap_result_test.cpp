#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <limits>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "scanfuse/io/mcap/json_text.hpp"
#include "scanfuse/io/mcap/message_source.hpp"
#include "scanfuse/io/mcap/recording_writer.hpp"
#include "scanfuse/io/mcap/result_messages.hpp"
#include "scanfuse/io/mcap/result_writer.hpp"
#include "scanfuse/io/mcap/scene.hpp"
#include "scanfuse/io/ros/decoding_reader.hpp"

namespace scanfuse::io {
namespace {

using JsonTree = nlohmann::json;

std::filesystem::path fresh_path(const std::string& name) {
  const auto path = std::filesystem::temp_directory_path() / ("scanfuse_" + name + ".mcap");
  std::filesystem::remove(path);
  return path;
}

StepResult example_step(int frame) {
  StepResult step;
  step.stamp = time_from_nanos(1'500'000'000'123'456'789 + frame * 80'000'000LL);
  step.frame = frame;
  step.sensor = "/scan";
  step.world_from_ego = Pose3::from_planar({1.5 * frame, -2, 0.25}, 0.1);
  step.ego_from_sensor = Pose3::from_planar({0.5, 0, 0}, 0.55);
  Detection detection;
  detection.score = 0.75;
  detection.box = {{10.125, -3}, 0.1, 4.5, 1.8};
  detection.covariance << 4, 1, 0.5, 1, 3, 0.25, 0.5, 0.25, 2;
  detection.points = 17;
  detection.length_seen = true;
  detection.seen_from_m = {0.5, 0};
  step.detections = {detection};
  Track track;
  track.id = 7;
  track.object_class = ObjectClass::kVehicle;
  track.class_probability = 0.9;
  track.status = TrackStatus::kConfirmed;
  track.box = {{10.1, -3.1}, 0.2, 4.4, 1.7};
  track.state.mean << 10.1, 8.5, -3.1, 0.1;
  track.state.covariance(0, 2) = track.state.covariance(2, 0) = 0.125;
  track.speed_m_per_s = 8.5;
  track.age_frames = frame;
  track.detection = 0;
  track.nis = 1.5;
  step.tracks = {track};
  return step;
}

Scan example_scan(int frame) {
  Scan scan;
  scan.stamp = example_step(frame).stamp;
  scan.frame = frame;
  scan.sensor = "/scan";
  scan.frame_id = "laser";
  scan.returns = {{1, 2, 0.5f, 40, 0.001f, 3, 2, 1}, {-4, 0.25f, 0, 10, 0.002f, 9, 0, 0}};
  return scan;
}

TruthFrame example_truth() {
  TruthFrame truth;
  truth.stamp = time_from_nanos(1'500'000'000'123'456'789);
  truth.frame = 3;
  TruthObject car;
  car.id = 2;
  car.object_class = ObjectClass::kVehicle;
  car.position_m = {12.5, 1.0 / 3};
  car.heading_rad = 3.1;
  car.velocity_m_per_s = Eigen::Vector2d(8, -0.5);
  car.visible_points = 12;
  TruthObject walker;
  walker.id = 5;
  walker.object_class = ObjectClass::kPedestrian;
  truth.objects = {car, walker};
  return truth;
}

std::vector<std::pair<RawChannel, RawMessage>> raw_messages(const std::filesystem::path& path) {
  std::vector<std::pair<RawChannel, RawMessage>> all;
  auto source = open_mcap(path);
  EXPECT_TRUE(source.has_value());
  for (;;) {
    auto message = (*source)->next();
    EXPECT_TRUE(message.has_value());
    if (!message || !*message) break;
    const auto channel = (*source)->channels()[(*message)->channel];
    all.emplace_back(channel, std::move(**message));
  }
  EXPECT_TRUE((*source)->diagnostics().empty());
  return all;
}

JsonTree tree_of(const RawMessage& message) {
  const auto* begin = reinterpret_cast<const char*>(message.bytes.data());
  return JsonTree::parse(begin, begin + message.bytes.size(), nullptr, false);
}

std::filesystem::path write_example_results(const std::string& name) {
  const auto path = fresh_path(name);
  auto writer = open_mcap_result_writer(path);
  EXPECT_TRUE(writer.has_value());
  for (int frame = 0; frame < 3; ++frame) {
    auto step = example_step(frame);
    if (frame == 2) step.tracks.clear();
    EXPECT_TRUE((*writer)->write(step, example_scan(frame)));
  }
  EXPECT_TRUE((*writer)->write(example_truth()));
  EXPECT_TRUE((*writer)->finish());
  return path;
}

TEST(McapResult, TracksAndDetectionsComeBackAsTheyWere) {
  const auto path = write_example_results("tracks");
  const auto steps = read_tracks_mcap(path);
  ASSERT_TRUE(steps.has_value()) << steps.error().message;
  ASSERT_EQ(steps->size(), 3u);
  const auto expected = example_step(1);
  const auto& step = (*steps)[1];
  EXPECT_EQ(step.stamp, expected.stamp);
  EXPECT_EQ(step.frame, 1);
  EXPECT_EQ(step.sensor, "/scan");
  EXPECT_TRUE(step.world_from_ego.translation_m == expected.world_from_ego.translation_m);
  EXPECT_TRUE(step.world_from_ego.rotation.isApprox(expected.world_from_ego.rotation));
  ASSERT_EQ(step.tracks.size(), 1u);
  const auto& track = step.tracks[0];
  const auto& given = expected.tracks[0];
  EXPECT_EQ(track.id, 7);
  EXPECT_EQ(track.object_class, ObjectClass::kVehicle);
  EXPECT_EQ(track.status, TrackStatus::kConfirmed);
  EXPECT_TRUE(track.box.centre_m == given.box.centre_m);
  EXPECT_EQ(track.box.heading_rad, given.box.heading_rad);
  EXPECT_TRUE(track.state.mean == given.state.mean);
  EXPECT_TRUE(track.state.covariance == given.state.covariance);
  EXPECT_EQ(track.nis, 1.5);
  ASSERT_EQ(step.detections.size(), 1u);
  EXPECT_TRUE(step.detections[0].covariance == expected.detections[0].covariance);
  EXPECT_EQ(step.detections[0].points, 17);
  EXPECT_TRUE(step.detections[0].length_seen);
  EXPECT_TRUE((*steps)[2].tracks.empty());
}

TEST(McapResult, WritesTheDocumentedTopicsAndValidJson) {
  std::map<std::string, int> counts;
  for (const auto& [channel, message] : raw_messages(write_example_results("topics"))) {
    ++counts[channel.topic + " " + channel.type];
    if (channel.encoding != "json") continue;
    EXPECT_FALSE(tree_of(message).is_discarded()) << channel.topic;
    EXPECT_FALSE(JsonTree::parse(channel.definition, nullptr, false).is_discarded())
        << channel.type;
  }
  EXPECT_THAT(counts,
              testing::ElementsAre(testing::Pair("/scan sensor_msgs/msg/PointCloud2", 3),
                                   testing::Pair("/scanfuse/detections scanfuse.Detections", 3),
                                   testing::Pair("/scanfuse/scene foxglove.SceneUpdate", 3),
                                   testing::Pair("/scanfuse/tracks scanfuse.Tracks", 3),
                                   testing::Pair("/scanfuse/truth scanfuse.Truth", 1),
                                   testing::Pair("/tf foxglove.FrameTransform", 6)));
}

TEST(McapResult, EveryMemberWrittenStandsInItsSchema) {
  for (const auto& [channel, message] : raw_messages(write_example_results("schemas"))) {
    if (channel.encoding != "json") continue;
    const auto schema = JsonTree::parse(channel.definition);
    const auto tree = tree_of(message);
    for (const auto& [key, value] : tree.items()) {
      ASSERT_TRUE(schema["properties"].contains(key)) << channel.type << ' ' << key;
      if (!value.is_array() || value.empty() || !value[0].is_object()) continue;
      for (const auto& [inner, ignored] : value[0].items()) {
        EXPECT_TRUE(schema["properties"][key]["items"]["properties"].contains(inner))
            << channel.type << ' ' << key << '.' << inner;
      }
    }
  }
}

TEST(McapResult, TwoRunsGiveTheSameBytes) {
  const auto bytes_of = [](const std::filesystem::path& path) {
    auto source = mcap::open_bytes(path);
    std::vector<std::byte> bytes((*source)->size());
    EXPECT_TRUE((*source)->read(0, bytes));
    return bytes;
  };
  EXPECT_EQ(bytes_of(write_example_results("once")), bytes_of(write_example_results("again")));
}

TEST(McapScene, DeletesATrackThatIsGoneAndKeepsItsTrailWhileItLives) {
  mcap::SceneBuilder scene("world");
  (void)scene.update(example_step(0));
  const auto second = JsonTree::parse(scene.update(example_step(1)));
  EXPECT_EQ(second["entities"][0]["lines"][0]["points"].size(), 2u);
  EXPECT_TRUE(second["deletions"].empty());
  auto gone = example_step(2);
  gone.tracks.clear();
  const auto third = JsonTree::parse(scene.update(gone));
  ASSERT_EQ(third["deletions"].size(), 1u);
  EXPECT_EQ(third["deletions"][0]["id"], "track-7");
  EXPECT_TRUE(JsonTree::parse(scene.update(gone))["deletions"].empty());
}

TEST(McapScene, NeverHoldsANumberThatIsNotFinite) {
  auto step = example_step(0);
  step.tracks[0].box.heading_rad = std::numeric_limits<double>::quiet_NaN();
  step.tracks[0].nis = std::numeric_limits<double>::infinity();
  mcap::SceneBuilder scene("world");
  EXPECT_TRUE(JsonTree::parse(scene.update(step))["entities"].empty());
  const auto tracks = JsonTree::parse(mcap::tracks_json(step), nullptr, false);
  ASSERT_FALSE(tracks.is_discarded());
  EXPECT_TRUE(tracks["tracks"][0]["nis"].is_null());
}

TEST(McapTruth, ComesBackAsItWas) {
  const auto text = mcap::truth_json(example_truth());
  const auto truth = mcap::truth_from_json(std::as_bytes(std::span(text)));
  ASSERT_TRUE(truth.has_value()) << truth.error().message;
  const auto expected = example_truth();
  EXPECT_EQ(truth->stamp, expected.stamp);
  EXPECT_EQ(truth->frame, 3);
  ASSERT_EQ(truth->objects.size(), 2u);
  EXPECT_TRUE(truth->objects[0].position_m == expected.objects[0].position_m);
  EXPECT_EQ(truth->objects[0].heading_rad, expected.objects[0].heading_rad);
  EXPECT_TRUE(*truth->objects[0].velocity_m_per_s == *expected.objects[0].velocity_m_per_s);
  EXPECT_EQ(truth->objects[0].visible_points, 12);
  EXPECT_FALSE(truth->objects[1].heading_rad.has_value());
  EXPECT_FALSE(truth->objects[1].velocity_m_per_s.has_value());
  EXPECT_EQ(truth->objects[1].object_class, ObjectClass::kPedestrian);
}

TEST(McapTruth, SaysWhichMemberIsMissing) {
  const std::string text = R"({"stamp":{"sec":1,"nsec":2},"frame":0,"objects":[]})";
  const auto truth = mcap::truth_from_json(std::as_bytes(std::span(text)));
  ASSERT_FALSE(truth.has_value());
  EXPECT_THAT(truth.error().message, testing::HasSubstr("coordinate_frame"));
}

TEST(McapRecording, EventsComeBackAsTheyWere) {
  const auto path = fresh_path("recording");
  auto writer = McapRecordingWriter::create(path);
  ASSERT_TRUE(writer.has_value());
  const auto scan = example_scan(0);
  const Time t = scan.stamp;
  PoseSample pose{t, "world", "ego", Pose3::from_planar({3, 4, 0.5}), 8.0, 0.1};
  const TransformSample edge{t, "ego", "laser", Pose3::from_planar({1, 0, 0}), true};
  ASSERT_TRUE(writer->write({t, "", std::vector<TransformSample>{edge}}));
  ASSERT_TRUE(writer->write({t, "/odom", pose}));
  ASSERT_TRUE(writer->write({t, "/scan", scan}));
  ASSERT_TRUE(writer->write({t + Duration{5}, "", example_truth()}));
  ASSERT_TRUE(writer->finish());

  auto source = open_mcap(path);
  ASSERT_TRUE(source.has_value());
  auto reader = decode_messages(std::move(*source), {}, &mcap::truth_from_json);
  std::vector<Event> events;
  for (;;) {
    auto event = reader->next();
    ASSERT_TRUE(event.has_value()) << event.error().message;
    if (!*event) break;
    events.push_back(std::move(**event));
  }
  EXPECT_TRUE(reader->diagnostics().empty());
  ASSERT_EQ(events.size(), 4u);
  EXPECT_EQ(events[0].topic, "/tf_static");
  EXPECT_TRUE(std::get<std::vector<TransformSample>>(events[0].payload)[0].is_static);
  EXPECT_NEAR(*std::get<PoseSample>(events[1].payload).speed_m_per_s, 8, 1e-12);
  const auto& back = std::get<Scan>(events[2].payload);
  EXPECT_EQ(back.stamp, scan.stamp);
  EXPECT_EQ(back.frame_id, "laser");
  ASSERT_EQ(back.returns.size(), scan.returns.size());
  for (std::size_t i = 0; i < scan.returns.size(); ++i) {
    EXPECT_EQ(back.returns[i].x_m, scan.returns[i].x_m);
    EXPECT_EQ(back.returns[i].time_offset_s, scan.returns[i].time_offset_s);
    EXPECT_EQ(back.returns[i].intensity, scan.returns[i].intensity);
    EXPECT_EQ(back.returns[i].beam, scan.returns[i].beam);
    EXPECT_EQ(back.returns[i].layer, scan.returns[i].layer);
    EXPECT_EQ(back.returns[i].echo, scan.returns[i].echo);
  }
  EXPECT_EQ(std::get<TruthFrame>(events[3].payload).objects.size(), 2u);
}

TEST(McapJsonText, EscapesTextAndReplacesWhatIsNoUtf8) {
  mcap::JsonText out;
  out.begin_object().field("a\"b", std::string("tab\t\xC3\xA4\xFF")).end_object();
  const auto tree = JsonTree::parse(out.text(), nullptr, false);
  ASSERT_FALSE(tree.is_discarded());
  EXPECT_EQ(tree["a\"b"], "tab\t\xC3\xA4\xEF\xBF\xBD");
}

}  // namespace
}  // namespace scanfuse::io
