#include <gmock/gmock.h>

#include <chrono>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <thread>

#include "apps/process.hpp"
#include "apps/tool.hpp"

// The tool against simulated devices, in processes of their own, over loopback.
namespace scanfuse::tool_testing {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;

TEST(Live, TracksWhatASimulatedScannerSees) {
  const TemporaryFolder folder;
  const Player player(folder, "sick");
  ASSERT_THAT(player.address, HasSubstr("sick://127.0.0.1:"));
  const auto out = folder.path() / "tracks.jsonl";
  const auto run = run_tool(folder, "live " + player.address + " --preset road-users --seconds 4 " +
                                        "--json -o " + out.string());
  ASSERT_EQ(run.code, 0) << run.err;
  const auto json = nlohmann::json::parse(run.out);
  EXPECT_GT(json["scans"].get<int>(), 50);
  EXPECT_GT(json["confirmed_tracks"].get<int>(), 0);
  EXPECT_EQ(json["sensors"]["sick"]["connections"].get<int>(), 1);
  EXPECT_THAT(unfinished_files(folder), IsEmpty());
  EXPECT_GT(std::filesystem::file_size(out), 1000U);
}

TEST(Live, SaysTracksLineByLineOnStdout) {
  const TemporaryFolder folder;
  const Player player(folder, "ibeo");
  const auto run = run_tool(folder, "live " + player.address + " --seconds 3 --quiet -o -");
  ASSERT_EQ(run.code, 0) << run.err;
  const auto line = run.out.substr(0, run.out.find('\n'));
  EXPECT_TRUE(nlohmann::json::accept(line)) << line;
}

// kill -9: what came until a second before is there, and the reader says that the end is missing.
TEST(Record, LosesAtMostTheLastSecondWhenKilled) {
  const TemporaryFolder folder;
  const Player player(folder, "sick");
  const auto out = folder.path() / "drive.mcap";
  const auto part = folder.path() / "drive.mcap.part";
  Process record({"record", player.address, "-o", out.string()}, folder.path() / "record.err");
  for (int i = 0; i < 1000; ++i) {
    std::error_code missing;
    const auto size = std::filesystem::file_size(part, missing);
    if (!missing && size > 20'000) break;
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  std::this_thread::sleep_for(std::chrono::milliseconds(1500));
  const double killed_s =
      std::chrono::duration<double>(std::chrono::system_clock::now().time_since_epoch()).count();
  record.end(SIGKILL);
  EXPECT_FALSE(std::filesystem::exists(out));
  const auto info = run_tool(folder, "info --json --check " + part.string());
  ASSERT_TRUE(info.code == 0 || info.code == 3) << info.err;
  const auto json = nlohmann::json::parse(info.out);
  ASSERT_EQ(json["topics"].size(), 1U) << info.out;
  EXPECT_EQ(json["topics"][0]["name"], "/sick");
  EXPECT_TRUE(json["topics"][0]["is_scan"].get<bool>());
  EXPECT_GT(json["topics"][0]["messages"].get<int>(), 50);
  EXPECT_GT(json["end_s"].get<double>(), killed_s - 1.0);
  EXPECT_LT(json["end_s"].get<double>(), killed_s + 0.1);
}

TEST(Record, EndsWholeAtCtrlC) {
  const TemporaryFolder folder;
  const Player player(folder, "hokuyo");
  const auto out = (folder.path() / "drive.mcap").string();
  EXPECT_EQ(interrupt_tool({"record", player.address, "-o", out}, out + ".part"), 130);
  EXPECT_THAT(unfinished_files(folder), IsEmpty());
  EXPECT_EQ(run_tool(folder, "info --check " + out).code, 0);
}

TEST(Live, RefusesWhatItCannotUnderstand) {
  const TemporaryFolder folder;
  for (const auto& [arguments, why] :
       {std::pair{"live sonar://x", "known are sick"}, std::pair{"live 127.0.0.1", "no scheme"},
        std::pair{"live sick://x --mount 1,2", "X_M,Y_M,YAW_RAD"},
        std::pair{"live sick://x ibeo://y --mount 1,2,3", "give one for each"},
        std::pair{"live sick://x --json", "give tracks a file"},
        std::pair{"simulate nowhere --serve sick:0", "nowhere"},
        std::pair{"simulate road-users --serve sonar:1", "no device"}}) {
    const auto run = run_tool(folder, arguments);
    EXPECT_EQ(run.code, 2) << arguments;
    EXPECT_THAT(run.err, HasSubstr(why)) << arguments;
  }
}

TEST(Captures, AreTrackedAsRecordings) {
  const auto file =
      std::filesystem::path(SCANFUSE_SHARED_DATA) / "sensors" / "sick" / "example.pcapng";
  if (!std::filesystem::exists(file)) GTEST_SKIP() << "no shared data: skipped";
  const TemporaryFolder folder;
  const auto info = run_tool(folder, "info --json " + file.string());
  ASSERT_EQ(info.code, 0) << info.err;
  const auto json = nlohmann::json::parse(info.out);
  EXPECT_EQ(json["topics"][0]["messages"].get<int>(), 766);
  EXPECT_NEAR(json["topics"][0]["rate_hz"].get<double>(), 15, 0.2);
  const auto out = (folder.path() / "tracks.csv").string();
  const auto first = run_tool(folder, "track " + file.string() + " -o " + out);
  ASSERT_EQ(first.code, 0) << first.err;
  const std::string tracks = content_of(out);
  ASSERT_EQ(run_tool(folder, "track " + file.string() + " -o " + out).code, 0);
  EXPECT_EQ(content_of(out), tracks);
  const auto other = run_tool(folder, "info --sensor vlp16 " + file.string());
  EXPECT_EQ(other.code, 2);
  EXPECT_THAT(other.err, HasSubstr("vlp16"));
}

}  // namespace
}  // namespace scanfuse::tool_testing
