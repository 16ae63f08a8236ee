#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "apps/tool.hpp"

// Ctrl-C: exit code 130, what was done so far is whole, nothing half-written is left.
namespace scanfuse::tool_testing {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;

/// Points enough for seconds of work.
std::string long_recording(const TemporaryFolder& folder) {
  std::string text = "frame,time_s,x_m,y_m\n";
  for (int frame = 0; frame < 60'000; ++frame) {
    for (int i = 0; i < 8; ++i) {
      text += std::to_string(frame) + "," + std::to_string(frame * 0.04) + ",10," +
              std::to_string(i * 0.2) + "\n";
    }
  }
  return folder.write("long.csv", text).string();
}

TEST(CtrlC, EndsTrackWithTheTracksSoFar) {
  const TemporaryFolder folder;
  const auto out = folder.path() / "tracks.csv";
  EXPECT_EQ(
      interrupt_tool({"track", long_recording(folder), "-o", out.string()}, out.string() + ".part"),
      130);
  EXPECT_THAT(unfinished_files(folder), IsEmpty());
  const auto text = content_of(out);
  EXPECT_THAT(text, HasSubstr("track_id"));
  EXPECT_EQ(text.back(), '\n');
}

TEST(CtrlC, EndsConvertWithARecordingThatCanBeRead) {
  const TemporaryFolder folder;
  const auto out = (folder.path() / "long.mcap").string();
  EXPECT_EQ(interrupt_tool({"convert", long_recording(folder), out}, out + ".part"), 130);
  EXPECT_THAT(unfinished_files(folder), IsEmpty());
  const auto info = run_tool(folder, "info --check " + out);
  EXPECT_EQ(info.code, 0) << info.err;
}

TEST(CtrlC, EndsSimulateWithARecordingThatCanBeRead) {
  const TemporaryFolder folder;
  const auto out = (folder.path() / "long.csv").string();
  EXPECT_EQ(
      interrupt_tool({"simulate", "lu2018-1", "--frames", "1000000", "-o", out}, out + ".part"),
      130);
  EXPECT_THAT(unfinished_files(folder), IsEmpty());
  const auto info = run_tool(folder, "info " + out);
  EXPECT_EQ(info.code, 0) << info.err;
}

}  // namespace
}  // namespace scanfuse::tool_testing
