#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "tool.hpp"

namespace scanfuse {
namespace {

using testing::HasSubstr;
using tool_testing::content_of;
using tool_testing::run_tool;
using tool_testing::TemporaryFolder;

TEST(LearnClasses, WhatItWritesTracksWith) {
  const TemporaryFolder folder;
  const auto scene = (folder.path() / "scene.mcap").string();
  const auto classes = (folder.path() / "classes.toml").string();
  const auto page = (folder.path() / "report.html").string();
  ASSERT_EQ(run_tool(folder, "simulate road-users --seed 3 -o " + scene).code, 0);
  const auto learned = run_tool(
      folder, "learn classes " + scene + " -o " + classes + " --report " + page + " --json");
  ASSERT_EQ(learned.code, 0) << learned.err;
  EXPECT_THAT(learned.out, HasSubstr("expected_calibration_error"));
  EXPECT_THAT(content_of(page), HasSubstr("Reference intervals"));
  const auto tracked = run_tool(
      folder, "track " + scene + " --preset road-users --set classify.classes_file=" + classes +
                  " -o " + (folder.path() / "t.csv").string());
  EXPECT_EQ(tracked.code, 0) << tracked.err;
}

TEST(LearnClasses, RefusesWhatHoldsNoTruthOrIsNotThere) {
  const TemporaryFolder folder;
  const auto out = (folder.path() / "c.toml").string();
  EXPECT_EQ(run_tool(folder, "learn classes nowhere.mcap -o " + out).code, 2);
  std::ofstream(folder.path() / "p.csv") << "frame,time_s,x_m,y_m\n0,0,5,1\n0,0,5,1.1\n";
  const auto run =
      run_tool(folder, "learn classes " + (folder.path() / "p.csv").string() + " -o " + out);
  EXPECT_EQ(run.code, 2);
  EXPECT_THAT(run.err, HasSubstr("holds no truth"));
  EXPECT_FALSE(std::filesystem::exists(out));
}

TEST(LearnClasses, AClassesFileWithAWrongKeyIsRefusedByName) {
  const TemporaryFolder folder;
  std::ofstream(folder.path() / "c.toml") << "[belief]\nmemori_s = 1.0\n";
  const auto run = run_tool(folder, "config --preset road-users --set classify.classes_file=" +
                                        (folder.path() / "c.toml").string());
  EXPECT_EQ(run.code, 2);
  EXPECT_THAT(run.err, HasSubstr("memori_s"));
}

}  // namespace
}  // namespace scanfuse
