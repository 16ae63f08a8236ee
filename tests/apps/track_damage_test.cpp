#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "apps/tool.hpp"
#include "scanfuse/core/random.hpp"

// `scanfuse track` on damaged recordings: it says what is wrong with which file, and ends.
namespace scanfuse::tool_testing {
namespace {

using ::testing::AnyOf;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

class TrackOfDamaged : public ::testing::Test {
 protected:
  /// A simulated recording as bytes: `name` says in which format.
  std::string simulated(const std::string& name) {
    const auto path = (folder_.path() / name).string();
    EXPECT_EQ(run_tool(folder_, "simulate lu2018-1 --frames 12 -o " + path).code, 0);
    return content_of(path);
  }
  Outcome track(const std::string& name, const std::string& bytes) {
    const auto path = folder_.write(name, bytes).string();
    const auto out = folder_.path() / "tracks.csv";
    std::filesystem::remove(out);
    auto outcome = run_tool(folder_, "track " + path + " -o " + out.string());
    EXPECT_THAT(unfinished_files(folder_), IsEmpty());
    EXPECT_EQ(std::filesystem::exists(out), outcome.code == 0 || outcome.code == 3);
    EXPECT_EQ(content_of(out).find("nan"), std::string::npos);
    return outcome;
  }
  void expect_complaint(const Outcome& outcome, const std::string& about, const std::string& what) {
    EXPECT_THAT(outcome.code, AnyOf(2, 3)) << what << "\n" << outcome.err;
    EXPECT_THAT(outcome.err, HasSubstr(about)) << what;
    EXPECT_THAT(outcome.err, AnyOf(HasSubstr("error:"), HasSubstr("damage:"))) << what;
  }

  TemporaryFolder folder_;
};

TEST_F(TrackOfDamaged, TruncatedMcapKeepsWhatCameBefore) {
  const auto bytes = simulated("whole.mcap");
  for (const double share : {0.02, 0.3, 0.6, 0.9, 0.999}) {
    const auto length = static_cast<std::size_t>(share * static_cast<double>(bytes.size()));
    expect_complaint(track("cut.mcap", bytes.substr(0, length)), "cut.mcap",
                     "cut at " + std::to_string(length));
  }
}

TEST_F(TrackOfDamaged, FlippedBitsOfMcapAreMetSafely) {
  const auto bytes = simulated("whole.mcap");
  RandomStream random(1);
  int complaints = 0;
  for (int i = 0; i < 12; ++i) {
    auto damaged = bytes;
    for (int k = 0; k <= i; ++k) {
      damaged[random.below(damaged.size())] ^= static_cast<char>(1U << random.below(8));
    }
    const auto outcome = track("flipped.mcap", damaged);
    EXPECT_THAT(outcome.code, AnyOf(0, 2, 3)) << outcome.err;
    if (outcome.code == 0) continue;
    ++complaints;
    expect_complaint(outcome, "flipped.mcap", std::to_string(i));
  }
  EXPECT_GE(complaints, 8);  // chunks carry checksums: next to nothing passes unseen
}

TEST_F(TrackOfDamaged, EmptyAndForeignFilesAreRefused) {
  for (const char* name : {"a.mcap", "a.bag", "a.csv", "a.pcd", "a.log", "a.db3", "a.bin"}) {
    for (const std::string bytes : {"", "\n", "hello", "\x89PNG\r\n"}) {
      const auto outcome = track(name, bytes);
      EXPECT_EQ(outcome.code, 2) << name << " of '" << bytes << "'";
      EXPECT_THAT(outcome.err, HasSubstr(name));
    }
  }
}

TEST_F(TrackOfDamaged, TruncatedOrMutilatedTablesNameTheLine) {
  const auto bytes = simulated("whole.csv");
  const auto middle = bytes.find('\n', bytes.size() / 2);
  expect_complaint(track("half.csv", bytes.substr(0, middle + 8)), "half.csv:", "half a row");
  expect_complaint(track("words.csv", bytes.substr(0, middle + 1) + "5,x,y,z,,,\n"),
                   "words.csv:", "words");
  expect_complaint(track("head.csv", bytes.substr(bytes.find('\n') + 1)), "head.csv", "no header");
}

TEST_F(TrackOfDamaged, TablesFullOfNanAreRefused) {
  std::string text = "frame,time_s,x_m,y_m\n";
  for (int i = 0; i < 50; ++i) text += std::to_string(i) + ",nan,nan,inf\n";
  expect_complaint(track("nan.csv", text), "nan.csv:", "nan");
}

TEST_F(TrackOfDamaged, TimeThatJumpsOrRunsBackwardsIsSaid) {
  std::string text = "frame,time_s,x_m,y_m\n";
  const double times[] = {0, 0.04, 0.08, 5000, 5000.04, 2, 2.04, 1.99, 2.08, 2.08};
  for (int i = 0; i < 10; ++i) {
    for (int k = 0; k < 12; ++k) {
      text += std::to_string(i) + "," + std::to_string(times[i]) + ",10," +
              std::to_string(k * 0.15) + "\n";
    }
  }
  const auto outcome = track("jumps.csv", text);
  EXPECT_THAT(outcome.code, AnyOf(0, 2, 3)) << outcome.err;
  EXPECT_THAT(outcome.err, AnyOf(HasSubstr("stepped back"), HasSubstr("older"), HasSubstr("order"),
                                 HasSubstr("back in time")));
}

}  // namespace
}  // namespace scanfuse::tool_testing
