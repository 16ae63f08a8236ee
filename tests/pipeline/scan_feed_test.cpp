#include "scanfuse/pipeline/scan_feed.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "pipeline/list_reader.hpp"
#include "preprocess/room_scene.hpp"

namespace scanfuse::pipeline {
namespace {

io::Event scan_event(double seconds, const std::string& frame = "laser") {
  Scan scan;
  scan.stamp = at(seconds);
  scan.sensor = "/scan";
  scan.frame_id = frame;
  return {at(seconds), "/scan", scan};
}

io::Event odometry_event(double seconds, double x) {
  PoseSample sample;
  sample.stamp = at(seconds);
  sample.pose = Pose3::from_planar({x, 0, 0});
  return {at(seconds), "/odom", sample};
}

io::TopicInfo topic(const std::string& name, const std::string& type) {
  io::TopicInfo info;
  info.name = name;
  info.type = type;
  info.decoded = true;
  return info;
}

io::Event tf_event(double seconds, const std::string& parent, const std::string& child, double x,
                   bool is_static) {
  TransformSample edge{at(seconds), parent, child, Pose3::from_planar({x, 0, 0}), is_static};
  return {at(seconds), "/tf", std::vector{edge}};
}

std::vector<PosedScan> drain(ScanFeed& feed) {
  std::vector<PosedScan> scans;
  while (true) {
    auto next = feed.next();
    EXPECT_TRUE(next);
    if (!next || !*next) return scans;
    scans.push_back(std::move(**next));
  }
}

TEST(ScanFeed, WaitsForTheOdometryThatBracketsAScan) {
  ScanFeed feed(std::make_unique<ListReader>(
                    std::vector{odometry_event(0, 0), scan_event(0.5), odometry_event(1, 10)},
                    std::vector{topic("/odom", "nav_msgs/Odometry")}),
                {});
  const auto scans = drain(feed);
  ASSERT_EQ(scans.size(), 1u);
  EXPECT_NEAR(scans[0].world_from_ego.translation_m.x(), 5, 1e-9);
  EXPECT_NEAR(scans[0].twist.speed_m_per_s, 10, 1e-9);
  EXPECT_TRUE(feed.diagnostics().empty());
}

TEST(ScanFeed, SaysWhenTheEgoPoseHadToBeExtrapolated) {
  ScanFeed feed(std::make_unique<ListReader>(
                    std::vector{odometry_event(0, 0), odometry_event(0.1, 1), scan_event(0.15)},
                    std::vector{topic("/odom", "nav_msgs/Odometry")}),
                {});
  const auto scans = drain(feed);
  ASSERT_EQ(scans.size(), 1u);
  EXPECT_NEAR(scans[0].world_from_ego.translation_m.x(), 1.5, 1e-9);
  EXPECT_EQ(feed.diagnostics().count("ego pose extrapolated"), 1);
}

TEST(ScanFeed, TakesMountAndEgoPoseFromTf) {
  ScanFeed feed(std::make_unique<ListReader>(
                    std::vector{tf_event(0, "base_link", "laser", 2, true),
                                tf_event(0, "odom", "base_link", 0, false), scan_event(0.5),
                                tf_event(1, "odom", "base_link", 10, false)},
                    std::vector{topic("/tf", "tf2_msgs/TFMessage")}),
                {});
  const auto scans = drain(feed);
  ASSERT_EQ(scans.size(), 1u);
  EXPECT_NEAR(scans[0].ego_from_sensor.translation_m.x(), 2, 1e-12);
  EXPECT_NEAR(scans[0].world_from_ego.translation_m.x(), 5, 1e-9);
}

TEST(ScanFeed, StaticTfGivesTheMountBesideAnOdometryTopic) {
  ScanFeed feed(std::make_unique<ListReader>(
                    std::vector{tf_event(0, "base_link", "laser", 2, true), odometry_event(0, 0),
                                scan_event(0.5), odometry_event(1, 4)},
                    std::vector{topic("/tf_static", "tf2_msgs/TFMessage"),
                                topic("/odom", "nav_msgs/Odometry")}),
                {});
  const auto scans = drain(feed);
  ASSERT_EQ(scans.size(), 1u);
  EXPECT_NEAR(scans[0].ego_from_sensor.translation_m.x(), 2, 1e-12);
  EXPECT_NEAR(scans[0].world_from_ego.translation_m.x(), 2, 1e-9);
}

// Live sensors cannot announce what others will say.
TEST(ScanFeed, TfThatWasNotAnnouncedIsWaitedForOnceItTellsTheWorld) {
  ScanFeed feed(std::make_unique<ListReader>(
                    std::vector{scan_event(0.1), tf_event(0.2, "base_link", "laser", 2, true),
                                scan_event(0.3), tf_event(0.4, "odom", "base_link", 4, false),
                                scan_event(0.5), tf_event(0.6, "odom", "base_link", 6, false)}),
                {});
  const auto scans = drain(feed);
  ASSERT_EQ(scans.size(), 3u);
  EXPECT_EQ(scans[0].world_frame, "laser") << "nothing else is known yet";
  EXPECT_EQ(scans[1].world_frame, "base_link");
  EXPECT_EQ(scans[1].ego_frame, "base_link");
  EXPECT_NEAR(scans[1].ego_from_sensor.translation_m.x(), 2, 1e-12);
  EXPECT_EQ(scans[2].world_frame, "odom");
  EXPECT_NEAR(scans[2].world_from_ego.translation_m.x(), 5, 1e-9)
      << "between the two it waited for";
}

TEST(ScanFeed, FramesAreNamedAsTheOdometryNamesThem) {
  auto before = odometry_event(0, 0), after = odometry_event(1, 4);
  for (auto* event : {&before, &after}) {
    auto& sample = std::get<PoseSample>(event->payload);
    sample.frame_id = "odom_combined";
    sample.child_frame_id = "chassis";
  }
  ScanFeed feed(std::make_unique<ListReader>(std::vector{before, scan_event(0.5), after},
                                             std::vector{topic("/odom", "nav_msgs/Odometry")}),
                {});
  const auto scans = drain(feed);
  ASSERT_EQ(scans.size(), 1u);
  EXPECT_EQ(scans[0].world_frame, "odom_combined");
  EXPECT_EQ(scans[0].ego_frame, "chassis");
}

TEST(ScanFeed, AGivenMountAndEgoFileWinOverTheRecording) {
  FeedOptions options;
  options.mount = Pose3::from_planar({-0.12, 0, 0});
  for (const double t : {0.0, 1.0}) {
    PoseSample sample;
    sample.stamp = at(t);
    sample.pose = Pose3::from_planar({7, 0, 0});
    options.ego.push_back(sample);
  }
  ScanFeed feed(std::make_unique<ListReader>(
                    std::vector{odometry_event(0, 0), scan_event(0.5), odometry_event(1, 4)},
                    std::vector{topic("/odom", "nav_msgs/Odometry")}),
                options);
  const auto scans = drain(feed);
  ASSERT_EQ(scans.size(), 1u);
  EXPECT_NEAR(scans[0].ego_from_sensor.translation_m.x(), -0.12, 1e-12);
  EXPECT_NEAR(scans[0].world_from_ego.translation_m.x(), 7, 1e-9);
}

TEST(ScanFeed, ARecordingWithoutAnyEgoPoseStandsStill) {
  ScanFeed feed(std::make_unique<ListReader>(std::vector{scan_event(0), scan_event(0.1)}), {});
  const auto scans = drain(feed);
  ASSERT_EQ(scans.size(), 2u);
  EXPECT_TRUE(scans[1].world_from_ego.translation_m.isZero());
}

TEST(ScanFeed, AScanThatRepeatsTheStampOfItsSensorIsLeftOut) {
  auto other = scan_event(0.1);
  std::get<Scan>(other.payload).sensor = "/other";
  ScanFeed feed(std::make_unique<ListReader>(std::vector{scan_event(0), scan_event(0.1), other,
                                                         scan_event(0.1), scan_event(0.2)}),
                {});
  int scans = 0;
  while (auto posed = *feed.next()) ++scans;
  EXPECT_EQ(scans, 4);
  EXPECT_EQ(feed.diagnostics().count("scan with the stamp of the one before it left out"), 1);
}

TEST(ScanFeed, ALoopInTfIsCutAndHangsNothing) {
  ScanFeed feed(std::make_unique<ListReader>(std::vector{tf_event(0, "a", "laser", 1, false),
                                                         tf_event(0, "laser", "a", 1, false),
                                                         scan_event(0.1), scan_event(2.5)},
                                             std::vector{topic("/tf", "tf2_msgs/TFMessage")}),
                {});
  EXPECT_EQ(drain(feed).size(), 2u);
}

TEST(ScanFeed, NotesScansAtAFrozenPoseAndChangesNothingElse) {
  std::vector<io::Event> events;
  for (int k = 0; k < 40; ++k) {
    events.push_back(odometry_event(0.1 * k, 0.3 * std::min(k, 20)));  // 3 m/s, then stuck
    events.push_back(scan_event(0.1 * k));
  }
  ScanFeed feed(std::make_unique<ListReader>(std::move(events),
                                             std::vector{topic("/odom", "nav_msgs/Odometry")}),
                {});
  const auto scans = drain(feed);
  ASSERT_EQ(scans.size(), 40U);
  EXPECT_NEAR(scans[30].world_from_ego.translation_m.x(), 6, 1e-9);
  const Diagnostics diagnostics = feed.diagnostics();
  ASSERT_GT(diagnostics.count("scan at a frozen ego pose"), 0);
  const auto& entry = diagnostics.entries().at("scan at a frozen ego pose");
  EXPECT_GE(entry.count, 14);
  EXPECT_LE(entry.count, 19);
  EXPECT_NE(entry.first.find("the same since 1002.0"), std::string::npos) << entry.first;
  EXPECT_FALSE(entry.damage);
}

io::Event room_event(double seconds, const Pose2& world_from_sensor, RandomStream& random,
                     const std::string& name = "/scan") {
  const VirtualScan seen = preprocess::look(preprocess::room(), world_from_sensor, seconds, random);
  auto event = scan_event(seconds, name + "_frame");
  auto& scan = std::get<Scan>(event.payload);
  event.topic = scan.sensor = name;
  for (const PlanarPoint& p : seen.points) scan.returns.push_back({p.x_m, p.y_m});
  return event;
}

Pose2 on_a_circle(double seconds) {
  Pose2 pose;
  for (int k = 0; k < 1000; ++k) pose = pose * Pose2{5e-4 * seconds, 0, 3e-4 * seconds};
  return pose;
}

TEST(ScanFeed, ARobotThatTellsNoPoseIsFollowedByItsScans) {
  RandomStream random(3);
  std::vector<io::Event> events;
  for (int k = 0; k < 60; ++k) events.push_back(room_event(0.1 * k, on_a_circle(0.1 * k), random));
  ScanFeed feed(std::make_unique<ListReader>(events), {});
  const auto scans = drain(feed);
  ASSERT_EQ(scans.size(), 60U);
  EXPECT_FALSE(scans[0].ego_from_scans);
  EXPECT_TRUE(scans[59].ego_from_scans);
  EXPECT_EQ(scans[59].world_frame, "odom");
  EXPECT_EQ(scans[59].ego_frame, "/scan_frame");
  const Pose2 truth = on_a_circle(5.9), found = scans[59].world_from_ego.planar();
  EXPECT_NEAR(found.x_m, truth.x_m, 0.06);
  EXPECT_NEAR(found.y_m, truth.y_m, 0.06);
  EXPECT_NEAR(scans[59].twist.speed_m_per_s, 0.5, 0.15);
  EXPECT_GT(feed.diagnostics().count("ego motion taken from the scans, since nothing tells it"),
            40);

  FeedOptions standing;
  standing.may_move = false;
  ScanFeed told(std::make_unique<ListReader>(events), standing);
  for (const auto& posed : drain(told)) EXPECT_FALSE(posed.ego_from_scans);
}

TEST(ScanFeed, TheMotionIsTheEgosNotThatOfASensorBesideIt) {
  RandomStream random(4);
  const Pose2 mount{1, 0.5, 0};
  std::vector<io::Event> events;
  for (int k = 0; k < 60; ++k) {
    events.push_back(
        room_event(0.1 * k, Pose2{0, 0, 0.03 * k} * mount, random));  // turns on the spot
  }
  FeedOptions options;
  options.mount = Pose3::from_planar(mount);
  ScanFeed feed(std::make_unique<ListReader>(std::move(events)), options);
  const auto scans = drain(feed);
  ASSERT_TRUE(scans[59].ego_from_scans);
  const Pose2 found = scans[59].world_from_ego.planar();
  EXPECT_NEAR(std::hypot(found.x_m, found.y_m), 0, 0.06);
  EXPECT_NEAR(found.heading_rad, 0.03 * 59, 0.05);
  EXPECT_NEAR(scans[59].twist.speed_m_per_s, 0, 0.15);
  EXPECT_NEAR(scans[59].twist.lateral_m_per_s, 0, 0.15);
}

TEST(ScanFeed, WhereThePoseFreezesTheScansTellOnFromThere) {
  RandomStream random(5);
  std::vector<io::Event> events;
  for (int k = 0; k < 400; ++k) {  // a pose at 100 Hz, stuck from 2 s on
    const double t = 0.01 * k;
    auto pose = odometry_event(t, 0);
    std::get<PoseSample>(pose.payload).pose = Pose3::from_planar(on_a_circle(std::min(t, 2.0)));
    events.push_back(pose);
    if (k % 10 == 5) events.push_back(room_event(t, on_a_circle(t), random));
  }
  ScanFeed feed(std::make_unique<ListReader>(std::move(events),
                                             std::vector{topic("/odom", "nav_msgs/Odometry")}),
                {});
  for (const auto& posed : drain(feed)) {
    const Pose2 truth = on_a_circle(to_seconds(posed.scan.stamp - at(0)));
    const Pose2 found = posed.world_from_ego.planar();
    EXPECT_NEAR(found.x_m, truth.x_m, 0.04);
    EXPECT_NEAR(found.y_m, truth.y_m, 0.04);
    EXPECT_NEAR(wrap_pi(found.heading_rad - truth.heading_rad), 0, 0.02);
  }
  EXPECT_EQ(feed.diagnostics().count("scan at a frozen ego pose"), 20);
}

TEST(ScanFeed, SaysWhetherTheMountIsKnown) {
  const auto mount_is_known = [](std::vector<io::Event> events, const FeedOptions& options) {
    ScanFeed feed(std::make_unique<ListReader>(std::move(events)), options);
    return drain(feed).back().mount_is_known;
  };
  FeedOptions mounted;
  mounted.mount = Pose3{};
  EXPECT_FALSE(mount_is_known({scan_event(0)}, {}));
  EXPECT_TRUE(mount_is_known({scan_event(0)}, mounted));
  EXPECT_TRUE(mount_is_known({tf_event(0, "base_link", "laser", 2, true), scan_event(0.5)}, {}));
}

}  // namespace
}  // namespace scanfuse::pipeline
