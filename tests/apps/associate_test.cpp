#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <memory>
#include <nlohmann/json.hpp>

#include "apps/tool.hpp"

// Bearings to fixes by the tool: what it writes, and what it says of bad input.
namespace scanfuse::tool_testing {
namespace {

using ::testing::AllOf;
using ::testing::AnyOf;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

struct Bearings {
  std::shared_ptr<TemporaryFolder> place = std::make_shared<TemporaryFolder>();
  std::string bearings = (place->path() / "bearings.csv").string();
  std::string sensors = (place->path() / "sensors.toml").string();
  std::string truth = (place->path() / "bearings.truth.csv").string();

  [[nodiscard]] std::string at(const char* name) const { return (place->path() / name).string(); }
  [[nodiscard]] Outcome associate(const std::string& more = "") const {
    return run_tool(*place, "associate " + bearings + " --sensors " + sensors + " " + more);
  }
};

Bearings simulated(const std::string& more = "--targets 5 --spacing 3000 --noise-mrad 2") {
  Bearings files;
  const auto made = run_tool(*files.place, "simulate passive " + more + " -o " + files.bearings +
                                               " --sensors-out " + files.sensors + " --seed 3");
  EXPECT_EQ(made.code, 0) << made.err;
  return files;
}

constexpr const char* kTwoSensors =
    "[[sensor]]\nname = \"a\"\nposition_m = [0, 0, 0]\nsigma_azimuth_rad = 0.005\n"
    "sigma_elevation_rad = 0.005\n"
    "[[sensor]]\nname = \"b\"\nposition_m = [1000, 0, 0]\nsigma_azimuth_rad = 0.005\n"
    "sigma_elevation_rad = 0.005\n";
constexpr const char* kHeader = "scan,time_s,sensor,measurement,azimuth_rad,elevation_rad\n";
/// One target at (500, 500, 0) m.
constexpr const char* kOneTarget = "0,0,a,0,0.785398,0\n0,0,b,0,2.356194,0\n";

Bearings written(const std::string& rows, const std::string& sensors = kTwoSensors) {
  Bearings files;
  files.place->write("bearings.csv", kHeader + rows);
  files.place->write("sensors.toml", sensors);
  return files;
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const auto at = text.find(from);
  EXPECT_NE(at, text.npos) << from;
  return at == text.npos ? text : text.replace(at, from.size(), to);
}

TEST(Associate, FindsSimulatedTargetsWithAProofAndWritesAllItsFiles) {
  const Bearings files = simulated();
  const auto run = files.associate("--json --best 3 -o " + files.at("fixes.csv") +
                                   " --assignments " + files.at("rows.csv") + " --report " +
                                   files.at("page.html") + " --truth " + files.truth);
  ASSERT_EQ(run.code, 0) << run.err;
  const auto json = nlohmann::json::parse(run.out);
  ASSERT_EQ(json["scans"].size(), 1U);
  const auto& scan = json["scans"][0];
  for (const char* key : {"scan", "targets", "primal", "dual", "gap", "proved", "columns",
                          "components", "seconds", "best", "best_exact"}) {
    EXPECT_TRUE(scan.contains(key)) << key;
  }
  EXPECT_EQ(scan["targets"], 5);
  EXPECT_TRUE(scan["proved"]);
  EXPECT_THAT(content_of(files.at("fixes.csv")), HasSubstr("existence_probability"));
  EXPECT_THAT(content_of(files.at("rows.csv")), HasSubstr("scan,sensor,measurement,target"));
  EXPECT_THAT(unfinished_files(*files.place), IsEmpty());
}

TEST(Associate, TellsTheBestAssociationsFromTheHeaviestOn) {
  const Bearings files = simulated("--targets 10 --spacing 300 --noise-mrad 5");
  const auto run = files.associate("--json --best 20");
  ASSERT_EQ(run.code, 0) << run.err;
  const auto json = nlohmann::json::parse(run.out);
  const auto& scan = json["scans"][0];
  const auto& best = scan["best"];
  ASSERT_EQ(best.size(), 20U);
  EXPECT_NEAR(best[0]["weight"].get<double>(), scan["primal"].get<double>(), 1e-6);
  for (std::size_t k = 0; k < best.size(); ++k) {
    EXPECT_EQ(best[k]["targets"], best[k]["tuples"].size());
    if (k == 0) continue;
    EXPECT_LE(best[k]["weight"].get<double>(), best[k - 1]["weight"].get<double>());
    EXPECT_NE(best[k]["tuples"], best[k - 1]["tuples"]);
  }
}

TEST(Associate, RefusesANumberOfBestAssociationsOutOfRange) {
  const Bearings files = written(kOneTarget);
  for (const char* count : {"0", "1001", "-3", "many"}) {
    const auto run = files.associate(std::string("--best ") + count);
    EXPECT_EQ(run.code, 2) << count;
    EXPECT_THAT(run.err, HasSubstr("--best"));
  }
}

TEST(AssociateReport, StandsAloneAndShowsEveryCostAndTruth) {
  const Bearings files = simulated("--targets 6 --spacing 500 --noise-mrad 10");
  const auto run = files.associate("--report " + files.at("page.html") + " --truth " + files.truth +
                                   " --best 4");
  ASSERT_EQ(run.code, 0) << run.err;
  const auto page = content_of(files.at("page.html"));
  EXPECT_THAT(page, AllOf(HasSubstr("<svg"), HasSubstr("From the side"), HasSubstr("<ellipse"),
                          HasSubstr("leave_one_out"), HasSubstr("renyi_literal"),
                          HasSubstr("The best associations"), HasSubstr("r=\"5.5\"")));
  EXPECT_THAT(page, Not(AnyOf(HasSubstr("http"), HasSubstr("<script"), HasSubstr("src="))));
  EXPECT_THAT(page, Not(HasSubstr("nan")));
}

TEST(AssociateReport, EscapesNamesOfSensors) {
  const Bearings files =
      written(replaced(kOneTarget, ",a,", ",<b>&,"), replaced(kTwoSensors, "\"a\"", "\"<b>&\""));
  const auto run = files.associate("--report " + files.at("page.html"));
  ASSERT_EQ(run.code, 0) << run.err;
  EXPECT_THAT(content_of(files.at("page.html")),
              AllOf(HasSubstr("&lt;b&gt;&amp;"), Not(HasSubstr("<b>&"))));
}

TEST(Associate, RefusesSensorsThatCannotLocateAnything) {
  const std::pair<std::string, std::string> tries[] = {
      {std::string(kTwoSensors, std::string(kTwoSensors).rfind("[[sensor]]")), "sensor"},
      {replaced(kTwoSensors, "[1000, 0, 0]", "[0, 0, 0]"), "place"},
      {replaced(kTwoSensors, "\"b\"", "\"a\""), "twice"},
      {replaced(kTwoSensors, "0.005", "-0.005"), "sigma_azimuth_rad"},
      {replaced(kTwoSensors, "0.005", "nan"), "sigma_azimuth_rad"},
      {replaced(kTwoSensors, "sigma_azimuth_rad = 0.005",
                "sigma_azimuth_rad = 0.005\n"
                "clutter_per_sr = -1"),
       "clutter_per_sr"},
      {replaced(kTwoSensors, "sigma_azimuth_rad = 0.005",
                "sigma_azimuth_rad = 0.005\n"
                "detection_probability = 1.5"),
       "detection_probability"},
      {replaced(kTwoSensors, "position_m", "positon_m"), "position_m"},
      {"", "sensor"},
      {std::string("\x7f\x45LF\x02\x01\x01\0\0\0", 10), "sensors.toml"}};
  for (const auto& [sensors, word] : tries) {
    const auto run = written(kOneTarget, sensors).associate();
    EXPECT_EQ(run.code, 2) << sensors;
    EXPECT_THAT(run.err, AllOf(HasSubstr("scanfuse: error: "), HasSubstr(word))) << sensors;
  }
}

TEST(Associate, SkipsAndCountsRowsItCannotUse) {
  const std::pair<const char*, const char*> rows[] = {
      {"0,0,a,0,0.2,0\n", "given twice"},           {"0,0,nobody,1,0.2,0\n", "no sensor"},
      {"0,0,a,1,nan,0\n", "azimuth_rad"},           {"0,0,a,1,45,0\n", "azimuth in radians"},
      {"0,0,a,1,0.2,-7\n", "elevation in radians"}, {"0,0,a,1,,0\n", "azimuth_rad"},
      {"0,0,a,1,0.2,\n", "elevation_rad"}};
  for (const auto& [row, word] : rows) {
    const auto run = written(std::string(kOneTarget) + row).associate("--json");
    EXPECT_EQ(run.code, 3) << row;
    EXPECT_THAT(run.err, HasSubstr(word)) << row;
    const auto json = nlohmann::json::parse(run.out);
    EXPECT_EQ(json["scans"][0]["targets"], 1) << row;
  }
}

TEST(Associate, RefusesFilesThatHoldNoBearings) {
  const Bearings files = written(kOneTarget);
  files.place->write("empty.csv", "");
  files.place->write("header.csv", kHeader);
  files.place->write("binary.csv", std::string("\x89PNG\r\n\x1a\n\0\0\0\rIHDR", 16));
  for (const char* name : {"empty.csv", "header.csv", "binary.csv", ".", "missing.csv"}) {
    const auto run =
        run_tool(*files.place, "associate " + files.at(name) + " --sensors " + files.sensors);
    EXPECT_EQ(run.code, 2) << name;
    EXPECT_THAT(run.err, HasSubstr("scanfuse: error: ")) << name;
  }
}

TEST(Associate, SortsScansThatComeOutOfOrderAndSaysSo) {
  const auto run = written("1,1,a,0,0.785398,0\n1,1,b,0,2.356194,0\n" + std::string(kOneTarget))
                       .associate("--json");
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_THAT(run.err, HasSubstr("out of order"));
  const auto json = nlohmann::json::parse(run.out);
  ASSERT_EQ(json["scans"].size(), 2U);
  EXPECT_EQ(json["scans"][0]["scan"], 0);
}

TEST(Associate, FindsNothingInParallelOrLonelyLines) {
  const Bearings files[] = {written("0,0,a,0,1.0,0\n0,0,b,0,1.0,0\n"), written("0,0,a,0,1.0,0\n"),
                            written("0,0,a,0,1.0,0\n0,0,a,1,1.1,0\n")};
  for (const Bearings& each : files) {
    const auto run = each.associate("--json -o " + each.at("fixes.csv"));
    EXPECT_EQ(run.code, 0) << run.err;
    EXPECT_EQ(nlohmann::json::parse(run.out)["scans"][0]["targets"], 0);
    EXPECT_THAT(content_of(each.at("fixes.csv")), Not(HasSubstr("nan")));
  }
}

TEST(Associate, KeepsTheFixesBeforeAScanThatIsTooMuch) {
  std::string rows = kOneTarget;
  for (int k = 0; k < 200; ++k) {
    const std::string place = std::to_string(k) + "," + std::to_string(0.5 + 0.002 * k) + ",0\n";
    rows += "1,1,a," + place + "1,1,b," + place;
  }
  const Bearings files = written(rows);
  const auto run = files.associate("--set candidates.most_pairs=1000 -o " + files.at("fixes.csv"));
  EXPECT_EQ(run.code, 2);
  EXPECT_THAT(run.err, AllOf(HasSubstr("scan 1: too many ways"), HasSubstr("most_pairs")));
  EXPECT_THAT(content_of(files.at("fixes.csv")), HasSubstr("\n0,"));
  EXPECT_THAT(unfinished_files(*files.place), IsEmpty());
}

TEST(Associate, RefusesTruthWithoutAReport) {
  const Bearings files = simulated();
  EXPECT_EQ(files.associate("--truth " + files.truth).code, 2);
}

TEST(Associate, NeverWritesOverItsInput) {
  const Bearings files = written(kOneTarget);
  for (const auto& [option, path] : {std::pair{"-o ", files.bearings},
                                     {"--report ", files.sensors},
                                     {"--assignments ", files.bearings}}) {
    EXPECT_EQ(files.associate(option + path).code, 2) << option;
  }
  EXPECT_THAT(content_of(files.bearings), HasSubstr("0.785398"));
}

TEST(Associate, AnswersASceneOfFalseAlarmsOnly) {
  const Bearings files = simulated("--targets 0 --set passive.false_alarms=20");
  const auto run = files.associate("--json");
  EXPECT_EQ(run.code, 0) << run.err;
}

TEST(CtrlC, EndsAssociateWithTheFixesSoFar) {
  const Bearings files = simulated("--targets 5 --spacing 3000 --set passive.scans=20000");
  const auto out = files.at("fixes.csv");
  EXPECT_EQ(interrupt_tool({"associate", files.bearings, "--sensors", files.sensors, "-o", out},
                           out + ".part"),
            130);
  EXPECT_THAT(unfinished_files(*files.place), IsEmpty());
  const auto text = content_of(out);
  EXPECT_THAT(text, HasSubstr("existence_probability"));
  EXPECT_EQ(text.back(), '\n');
}

}  // namespace
}  // namespace scanfuse::tool_testing
