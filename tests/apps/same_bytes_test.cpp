#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "apps/tool.hpp"

// Same input and seed: the same bytes, whatever the number of threads.
namespace scanfuse::tool_testing {
namespace {

/// Runs the command with "@" replaced by a folder of each run; the contents of `files` after it.
std::string bytes_after(std::string command, int threads, const std::vector<std::string>& files) {
  const TemporaryFolder folder;
  for (auto at = command.find('@'); at != std::string::npos; at = command.find('@')) {
    command.replace(at, 1, folder.path().string());
  }
  const auto outcome = run_tool(folder, command + " --threads " + std::to_string(threads));
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  std::string bytes;
  for (const auto& file : files) bytes += content_of(folder.path() / file) + "\n--\n";
  EXPECT_GT(bytes.size(), 100U) << command;
  return bytes;
}

TEST(SameBytes, OfSimulateForAnyNumberOfThreads) {
  const std::string command = "simulate lu2018-2 --frames 30 --seed 5 -o @/a";
  const std::vector<std::string> tables{"a.csv", "a.truth.csv", "a.ego.csv"};
  EXPECT_EQ(bytes_after(command + ".mcap", 1, {"a.mcap"}),
            bytes_after(command + ".mcap", 3, {"a.mcap"}));
  EXPECT_EQ(bytes_after(command + ".csv", 1, tables), bytes_after(command + ".csv", 3, tables));
}

TEST(SameBytes, OfTrackForAnyNumberOfThreads) {
  const TemporaryFolder folder;
  const auto drive = (folder.path() / "drive.mcap").string();
  ASSERT_EQ(run_tool(folder, "simulate lu2018-2 --frames 60 -o " + drive).code, 0);
  const std::string command =
      "track " + drive + " -o @/t.mcap -o @/t.csv -o @/t.jsonl --detections @/d.csv";
  const std::vector<std::string> files{"t.mcap", "t.csv", "t.jsonl", "d.csv", "t.config.toml"};
  const auto once = bytes_after(command, 1, files);
  EXPECT_EQ(once, bytes_after(command, 4, files));
  EXPECT_EQ(once, bytes_after(command, 4, files));
}

TEST(SameBytes, OfTheRowsOfTheTrackingBenchmarkForAnyNumberOfThreads) {
  const TemporaryFolder folder;
  const auto rows = [&](const char* threads) {
    const auto outcome = run_tool(folder, std::string("bench track --seeds 1 --json ") + threads);
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    return nlohmann::json::parse(outcome.out)["rows"].dump();
  };
  EXPECT_EQ(rows("--threads 1"), rows("--threads 3"));
}

}  // namespace
}  // namespace scanfuse::tool_testing
