#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>

#include "apps/tool.hpp"

// A turntable session by the tool: simulate, calibrate, assemble, measure, and what bad input says.
namespace scanfuse::tool_testing {
namespace {

namespace fs = std::filesystem;
using ::testing::AllOf;
using ::testing::HasSubstr;

struct Session {
  std::shared_ptr<TemporaryFolder> place = std::make_shared<TemporaryFolder>();

  [[nodiscard]] std::string at(const std::string& name) const {
    return (place->path() / name).string();
  }
  [[nodiscard]] Outcome run(const std::string& arguments) const {
    return run_tool(*place, arguments);
  }
  [[nodiscard]] Outcome calibrate(const std::string& more = "") const {
    return run("calibrate turntable " + at("session") + " -o " + at("rig.toml") + " " + more);
  }
  /// Replaces the first `from` of a file by `to`.
  void edit(const std::string& name, const std::string& from, const std::string& to) const {
    std::string text = content_of(at(name));
    const auto found = text.find(from);
    ASSERT_NE(found, text.npos) << name << ": " << from;
    place->write(name, text.replace(found, from.size(), to));
  }
};

Session session_with(const std::string& more = "--positions 30 --features-only") {
  Session session;
  const auto made =
      session.run("simulate turntable -o " + session.at("session") + " --seed 5 " + more);
  EXPECT_EQ(made.code, 0) << made.err;
  return session;
}

double angle_deg(const nlohmann::json& a, const nlohmann::json& b) {
  double dot = 0;
  for (std::size_t k = 0; k < 3; ++k) dot += a[k].get<double>() * b[k].get<double>();
  return std::acos(std::min(1.0, std::abs(dot))) * 57.29578;
}

// The truth is written as a rig; the estimate of the axis comes near it.
TEST(Turntable, FeaturesGiveTheRigAndItsCloudCanBeMeasured) {
  const Session session = session_with("--features-only");
  const auto done = session.calibrate("--json --report " + session.at("report.html"));
  ASSERT_EQ(done.code, 0) << done.err;
  const auto json = nlohmann::json::parse(done.out);
  EXPECT_EQ(json["positions_used"], 87);
  EXPECT_TRUE(json["positions_left_out"].empty());
  const std::string truth = content_of(session.at("session/truth.toml"));
  const auto from = truth.find('[', truth.find("direction = "));
  const auto direction =
      nlohmann::json::parse(truth.substr(from, truth.find(']', from) - from + 1));
  EXPECT_LT(angle_deg(json["axis"]["direction"], direction), 0.05);
  EXPECT_GT(fs::file_size(session.at("report.html")), 10000u);

  const std::string cloud = session.at("cloud.ply");
  const auto assembled = session.run("assemble " + session.at("session") + " --rig " +
                                     session.at("rig.toml") + " -o " + cloud + " --json");
  ASSERT_EQ(assembled.code, 0) << assembled.err;
  EXPECT_EQ(nlohmann::json::parse(assembled.out)["scans"], 87);
  const auto plane =
      session.run("measure plane " + cloud + " --rig " + session.at("rig.toml") + " --json");
  ASSERT_EQ(plane.code, 0) << plane.err;
  EXPECT_GT(nlohmann::json::parse(plane.out)["distance_mm"]["sigma_rig"].get<double>(), 0);
}

TEST(Turntable, SameSeedSameBytesWithAnyThreads) {
  const Session a = session_with(), b = session_with("--positions 30 --features-only --threads 1");
  EXPECT_EQ(content_of(a.at("session/features.json")), content_of(b.at("session/features.json")));
  ASSERT_EQ(a.calibrate("--threads 1").code, 0);
  ASSERT_EQ(b.calibrate("--threads 4").code, 0);
  EXPECT_EQ(content_of(a.at("rig.toml")), content_of(b.at("rig.toml")));
}

TEST(Turntable, RenderedImagesGiveTheRig) {
  const Session session = session_with("--positions 12 --set world.step_rad=0.02");
  const auto done = session.calibrate("--json");
  if (done.err.find("OpenCV") != std::string::npos) GTEST_SKIP() << "built without OpenCV";
  ASSERT_EQ(done.code, 0) << done.err;
  EXPECT_GE(nlohmann::json::parse(done.out)["positions_used"], 10);
  fs::remove(session.at("session/stripe_0003.png"));
  const auto fewer = session.calibrate("--json");
  ASSERT_EQ(fewer.code, 0) << fewer.err;
  EXPECT_THAT(fewer.err, HasSubstr("stripe_0003.png is missing"));
  session.edit("session/session.toml", "rows = 14", "rows = 11");
  const auto other = session.calibrate();
  EXPECT_EQ(other.code, 2);
  EXPECT_THAT(other.err, HasSubstr("board.png"));
}

TEST(Turntable, PoseOfOnePosition) {
  const Session session = session_with();
  const auto pose = session.run("calibrate pose " + session.at("session") + " --position 3 --json");
  ASSERT_EQ(pose.code, 0) << pose.err;
  EXPECT_EQ(nlohmann::json::parse(pose.out)["center_mm"].size(), 3u);
  const auto beyond = session.run("calibrate pose " + session.at("session") + " --position 30");
  EXPECT_EQ(beyond.code, 2);
  EXPECT_THAT(beyond.err, HasSubstr("positions 0 to 29"));
}

TEST(Turntable, BadInputNamesFileAndRemedy) {
  const Session session = session_with();
  EXPECT_EQ(session.run("calibrate turntable " + session.at("nowhere")).code, 2);
  session.edit("session/session.toml", "range_unit = \"m\"", "range_unit = \"mm\"");
  fs::rename(session.at("session/features.json"), session.at("features.json"));
  const auto units = session.run("assemble " + session.at("session") + " --rig " +
                                 session.at("session/truth.toml") + " -o " + session.at("c.ply"));
  EXPECT_EQ(units.code, 2);
  EXPECT_THAT(units.err, AllOf(HasSubstr("scan_0000.csv"), HasSubstr("range_unit = \"m\"")));
  const auto images = session.run("calibrate turntable " + session.at("session"));
  EXPECT_EQ(images.code, 2);
  const auto crop = session.run("measure disc " + session.at("c.ply") + " --crop 1,2,3");
  EXPECT_EQ(crop.code, 2);
  EXPECT_THAT(crop.err, HasSubstr("X0,X1,Y0,Y1,Z0,Z1"));
  EXPECT_TRUE(unfinished_files(*session.place).empty());
}

TEST(Turntable, TwoPositionsAreTooFew) {
  const Session session = session_with("--positions 2 --features-only");
  const auto done = session.calibrate();
  EXPECT_EQ(done.code, 2);
  EXPECT_THAT(done.err, AllOf(HasSubstr("session.toml"), HasSubstr("at least 3")));
}

TEST(Turntable, MissingScansAreListedAndLeftOut) {
  const Session session = session_with();
  fs::remove(session.at("session/features.json"));
  fs::remove(session.at("session/scan_0004.csv"));
  const auto done = session.run("assemble " + session.at("session") + " --rig " +
                                session.at("session/truth.toml") + " -o " + session.at("c.pcd") +
                                " --frame axis --json");
  EXPECT_EQ(done.code, 3) << done.err;
  EXPECT_THAT(done.err, HasSubstr("scan_0004.csv is missing"));
  EXPECT_EQ(nlohmann::json::parse(done.out)["scans_left_out"], 1);
}

}  // namespace
}  // namespace scanfuse::tool_testing
