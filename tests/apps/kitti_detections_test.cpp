#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sstream>

#include "apps/tool.hpp"

namespace scanfuse::tool_testing {
namespace {

using ::testing::HasSubstr;

/// A parked car 20 m ahead of the start, seen from a vehicle that drives towards it at 5 m/s.
std::string boxes_of_a_parked_car() {
  std::string text;
  for (int k = 0; k < 20; ++k) {
    text += std::to_string(k) + " -1 Car -1 -1 0 0 0 9 9 1.5 1.8 4.2 0 1.6 " +
            std::to_string(20 - 0.5 * k) + " 0 0.9\n";
  }
  return text;
}

std::string driving_at_5_m_per_s() {
  std::string text = "time_s,x_m,y_m,heading_rad\n";
  for (int k = 0; k < 20; ++k) {
    text += std::to_string(0.1 * k) + "," + std::to_string(0.5 * k) + ",0,0\n";
  }
  return text;
}

double last_speed_m_per_s(const std::filesystem::path& tracks) {
  std::istringstream lines(content_of(tracks));
  std::string header, line, last;
  std::getline(lines, header);
  while (std::getline(lines, line)) last = line;
  const auto cell = [](const std::string& row, int column) {
    std::istringstream cells(row);
    std::string text;
    for (int i = 0; i <= column; ++i) std::getline(cells, text, ',');
    return text;
  };
  for (int i = 0; i < 20; ++i) {
    if (cell(header, i) == "speed_m_per_s") return std::stod(cell(last, i));
  }
  return -1;
}

TEST(TrackKittiDetections, WithTheEgoMotionAParkedCarStands) {
  const TemporaryFolder folder;
  const auto boxes = folder.write("0000.txt", boxes_of_a_parked_car()).string();
  const auto ego = folder.write("ego.csv", driving_at_5_m_per_s()).string();
  const auto csv = folder.path() / "t.csv";
  const auto run = run_tool(folder, "track " + boxes + " --ego " + ego + " -o " + csv.string());
  ASSERT_EQ(run.code, 0) << run.err;
  EXPECT_THAT(run.err, HasSubstr("usual camera"));
  EXPECT_NEAR(last_speed_m_per_s(csv), 0, 0.3);
  const auto without = run_tool(folder, "track " + boxes + " -o " + csv.string());
  ASSERT_EQ(without.code, 0) << without.err;
  EXPECT_NEAR(last_speed_m_per_s(csv), 5, 0.5);
}

// Truth that lies beside the recording is scored, class by class, and drawn.
TEST(TrackWithTruth, ScoresAndReportsEachClass) {
  const TemporaryFolder folder;
  const auto boxes = folder.write("0000.txt", boxes_of_a_parked_car()).string();
  const auto ego = folder.write("ego.csv", driving_at_5_m_per_s()).string();
  std::string table = "frame,time_s,object_id,class,x_m,y_m\n";
  for (int k = 0; k < 20; ++k) {
    table += std::to_string(k) + "," + std::to_string(0.1 * k) + ",1,vehicle,20.27,0\n";
  }
  const auto truth = folder.write("truth.csv", table).string();
  const auto page = folder.path() / "r.html";
  const std::string track = "track " + boxes + " --ego " + ego + " --truth " + truth;
  const auto run = run_tool(folder, track + " --json --report " + page.string());
  ASSERT_EQ(run.code, 0) << run.err;
  EXPECT_THAT(run.out, HasSubstr("\"evaluation\""));
  EXPECT_THAT(content_of(page), HasSubstr("Each class against truth"));
  EXPECT_THAT(content_of(page), HasSubstr("\"g\":[[1,"));
  EXPECT_EQ(run_tool(folder, track + "x").code, 2);
  EXPECT_EQ(run_tool(folder, track + " --region 1,0,0,1").code, 2);
}

TEST(TrackKittiDetections, MistakesEndWithTwoAndNameTheirPlace) {
  const TemporaryFolder folder;
  const auto bad = folder.write("bad.txt", "0 -1 Car 0 0 0 0 0 9 9 x 1.8 4.2 0 1.6 20 0 1\n");
  const auto run = run_tool(folder, "track " + bad.string());
  EXPECT_EQ(run.code, 2);
  EXPECT_THAT(run.err, HasSubstr("bad.txt:1"));
  const auto good = folder.write("good.txt", boxes_of_a_parked_car()).string();
  EXPECT_EQ(run_tool(folder, "track " + good + " --calib none.txt").code, 2);
  EXPECT_EQ(run_tool(folder, "track " + good + " --frame-rate 0").code, 2);
}

}  // namespace
}  // namespace scanfuse::tool_testing
