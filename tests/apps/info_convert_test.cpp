#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "apps/tool.hpp"

namespace scanfuse::tool_testing {
namespace {

using ::testing::HasSubstr;

const char* const kPoints =
    "frame,time_s,x_m,y_m\n0,1575811624.359102488,1,2\n0,1575811624.359102488,3,4\n"
    "1,1575811624.459102488,5,6\n";

TEST(InfoCommand, ListsTopicsCountsAndTimes) {
  const TemporaryFolder folder;
  const auto points = folder.write("points.csv", kPoints).string();
  const auto table = run_tool(folder, "info " + points);
  EXPECT_EQ(table.code, 0) << table.err;
  EXPECT_THAT(table.out, HasSubstr("csv points"));
  EXPECT_THAT(table.out, HasSubstr("1575811624.359102488"));
  const auto json = run_tool(folder, "info " + points + " --json");
  EXPECT_EQ(json.code, 0);
  EXPECT_THAT(json.out, HasSubstr("\"messages\":2"));
  EXPECT_THAT(json.out, HasSubstr("\"start_s\":1575811624.35910"));
}

TEST(InfoCommand, ExitCodesTellDamageFromBadInput) {
  const TemporaryFolder folder;
  const auto damaged = folder.write("damaged.csv", std::string(kPoints) + "2,x,1,1\n").string();
  const auto outcome = run_tool(folder, "info " + damaged);
  EXPECT_EQ(outcome.code, 3);
  EXPECT_THAT(outcome.err, HasSubstr("damaged.csv:5"));
  EXPECT_EQ(run_tool(folder, "info " + (folder.path() / "missing").string()).code, 2);
  EXPECT_EQ(run_tool(folder, "info").code, 2);
  EXPECT_EQ(run_tool(folder, "info " + damaged + " --nonsense").code, 2);
}

TEST(InfoCommand, HelpHoldsAnExample) {
  const TemporaryFolder folder;
  for (const char* command : {"info", "convert"}) {
    const auto help = run_tool(folder, std::string(command) + " --help");
    EXPECT_EQ(help.code, 0);
    EXPECT_THAT(help.out, HasSubstr("Example: scanfuse "));
  }
}

TEST(ConvertCommand, PointsSurviveTheWayThroughMcap) {
  const TemporaryFolder folder;
  const auto points = folder.write("points.csv", kPoints).string();
  const auto mcap = (folder.path() / "points.mcap").string();
  const auto back = (folder.path() / "back.csv").string();
  const auto there = run_tool(folder, "convert " + points + " " + mcap);
  ASSERT_EQ(there.code, 0) << there.err;
  const auto again = run_tool(folder, "convert " + mcap + " " + back);
  ASSERT_EQ(again.code, 0) << again.err;
  EXPECT_THAT(content_of(back), HasSubstr("0,1575811624.359102488,1,2,0,"));
  EXPECT_THAT(content_of(back), HasSubstr("1,1575811624.459102488,5,6,0,"));
}

TEST(ConvertCommand, RefusesWhatItCannotWriteAndLeavesNothingBehind) {
  const TemporaryFolder folder;
  const auto points = folder.write("points.csv", kPoints).string();
  EXPECT_EQ(run_tool(folder, "convert " + points + " " + (folder.path() / "a.xyz").string()).code,
            2);
  const auto no_truth = run_tool(
      folder, "convert " + points + " " + (folder.path() / "b.csv").string() + " --topic /other");
  EXPECT_EQ(no_truth.code, 2);
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "b.csv"));
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "b.csv.part"));
}

TEST(ConvertCommand, EgoMotionOfALogGoesToItsOwnTable) {
  const TemporaryFolder folder;
  const auto log = folder.write("a.log", "FLASER 1 2 1 2 0.5 1 2 0.5 10.5 host 1\n").string();
  const auto ego = folder.path() / "ego.csv";
  const auto outcome =
      run_tool(folder, "convert " + log + " " + (folder.path() / "p.csv").string() + " --ego-out " +
                           ego.string());
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(content_of(ego), HasSubstr("10.500000000,1,2,0.5"));
}

}  // namespace
}  // namespace scanfuse::tool_testing
