#include <gmock/gmock.h>

#include "io/reading.hpp"
#include "scanfuse/core/random.hpp"
#include "scanfuse/geometry/angles.hpp"
#include "scanfuse/io/carmen/open_carmen.hpp"

namespace scanfuse::io {
namespace {

using scanfuse::io_testing::all_finite;
using scanfuse::io_testing::lines_of;
using scanfuse::io_testing::read_out;
using ::testing::HasSubstr;

auto read_log(std::string text) {
  return read_out(open_carmen(lines_of(std::move(text), "a.log"), {}));
}

std::string flaser(int n, const std::string& range, const std::string& poses,
                   const std::string& stamp) {
  std::string line = "FLASER " + std::to_string(n);
  for (int i = 0; i < n; ++i) line += " " + range;
  return line + " " + poses + " " + stamp + " host 0.5\n";
}

const std::string kLog = "# comment\nPARAM robot_use_laser on host 0\nNEFF 30\n" +
                         flaser(181, "2.5", "1 2 0.5 0.9 2 0.5", "976052857.337777") +
                         "ODOM 1 2 0.5 0.3 0.1 0 976052857.4 host 0.6\n" +
                         flaser(181, "3.5", "2 2 0.5 1.9 2 0.5", "976052857.537777");

TEST(Carmen, ScansPosesAndOdometryAreRead) {
  const auto out = read_log(kLog);
  ASSERT_EQ(out.scans.size(), 2u);
  EXPECT_EQ(to_nanos(out.scans[0].stamp), 976052857337777000);
  EXPECT_EQ(out.scans[0].returns.size(), 181u);
  EXPECT_EQ(out.scans[0].beams->columns, 181);
  EXPECT_EQ(out.scans[1].frame, 1);
  ASSERT_EQ(out.poses.size(), 3u);
  EXPECT_EQ(out.poses[1].speed_m_per_s, 0.3);
  ASSERT_EQ(out.transforms.size(), 1u);
  EXPECT_EQ(out.transforms[0].child, out.scans[0].frame_id);
  EXPECT_FALSE(out.diagnostics.any_damage());
}

TEST(Carmen, RobotPoseAndMountGiveTheLaserPose) {
  const auto out = read_log(kLog);
  const Pose2 laser = (out.poses[0].pose * out.transforms[0].parent_from_child).planar();
  EXPECT_NEAR(laser.x_m, 1, 1e-12);
  EXPECT_NEAR(laser.y_m, 2, 1e-12);
  EXPECT_NEAR(laser.heading_rad, 0.5, 1e-12);
  EXPECT_NEAR(out.poses[0].pose.planar().x_m, 0.9, 1e-12);
}

TEST(Carmen, EvenCountsAreHalfOpenAndOddOnesClosed) {
  for (const auto& [n, step_deg, last_deg] :
       {std::tuple{180, 1.0, 89.0}, {181, 1.0, 90.0}, {360, 0.5, 89.5}, {361, 0.5, 90.0}}) {
    const auto out = read_log(flaser(n, "1", "0 0 0 0 0 0", "1"));
    ASSERT_EQ(out.scans.size(), 1u);
    const auto& beams = *out.scans[0].beams;
    EXPECT_NEAR(degrees(beams.step_rad), step_deg, 1e-9) << n;
    EXPECT_NEAR(degrees(beams.first_azimuth_rad), -90, 1e-9);
    const Return& last = out.scans[0].returns.back();
    EXPECT_NEAR(degrees(std::atan2(last.y_m, last.x_m)), last_deg, 1e-4) << n;
  }
}

TEST(Carmen, MaximumRangeCodesAreNoReturns) {
  EXPECT_EQ(read_log(flaser(361, "81.91", "0 0 0 0 0 0", "1")).scans[0].returns.size(), 0u);
  EXPECT_EQ(read_log(flaser(361, "79.5", "0 0 0 0 0 0", "1")).scans[0].returns.size(), 361u);
  EXPECT_EQ(read_log(flaser(180, "51.15", "0 0 0 0 0 0", "1")).scans[0].returns.size(), 0u);
  EXPECT_EQ(read_log(flaser(180, "0", "0 0 0 0 0 0", "1")).scans[0].returns.size(), 0u);
}

TEST(Carmen, DescribedLasersBringTheirAnglesAndRemissions) {
  const auto out = read_log(
      "ROBOTLASER1 0 -0.5 1.0 0.5 30 0.01 0 3 1 2 30 3 10 20 30 1 1 0 1 1 0 0 0 0.5 0.4 1e9 "
      "12.25 host 1\nRAWLASER1 0 -1 2 1 50 0.01 0 2 5 6 0 12.5 host 1\n");
  ASSERT_EQ(out.scans.size(), 2u) << (out.error ? out.error->message : "");
  ASSERT_EQ(out.scans[0].returns.size(), 2u);
  EXPECT_EQ(out.scans[0].returns[1].intensity, 20);
  EXPECT_NEAR(out.scans[0].returns[1].x_m, 2, 1e-6);
  EXPECT_EQ(out.scans[1].sensor, "/rawlaser1");
}

TEST(Carmen, ACorrectedLaserPoseWinsOverAnUncorrectedRobotPose) {
  const auto out =
      read_log(flaser(1, "1", "1 0 0 0.9 0 0", "1") + flaser(1, "1", "2 0 0 5 3 1", "2"));
  ASSERT_EQ(out.poses.size(), 2u);
  EXPECT_NEAR(out.poses[1].pose.planar().x_m, 1.9, 1e-12);
  EXPECT_EQ(out.diagnostics.count("laser and robot pose disagree: the laser's counts"), 1);
}

TEST(Carmen, BadLinesAreCountedAndALogWithoutGoodOnesIsAnError) {
  const auto out = read_log(kLog +
                            "FLASER 3 1 2\nFLASER -1\nFLASER 99999999999 1\nODOM 1 nan 2\n"
                            "GARBAGE 1 2 3\nFLASER 1 inf 0 0 0 0 0 0 1 h 1\n");
  EXPECT_EQ(out.scans.size(), 2u);
  EXPECT_EQ(out.diagnostics.count("bad line skipped"), 6);
  const auto none = read_log("PARAM a b\nFLASER 3 1 2\n");
  ASSERT_TRUE(none.error);
  EXPECT_THAT(none.error->message, HasSubstr("a.log:2"));
}

TEST(Carmen, ScansWithoutTimesFollowAtTenASecondTogetherWithTheirPoses) {
  std::string log;
  for (int i = 0; i < 3; ++i) log += flaser(181, "1", "1 2 0.5 0.9 2 0.5", "0");
  log += flaser(181, "1", "1 2 0.5 0.9 2 0.5", "5");
  const auto out = read_log(log);
  ASSERT_EQ(out.scans.size(), 4u);
  ASSERT_EQ(out.poses.size(), 4u);
  for (const auto& [place, expected_s] : {std::pair{0, 0.0}, {1, 0.1}, {2, 0.2}, {3, 5.0}}) {
    EXPECT_NEAR(to_seconds(out.scans[place].stamp.time_since_epoch()), expected_s, 1e-9);
    EXPECT_EQ(out.poses[place].stamp, out.scans[place].stamp);
  }
  EXPECT_EQ(out.diagnostics.count("no time between scans: ten scans a second assumed"), 2);
}

TEST(Carmen, TruncatedAndFlippedLogsGiveAnErrorOrFiniteScans) {
  RandomStream random(4);
  for (std::size_t size = 0; size < kLog.size(); size += 7) {
    EXPECT_TRUE(all_finite(read_log(kLog.substr(0, size))));
  }
  for (int round = 0; round < 500; ++round) {
    std::string flipped = kLog;
    for (int k = 0; k < 3; ++k) {
      flipped[random.below(flipped.size())] ^= static_cast<char>(1 << random.below(8));
    }
    EXPECT_TRUE(all_finite(read_log(flipped)));
  }
}

TEST(Carmen, EverySharedLogOpensAndGivesAllItsScans) {
  const std::filesystem::path folder = SCANFUSE_SHARED_DATA "/formats/carmen_ple/carmen";
  if (!std::filesystem::exists(folder)) GTEST_SKIP() << "no shared data: skipped";
  std::size_t scans = 0, logs = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    const auto out = read_out(open_recording(entry.path()));
    EXPECT_FALSE(out.error) << out.error->message;
    // Some hold odometry whose stamps were never set.
    EXPECT_LE(out.diagnostics.count("bad line skipped"), 30) << entry.path();
    EXPECT_TRUE(all_finite(out));
    scans += out.scans.size();
    ++logs;
  }
  EXPECT_EQ(logs, 13u);
  EXPECT_EQ(scans, 13350u);
}

}  // namespace
}  // namespace scanfuse::io
