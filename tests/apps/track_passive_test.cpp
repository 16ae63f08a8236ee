#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "apps/tool.hpp"

// `scanfuse track bearings.csv --sensors sensors.toml` from simulated bearings to scores.
namespace scanfuse::tool_testing {
namespace {

using ::testing::HasSubstr;

struct Simulated {
  TemporaryFolder folder;
  std::string bearings = (folder.path() / "bearings.csv").string();
  std::string sensors = (folder.path() / "sensors.toml").string();
  std::string truth = (folder.path() / "bearings.truth.csv").string();

  explicit Simulated(const std::string& more = "") {
    const auto made = run_tool(folder, "simulate passive --targets 5 --seed 3 -o " + bearings +
                                           " --sensors-out " + sensors +
                                           " --set passive.target_layout=random"
                                           " --set passive.speed_m_per_s=200"
                                           " --set passive.scans=30"
                                           " --set passive.detection_probability=0.9"
                                           " --set passive.false_alarms=2 " +
                                           more);
    EXPECT_EQ(made.code, 0) << made.err;
  }
  [[nodiscard]] std::string path(const std::string& name) const {
    return (folder.path() / name).string();
  }
  [[nodiscard]] Outcome track(const std::string& arguments) const {
    return run_tool(folder, "track " + bearings + " --sensors " + sensors + " " + arguments);
  }
};

TEST(TrackBearings, WritesTracksThatMatchTruthInEveryFormat) {
  const Simulated scene;
  std::string outputs;
  for (const std::string end : {"csv", "jsonl", "mcap"}) {
    outputs += " -o " + scene.path("tracks." + end);
  }
  const auto tracked = scene.track("--json" + outputs);
  ASSERT_EQ(tracked.code, 0) << tracked.err;
  const auto summary = nlohmann::json::parse(tracked.out);
  EXPECT_EQ(summary["scans"], 30);
  EXPECT_EQ(summary["confirmed_tracks"], 5);
  for (const std::string end : {"csv", "jsonl", "mcap"}) {
    const auto scored =
        run_tool(scene.folder, "evaluate " + scene.path("tracks." + end) + " --truth " +
                                   scene.truth + " --match-m 500 --gospa-c-m 1000 --json");
    ASSERT_EQ(scored.code, 0) << scored.err;
    const auto score = nlohmann::json::parse(scored.out);
    EXPECT_GT(score["clear"]["MOTA"], 0.85) << end;
    EXPECT_EQ(score["clear"]["IDSW"], 0) << end;
  }
  EXPECT_THAT(content_of(scene.path("tracks.config.toml")), HasSubstr("sigma_accel"));
}

TEST(TrackBearings, GivesTheSameBytesOnAnyNumberOfThreads) {
  const Simulated scene;
  EXPECT_EQ(scene.track("--threads 1 -o " + scene.path("one.csv")).code, 0);
  EXPECT_EQ(scene.track("--threads 3 -o " + scene.path("three.csv")).code, 0);
  EXPECT_EQ(content_of(scene.path("one.csv")), content_of(scene.path("three.csv")));
}

TEST(TrackBearings, TellsTheOffsetOfASensor) {
  const Simulated scene("--set passive.azimuth_bias_rad=0.01");
  const auto tracked = scene.track("--set passive.estimate_bias=true --json");
  ASSERT_EQ(tracked.code, 0) << tracked.err;
  const auto biases = nlohmann::json::parse(tracked.out)["biases"];
  ASSERT_EQ(biases.size(), 3U);
  EXPECT_NEAR(biases[0]["bias_azimuth_rad"].get<double>(), 0.01,
              4 * biases[0]["sigma_azimuth_rad"].get<double>());
}

TEST(TrackBearings, DrawsTracksAndComparesThemWithTruth) {
  const Simulated scene;
  const auto page = scene.path("report.html");
  const auto tracked = scene.track("--json --report " + page + " --truth " + scene.truth +
                                   " --match-m 500 --gospa-c-m 1000");
  ASSERT_EQ(tracked.code, 0) << tracked.err;
  const auto clear = nlohmann::json::parse(tracked.out)["evaluation"]["clear"];
  EXPECT_GT(clear["MOTA"], 0.85);
  EXPECT_EQ(clear["IDSW"], 0);
  const auto html = content_of(page);
  EXPECT_THAT(html, HasSubstr("Against truth"));
  EXPECT_THAT(html, HasSubstr("\"sensors\":[{\"name\":"));
  EXPECT_THAT(html, HasSubstr("type=\"range\""));
  EXPECT_EQ(scene.track("--report " + scene.truth + " --truth " + scene.truth).code, 2);
}

TEST(TrackBearings, TakesTheSolverThatIsNamed) {
  const Simulated scene;
  for (const std::string solver : {"price_and_branch", "lagrangian", "greedy"}) {
    const auto tracked = scene.track("--json --set associate.solver=" + solver);
    ASSERT_EQ(tracked.code, 0) << tracked.err;
    EXPECT_EQ(nlohmann::json::parse(tracked.out)["confirmed_tracks"], 5) << solver;
  }
  EXPECT_EQ(scene.track("--set associate.solver=best").code, 2);
}

TEST(TrackBearings, SaysWhatIsMissingOrDoesNotFit) {
  const Simulated scene;
  const auto bare = run_tool(scene.folder, "track " + scene.bearings);
  EXPECT_EQ(bare.code, 2);
  EXPECT_THAT(bare.err, HasSubstr("--sensors"));
  const auto unknown = scene.track("--set passive.updat=ekf");
  EXPECT_EQ(unknown.code, 2);
  EXPECT_THAT(unknown.err, HasSubstr("update"));
  EXPECT_EQ(scene.track("--set track.update=ekf").code, 2);
  EXPECT_EQ(scene.track("--ego ego.csv").code, 2);
  EXPECT_EQ(scene.track("-o " + scene.sensors).code, 2);
  EXPECT_THAT(content_of(scene.sensors), HasSubstr("[[sensor]]"));
}

}  // namespace
}  // namespace scanfuse::tool_testing
