#include <gmock/gmock.h>

#include "io/reading.hpp"
#include "io/temporary_folder.hpp"
#include "scanfuse/io/recording.hpp"

namespace scanfuse::io {
namespace {

using scanfuse::io_testing::TemporaryFolder;
using ::testing::HasSubstr;

std::string refusal_of(const std::filesystem::path& path) {
  const auto opened = open_recording(path);
  return opened ? "opened as " + (*opened)->info().format : opened.error().message;
}

TEST(OpenRecording, TheFormatIsFoundByContentNotByName) {
  const TemporaryFolder folder;
  const auto format_of = [&](std::string_view content) {
    const auto opened = open_recording(folder.write("recording.dat", content));
    return opened ? (*opened)->info().format : opened.error().message;
  };
  EXPECT_EQ(format_of("frame,time_s,x_m,y_m\n0,0,1,2\n"), "csv points");
  EXPECT_EQ(format_of("# log\nPARAM a b\nFLASER 1 2 0 0 0 0 0 0 1 h 1\n"), "carmen");
  EXPECT_EQ(format_of("# .PCD v.7\nFIELDS x y\nSIZE 4 4\nTYPE F F\nPOINTS 1\nDATA ascii\n1 2\n"),
            "pcd");
}

TEST(OpenRecording, WhatCannotBeOpenedIsSaidWithWhatIsKnown) {
  const TemporaryFolder folder;
  EXPECT_THAT(refusal_of(folder.path() / "missing.bag"), HasSubstr("no such file"));
  EXPECT_THAT(refusal_of(folder.write("empty.csv", "")), HasSubstr("is empty"));
  EXPECT_THAT(refusal_of(folder.write("a.zip", "PK\x03\x04....")), HasSubstr("unzip"));
  EXPECT_THAT(refusal_of(folder.write("notes.txt", "dear diary\n")), HasSubstr("CARMEN"));
  EXPECT_THAT(refusal_of(folder.write("truth.csv", "frame,time_s,object_id,class,x_m,y_m\n")),
              HasSubstr("table of truth"));
  std::filesystem::create_directories(folder.path() / "nothing");
  EXPECT_THAT(refusal_of(folder.path() / "nothing"), HasSubstr("without a recording"));
  EXPECT_THAT(refusal_of(folder.write("old.bag", "#ROSBAG V1.2\n")), HasSubstr("1.2"));
}

TEST(OpenRecording, GarbageBehindEveryMagicIsAnErrorOrDamage) {
  const TemporaryFolder folder;
  for (const std::string magic : {"\x89MCAP0\r\n", "#ROSBAG V2.0\n", "SQLite format 3", "\x1f\x8b",
                                  "\xfd"
                                  "7zXZ",
                                  "# .PCD v.7\n", "FLASER 3 ", "frame,time_s,x_m,y_m\n"}) {
    const auto path = folder.write("garbage", magic + std::string(300, '\x7f'));
    const auto out = scanfuse::io_testing::read_out(open_recording(path));
    EXPECT_TRUE(out.error || out.diagnostics.any_damage()) << magic;
  }
}

TEST(OpenRecording, EverySharedRecordingOfAKnownFormatOpens) {
  const std::filesystem::path data = SCANFUSE_SHARED_DATA;
  if (!std::filesystem::exists(data)) GTEST_SKIP() << "no shared data: skipped";
  int opened = 0;
  for (const auto* room : {"datmo", "people", "formats/mcap_laserscan", "formats/obstacle_detector",
                           "formats/carmen_ple/carmen"}) {
    for (const auto& entry : std::filesystem::recursive_directory_iterator(data / room)) {
      const auto name = entry.path().filename().string();
      if (!name.ends_with(".bag") && !name.ends_with(".mcap") && !name.ends_with(".log.gz"))
        continue;
      const auto recording = open_recording(entry.path());
      EXPECT_TRUE(recording) << recording.error().message;
      ++opened;
    }
  }
  EXPECT_GE(opened, 20);
}

}  // namespace
}  // namespace scanfuse::io
