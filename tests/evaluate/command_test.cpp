#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>

namespace scanfuse::evaluate {
namespace {

struct Ran {
  int exit_code = -1;
  std::string out;
};

Ran run_tool(const std::string& arguments) {
  Ran ran;
  FILE* pipe = popen((std::string(SCANFUSE_TOOL) + " " + arguments + " 2>/dev/null").c_str(), "r");
  if (pipe == nullptr) return ran;
  std::array<char, 4096> block{};
  while (std::size_t n = std::fread(block.data(), 1, block.size(), pipe)) {
    ran.out.append(block.data(), n);
  }
  ran.exit_code = WEXITSTATUS(pclose(pipe));
  return ran;
}

class EvaluateCommand : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = std::filesystem::path(testing::TempDir()) /
              ("scanfuse_evaluate_command_" + std::to_string(::getpid()));
    std::filesystem::create_directories(folder_);
    std::ofstream(truth()) << "frame,time_s,object_id,class,x_m,y_m\n"
                              "0,0.0,1,vehicle,10,0\n1,0.1,1,vehicle,11,0\n";
    std::ofstream(tracks()) << "time_s,frame,track_id,class,status,x_m,y_m\n"
                               "0.0,0,7,vehicle,confirmed,10.5,0\n0.1,1,7,vehicle,confirmed,11,0\n"
                               "0.1,1,8,vehicle,tentative,40,0\n";
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }
  [[nodiscard]] std::string truth() const { return (folder_ / "truth.csv").string(); }
  [[nodiscard]] std::string tracks() const { return (folder_ / "tracks.csv").string(); }

  std::filesystem::path folder_;
};

TEST_F(EvaluateCommand, ScoresATableAgainstATable) {
  const Ran ran = run_tool("evaluate " + tracks() + " --truth " + truth() + " --json");
  ASSERT_EQ(ran.exit_code, 0);
  const auto json = nlohmann::json::parse(ran.out);
  EXPECT_EQ(json["clear"]["MOTA"], 1.0);
  EXPECT_EQ(json["clear"]["MOTP_m"], 0.25);
  EXPECT_TRUE(json["consistency"]["anees"].is_null());
}

TEST_F(EvaluateCommand, EndsWithTwoOnBadInput) {
  EXPECT_EQ(run_tool("evaluate nothing.csv --truth " + truth()).exit_code, 2);
  EXPECT_EQ(run_tool("evaluate " + tracks() + " --truth nothing.csv").exit_code, 2);
  EXPECT_EQ(
      run_tool("evaluate " + tracks() + " --truth " + truth() + " --region 5,1,0,1").exit_code, 2);
  EXPECT_EQ(run_tool("evaluate " + tracks()).exit_code, 2);
}

TEST_F(EvaluateCommand, TakesARegionWithNegativeNumbers) {
  const Ran ran =
      run_tool("evaluate " + tracks() + " --truth " + truth() + " --json --region -5,10.6,-5,5");
  ASSERT_EQ(ran.exit_code, 0);
  EXPECT_EQ(nlohmann::json::parse(ran.out)["clear"]["TP"], 1);
}

}  // namespace
}  // namespace scanfuse::evaluate
