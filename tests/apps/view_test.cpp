#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "apps/tool.hpp"

namespace scanfuse::tool_testing {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

TEST(View, WhatCannotBeShownIsSaidWithExitCode2) {
  const TemporaryFolder folder;
  const auto empty = folder.write("empty.csv", "frame,time_s,x_m,y_m\n").string();
  const auto tracks = folder.write("tracks.csv", "frame,time_s,track_id,x_m,y_m\n0,0,1,2,3\n");
  const auto bearings =
      folder.write("b.csv", "scan,time_s,sensor,measurement,azimuth_rad\n0,0,a,0,1\n");
  for (const std::string& input :
       {std::string("nothing.mcap"), empty, tracks.string(), bearings.string()}) {
    const auto outcome = run_tool(folder, "view --port 0 --no-browser " + input);
    EXPECT_EQ(outcome.code, 2) << input;
    EXPECT_THAT(outcome.err, HasSubstr("scanfuse: error: ")) << input;
  }
}

TEST(View, AnAddressThatIsNoneIsRefused) {
  const TemporaryFolder folder;
  const auto points = folder.write("p.csv", "frame,time_s,x_m,y_m\n0,0,1,2\n").string();
  const auto outcome = run_tool(folder, "view --no-browser --listen somewhere " + points);
  EXPECT_EQ(outcome.code, 2);
  EXPECT_THAT(outcome.err, HasSubstr("--listen somewhere"));
  EXPECT_EQ(run_tool(folder, "view --port 70000 " + points).code, 2);
}

TEST(View, PrintsWhereItServesAndEndsWellOnCtrlC) {
  const TemporaryFolder folder;
  const auto points = folder.write("p.csv", "frame,time_s,x_m,y_m\n0,0,1,2\n1,0.1,1,2\n").string();
  const auto wait = "timeout -s INT 4 ";
  const auto out = folder.path() / "address";
  for (const std::string listen : {"127.0.0.1", "0.0.0.0"}) {
    const std::string command = wait + std::string(SCANFUSE_TOOL) + " view --port 0 --no-browser" +
                                " --listen " + listen + " " + points + " >" + out.string() +
                                " 2>/dev/null";
    const int status = std::system(command.c_str());
    EXPECT_EQ(WEXITSTATUS(status), 124) << "timeout had to end it";
    const auto address = content_of(out);
    EXPECT_THAT(address, StartsWith("http://"));
    EXPECT_EQ(address.find("?token=") != std::string::npos, listen == "0.0.0.0") << address;
  }
}

TEST(View, AssociationsAreShownAfterTheyWereMade) {
  const TemporaryFolder folder;
  const auto bearings = (folder.path() / "bearings.csv").string();
  const auto sensors = (folder.path() / "sensors.toml").string();
  const auto made = run_tool(folder, "simulate passive --targets 3 --set passive.scans=2 -o " +
                                         bearings + " --sensors-out " + sensors);
  ASSERT_EQ(made.code, 0) << made.err;
  const auto out = folder.path() / "out";
  const std::string command = "timeout -s INT 4 " + std::string(SCANFUSE_TOOL) + " associate " +
                              bearings + " --sensors " + sensors + " --view >" + out.string() +
                              " 2>/dev/null";
  EXPECT_EQ(WEXITSTATUS(std::system(command.c_str())), 124) << "timeout had to end it";
  EXPECT_THAT(content_of(out), HasSubstr("targets"));
  EXPECT_THAT(content_of(out), HasSubstr("http://localhost:"));
}

TEST(View, ARigIsShownAfterItWasCalibrated) {
  const TemporaryFolder folder;
  const auto session = (folder.path() / "session").string();
  const auto made =
      run_tool(folder, "simulate turntable --features-only --positions 20 --quiet -o " + session);
  ASSERT_EQ(made.code, 0) << made.err;
  const auto out = folder.path() / "out";
  const std::string command = "timeout -s INT 10 " + std::string(SCANFUSE_TOOL) +
                              " calibrate turntable " + session + " --view >" + out.string() +
                              " 2>/dev/null";
  EXPECT_EQ(WEXITSTATUS(std::system(command.c_str())), 124) << "timeout had to end it";
  EXPECT_THAT(content_of(out), HasSubstr("axis direction"));
  EXPECT_THAT(content_of(out), HasSubstr("http://localhost:"));
  EXPECT_EQ(run_tool(folder, "view " + session + " --rig nothing.toml").code, 2);
}

TEST(View, SensorsAndRecordingsDoNotMix) {
  const TemporaryFolder folder;
  const auto points = folder.write("p.csv", "frame,time_s,x_m,y_m\n0,0,1,2\n").string();
  for (const std::string& arguments :
       {std::string("view"), "view --live sick://x " + points,
        std::string("view --live sick://x --labels l.csv"), std::string("view --live sonar://x")}) {
    EXPECT_EQ(run_tool(folder, arguments).code, 2) << arguments;
  }
}

}  // namespace
}  // namespace scanfuse::tool_testing
