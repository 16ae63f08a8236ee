#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "apps/tool.hpp"

namespace scanfuse::tool_testing {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

TEST(BenchReal, SaysSkippedWithoutRecordings) {
  const TemporaryFolder folder;
  const auto none = run_tool(folder, "bench real --data " + folder.path().string());
  EXPECT_EQ(none.code, 0) << none.err;
  EXPECT_THAT(none.out, HasSubstr("datmo parallel"));
  EXPECT_THAT(none.out, HasSubstr("skipped: no "));
  EXPECT_THAT(none.out, HasSubstr("--full-scans"));
}

TEST(BenchReal, SkippedRowsStandApartInJson) {
  const TemporaryFolder folder;
  const auto none = run_tool(folder, "bench real --json --data " + folder.path().string());
  ASSERT_EQ(none.code, 0) << none.err;
  const auto json = nlohmann::json::parse(none.out);
  EXPECT_TRUE(json["rows"].empty());
  EXPECT_EQ(json["skipped"].size(), 5u);
}

// The rows are what the two commands of docs/real-recordings.md print.
TEST(BenchReal, AgreesWithTrackAndEvaluate) {
  const fs::path data = SCANFUSE_SHARED_DATA;
  const auto bag = (data / "datmo/parallel.bag").string();
  if (!fs::exists(bag)) GTEST_SKIP() << "no shared data: skipped";
  const TemporaryFolder folder;
  const auto bench = run_tool(folder, "bench real --json --data " + data.string());
  ASSERT_EQ(bench.code, 0) << bench.err;
  std::map<std::string, nlohmann::json> rows;
  const auto json = nlohmann::json::parse(bench.out);
  for (const auto& row : json["rows"]) rows[row["name"]] = row;
  EXPECT_EQ(rows["datmo overtake_red recall"]["role"], "chose constants");
  EXPECT_EQ(rows["datmo parallel recall"]["role"], "reporting only");

  const auto csv = (folder.path() / "t.csv").string();
  ASSERT_EQ(run_tool(folder, "track " + bag +
                                 " --ego-topic /ego_pose --mount -0.12,0,0 "
                                 "--preset vehicle-model -o " +
                                 csv)
                .code,
            0);
  const auto score = run_tool(folder, "evaluate " + csv + " --truth " +
                                          (data / "datmo/parallel.truth.csv").string() +
                                          " --match-m 0.3 --min-visible-points 3 --json");
  ASSERT_EQ(score.code, 0) << score.err;
  const auto rmse = nlohmann::json::parse(score.out)["rmse"];
  EXPECT_NEAR(rows["datmo parallel position RMSE"]["value"].get<double>(),
              rmse["position_m"].get<double>(), 2e-4);  // tables hold millimetres
  EXPECT_NEAR(rows["datmo parallel velocity RMSE"]["value"].get<double>(),
              rmse["velocity_m_per_s"].get<double>(), 2e-3);
}

nlohmann::json score_of(const TemporaryFolder& folder, const std::string& arguments) {
  const auto run = run_tool(folder, "evaluate " + arguments + " --match-m 0.3 --json");
  EXPECT_EQ(run.code, 0) << run.err;
  return run.code == 0 ? nlohmann::json::parse(run.out) : nlohmann::json();
}

// Truth interpolated from the target's topic scores as the table that was made of it.
TEST(TruthTopic, ScoresAsTheTruthTableWithinTheErrorOfInterpolation) {
  const fs::path data = fs::path(SCANFUSE_SHARED_DATA) / "datmo";
  if (!fs::exists(data)) GTEST_SKIP() << "no shared data: skipped";
  for (const std::string name : {"overtake_ego", "overtake_red", "parallel"}) {
    SCOPED_TRACE(name);
    const TemporaryFolder folder;
    const auto bag = (data / (name + ".bag")).string();
    const auto csv = (folder.path() / "t.csv").string();
    const auto track = run_tool(folder, "track " + bag +
                                            " --ego-topic /ego_pose --mount -0.12,0,0 "
                                            "--preset vehicle-model -o " +
                                            csv);
    ASSERT_EQ(track.code, 0) << track.err;
    EXPECT_EQ(track.err.find("frozen ego pose") != std::string::npos, name == "overtake_ego");
    const auto table =
        score_of(folder, csv + " --truth " + (data / (name + ".truth.csv")).string() +
                             " --min-visible-points 3");
    const auto topic = score_of(folder, csv + " --truth " + bag +
                                            " --truth-topic /red_pose --truth-size 0.44,0.2 "
                                            "--truth-offset 0.09,0");
    for (const auto& [key, error] :
         {std::pair{"position_m", 0.002}, std::pair{"velocity_m_per_s", 0.005},
          std::pair{"heading_mod_pi_rad", 0.002}, std::pair{"length_m", 0.001}}) {
      EXPECT_NEAR(topic["rmse"][key].get<double>(), table["rmse"][key].get<double>(), error) << key;
    }
    EXPECT_EQ(topic["clear"]["IDSW"], table["clear"]["IDSW"]);
    EXPECT_NEAR(topic["clear"]["FN"].get<int>(), table["clear"]["FN"].get<int>(), 2);
  }
}

TEST(Bench, SaysWhichSeedsChoseConstants) {
  const TemporaryFolder folder;
  const auto tuned = run_tool(folder, "bench segment --seeds 1 --seed 7 --json");
  ASSERT_EQ(tuned.code, 0) << tuned.err;
  EXPECT_EQ(nlohmann::json::parse(tuned.out)["rows"][0]["role"], "chose constants");
  const auto apart = run_tool(folder, "bench segment --seeds 1 --json");
  EXPECT_EQ(nlohmann::json::parse(apart.out)["rows"][0]["role"], "reporting only");
}

}  // namespace
}  // namespace scanfuse::tool_testing
