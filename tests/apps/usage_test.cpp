#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "apps/tool.hpp"

// What every command of the tool promises: help with an example, exit codes, named mistakes.
namespace scanfuse::tool_testing {
namespace {

using ::testing::AnyOf;
using ::testing::HasSubstr;

const char* const kCommands[] = {"info",     "convert", "track",  "simulate",
                                 "evaluate", "bench",   "config", "associate"};

TEST(EveryCommand, HasHelpWithAnExample) {
  const TemporaryFolder folder;
  for (const std::string command : kCommands) {
    const auto help = run_tool(folder, command + " --help");
    EXPECT_EQ(help.code, 0) << command;
    EXPECT_THAT(help.out, HasSubstr("Example")) << command;
    EXPECT_THAT(help.out, HasSubstr("scanfuse " + command + " ")) << command;
  }
}

TEST(EveryCommand, NamesTheNearestOptionWhenItDoesNotKnowOne) {
  const TemporaryFolder folder;
  for (const std::string command : kCommands) {
    const auto outcome = run_tool(folder, command + " a b --treads 2");
    EXPECT_EQ(outcome.code, 2) << command;
    EXPECT_THAT(outcome.err, HasSubstr("--treads")) << command;
    EXPECT_THAT(outcome.err, HasSubstr("did you mean '--threads'")) << command;
  }
}

TEST(EveryCommand, IsNamedWhenAnotherIsMisspelt) {
  const TemporaryFolder folder;
  const auto outcome = run_tool(folder, "trak drive.mcap");
  EXPECT_EQ(outcome.code, 2);
  EXPECT_THAT(outcome.err, HasSubstr("did you mean 'track'"));
  EXPECT_EQ(run_tool(folder, "").code, 2);
}

TEST(EveryCommand, SaysWhichArgumentIsMissing) {
  const TemporaryFolder folder;
  for (const std::string command :
       {"info", "convert", "track", "simulate", "evaluate", "associate"}) {
    const auto outcome = run_tool(folder, command);
    EXPECT_EQ(outcome.code, 2) << command;
    EXPECT_THAT(outcome.err, HasSubstr("required")) << command;
    EXPECT_THAT(outcome.err, HasSubstr("scanfuse " + command + " --help")) << command;
  }
}

TEST(EveryCommand, EndsWithTwoWhereItCannotWrite) {
  const TemporaryFolder folder;
  const auto points =
      folder.write("points.csv", "frame,time_s,x_m,y_m\n0,1,1,2\n1,2,3,4\n").string();
  const auto nowhere = (folder.path() / "none" / "out").string();
  const std::string tries[] = {
      "convert " + points + " " + nowhere + ".csv",
      "convert " + points + " " + nowhere + ".mcap",
      "track " + points + " -o " + nowhere + ".csv",
      "track " + points + " -o " + nowhere + ".mcap",
      "track " + points + " --detections " + nowhere + ".csv",
      "track " + points + " --report " + nowhere + ".html",
      "simulate lu2018-1 --frames 2 -o " + nowhere + ".csv",
      "simulate lu2018-1 --frames 2 -o " + nowhere + ".mcap",
  };
  for (const auto& arguments : tries) {
    const auto outcome = run_tool(folder, arguments);
    EXPECT_EQ(outcome.code, 2) << arguments;
    EXPECT_THAT(outcome.err, HasSubstr(nowhere)) << arguments;
  }
}

TEST(EveryCommand, NeverWritesOverItsInput) {
  const TemporaryFolder folder;
  const char* const text = "frame,time_s,x_m,y_m\n0,1,1,2\n1,2,3,4\n";
  const auto points = folder.write("points.csv", text).string();
  for (const auto& arguments :
       {"convert " + points + " " + points, "track " + points + " -o " + points,
        "track " + points + " --detections " + points}) {
    EXPECT_EQ(run_tool(folder, arguments).code, 2) << arguments;
    EXPECT_EQ(content_of(points), text) << arguments;
  }
}

}  // namespace
}  // namespace scanfuse::tool_testing
