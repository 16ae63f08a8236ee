#include <gmock/gmock.h>

#include <cstdlib>
#include <nlohmann/json.hpp>

#include "apps/process.hpp"
#include "apps/tool.hpp"
#include "scanfuse/drivers/ros2/ros2_bus.hpp"

// The tool on ROS 2's bus, against other processes.
namespace scanfuse::tool_testing {
namespace {

using ::testing::HasSubstr;

class Ros2Tool : public ::testing::Test {
 protected:
  void SetUp() override {
    ::setenv("ROS_LOCALHOST_ONLY", "1", 1);
    ::setenv("ROS_DOMAIN_ID", std::to_string(100 + ::getpid() % 100).c_str(), 1);
    const auto joined = drivers::Ros2Bus::join();
    if (!joined && joined.error().code == Error::Code::kUnsupported) {
      GTEST_SKIP() << joined.error().message;
    }
  }
};

// Another vendor's DDS, which ROS 2 uses by default, says scans and hears tracks.
TEST_F(Ros2Tool, TracksWhatANodeOfAnotherVendorSays) {
#ifndef SCANFUSE_ROS2_PEER
  GTEST_SKIP() << "libfastrtps-dev is not installed";
#else
  const TemporaryFolder folder;
  const auto said = folder.path() / "peer.json";
  Process peer(SCANFUSE_ROS2_PEER, {"12"}, said);
  const auto run = run_tool(folder,
                            "live --ros2 --topic /scan --preset road-users --seconds 14 "
                            "--json -o " +
                                (folder.path() / "tracks.jsonl").string());
  ASSERT_EQ(run.code, 0) << run.err;
  ASSERT_EQ(peer.wait(), 0);
  const auto ours = nlohmann::json::parse(run.out);
  const auto theirs = nlohmann::json::parse(content_of(said));
  EXPECT_GT(ours["scans"].get<int>(), 100) << run.out;
  EXPECT_EQ(ours["sensors"]["/scan"]["connections"].get<int>(), 1);
  EXPECT_EQ(ours["sensors"]["/scan"]["dropped"].get<int>(), 0);
  EXPECT_GT(theirs["arrays"].get<int>(), 100) << theirs;
  EXPECT_GT(theirs["objects"].get<int>(), 60) << theirs;
  EXPECT_LT(theirs["worst_m"].get<double>(), 1.0) << theirs;
  EXPECT_EQ(theirs["frame"], "laser");
  EXPECT_EQ(theirs["class"], "vehicle");
  EXPECT_GT(theirs["covariance_xx"].get<double>(), 0);
  EXPECT_NEAR(theirs["length_m"].get<double>(), 4.4, 1.0);
#endif
}

// A scanner that scanfuse reads itself, told to ROS 2, where a second scanfuse tracks it.
TEST_F(Ros2Tool, TellsRos2WhatItsSensorSees) {
  const TemporaryFolder folder;
  const Player player(folder, "sick");
  Process first({"live", player.address, "--ros2", "--ros2-name", "first", "--seconds", "20"},
                folder.path() / "first.err");
  const auto run = run_tool(folder,
                            "live --ros2 --topic /first/sick/scan --preset road-users "
                            "--seconds 6 --json -o " +
                                (folder.path() / "tracks.csv").string());
  ASSERT_EQ(run.code, 0) << run.err;
  const auto json = nlohmann::json::parse(run.out);
  EXPECT_GT(json["scans"].get<int>(), 50) << run.out;
  EXPECT_GT(json["confirmed_tracks"].get<int>(), 0);
  EXPECT_GT(json["sensors"]["/tf"]["scans"].get<int>(), 0) << "the tracks of the first";
  first.end(SIGINT);
}

TEST_F(Ros2Tool, RecordsATopic) {
  const TemporaryFolder folder;
  const Player player(folder, "sick");
  const Process first({"live", player.address, "--ros2", "--ros2-name", "first"},
                      folder.path() / "first.err");
  const auto out = (folder.path() / "drive.mcap").string();
  const auto run = run_tool(folder, "record --ros2 --topic /first/sick/scan --seconds 4 -o " + out);
  ASSERT_EQ(run.code, 0) << run.err;
  const auto info = run_tool(folder, "info --json " + out);
  EXPECT_THAT(info.out, HasSubstr("LaserScan"));
}

TEST_F(Ros2Tool, SaysWhoIsSilent) {
  const TemporaryFolder folder;
  const auto run = run_tool(folder, "live --ros2 --topic /nobody --seconds 4");
  EXPECT_EQ(run.code, 0);
  EXPECT_THAT(run.err, HasSubstr("waiting for /nobody: nobody publishes it"));
}

TEST_F(Ros2Tool, RefusesWhatCannotBe) {
  const TemporaryFolder folder;
  for (const auto& [arguments, why] :
       {std::pair{"live --topic /scan", "--topic needs --ros2"},
        std::pair{"live", "no sensor named"}, std::pair{"live --ros2", "no sensor named"},
        std::pair{"live --ros2 --topic /a-b", "letters, digits"},
        std::pair{"live sick://x --ros2 --topic /scan", "not both"},
        std::pair{"live sick://x --ego-topic /odom", "--ego-topic needs --topic"},
        std::pair{"live --ros2 --topic /scan --mount 1,2,3", "tf says"},
        std::pair{"live --ros2 --topic /scan --ros2-name 9x", "letters, digits"}}) {
    const auto run = run_tool(folder, arguments);
    EXPECT_EQ(run.code, 2) << arguments;
    EXPECT_THAT(run.err, HasSubstr(why)) << arguments;
  }
  ::setenv("ROS_DOMAIN_ID", "900", 1);
  const auto run = run_tool(folder, "live --ros2 --topic /scan");
  EXPECT_EQ(run.code, 2);
  EXPECT_THAT(run.err, HasSubstr("ROS_DOMAIN_ID '900'"));
}

}  // namespace
}  // namespace scanfuse::tool_testing
