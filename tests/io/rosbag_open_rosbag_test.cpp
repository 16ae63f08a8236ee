#include <gtest/gtest.h>
#include <zlib.h>

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "io/rosbag_builder.hpp"
#include "scanfuse/io/ros/decoding_reader.hpp"
#include "scanfuse/io/rosbag/open_rosbag.hpp"

namespace scanfuse::io {
namespace {

Result<std::unique_ptr<RawMessageSource>> open_bytes(const std::string& bytes,
                                                     const std::vector<std::string>& topics = {}) {
  return open_rosbag(std::make_unique<std::istringstream>(bytes), "test.bag", topics);
}

/// "second:topic:bytes" of every message.
std::vector<std::string> bag_lines(RawMessageSource& source) {
  std::vector<std::string> lines;
  while (true) {
    auto message = source.next();
    if (!message || !*message) return lines;
    std::string text(reinterpret_cast<const char*>((*message)->bytes.data()),
                     (*message)->bytes.size());
    lines.push_back(std::to_string(to_nanos((*message)->log_time) / 1'000'000'000) + ":" +
                    source.channels()[(*message)->channel].topic + ":" + text);
  }
}

/// Two chunks that overlap in time, messages out of order within the first.
RosbagBuilder overlapping_bag(const std::string& compression) {
  RosbagBuilder builder(compression);
  builder.connection(0, "/a", "std_msgs/String");
  builder.connection(7, "/b", "std_msgs/String");
  builder.message(0, 5, "five");
  builder.message(7, 1, "one");
  builder.message(0, 3, "three");
  builder.close_chunk();
  builder.message(7, 2, "two");
  builder.message(0, 4, "four");
  builder.message(7, 6, "six");
  builder.close_chunk();
  return builder;
}

const std::vector<std::string> kInOrder{"1:/b:one",  "2:/b:two",  "3:/a:three",
                                        "4:/a:four", "5:/a:five", "6:/b:six"};

TEST(Rosbag, MessagesOfOverlappingChunksComeInOrderOfTime) {
  for (const char* compression : {"none", "bz2", "lz4"}) {
    auto source = open_bytes(overlapping_bag(compression).finish());
    ASSERT_TRUE(source.has_value()) << source.error().message;
    EXPECT_EQ(bag_lines(**source), kInOrder) << compression;
    EXPECT_TRUE((*source)->diagnostics().empty());
    EXPECT_EQ((*source)->info().compression, compression);
    ASSERT_EQ((*source)->info().topics.size(), 2U);
    EXPECT_EQ((*source)->info().topics[1].messages, 3);
    EXPECT_EQ((*source)->info().end, time_from_seconds(6));
  }
}

TEST(Rosbag, OnlyTheWantedTopicsCome) {
  auto source = open_bytes(overlapping_bag("none").finish(), {"/b"});
  ASSERT_TRUE(source.has_value());
  EXPECT_EQ(bag_lines(**source), (std::vector<std::string>{"1:/b:one", "2:/b:two", "6:/b:six"}));
}

TEST(Rosbag, ABagThatWasNeverClosedIsReadWholeAndCountedAsDamage) {
  for (const char* compression : {"none", "bz2", "lz4"}) {
    auto source = open_bytes(overlapping_bag(compression).finish(false));
    ASSERT_TRUE(source.has_value());
    EXPECT_EQ(bag_lines(**source), kInOrder);
    EXPECT_TRUE((*source)->diagnostics().any_damage());
  }
}

TEST(Rosbag, AnEmptyBagIsFine) {
  auto source = open_bytes(RosbagBuilder().finish());
  ASSERT_TRUE(source.has_value());
  EXPECT_TRUE(bag_lines(**source).empty());
  EXPECT_TRUE((*source)->diagnostics().empty());
}

TEST(Rosbag, AnOldBagIsRefusedWithWhatToDo) {
  const auto source = open_bytes("#ROSBAG V1.2\nop=...");
  ASSERT_FALSE(source.has_value());
  EXPECT_EQ(source.error().code, Error::Code::kUnsupported);
  EXPECT_NE(source.error().message.find("rosbag fix test.bag"), std::string::npos);
}

TEST(Rosbag, AMissingFileIsNotFound) {
  EXPECT_EQ(open_rosbag("/nonexistent/x.bag").error().code, Error::Code::kNotFound);
}

TEST(Rosbag, CutAtAnyByteItGivesAPrefixOfEachChunkOrAnError) {
  for (const char* compression : {"none", "bz2", "lz4"}) {
    const auto whole = overlapping_bag(compression).finish();
    for (std::size_t length = 0; length < whole.size(); ++length) {
      auto source = open_bytes(whole.substr(0, length));
      if (!source) {
        EXPECT_FALSE(source.error().message.empty());
        continue;
      }
      EXPECT_LE(bag_lines(**source).size(), 6U);
      EXPECT_TRUE((*source)->diagnostics().any_damage()) << compression << " cut at " << length;
    }
  }
}

TEST(Rosbag, CutWithinAPlainChunkItGivesTheMessagesBeforeTheCut) {
  const auto whole = overlapping_bag("none").finish();
  auto source = open_bytes(whole.substr(0, whole.find("four")));
  ASSERT_TRUE(source.has_value());
  EXPECT_EQ(bag_lines(**source),
            (std::vector<std::string>{"1:/b:one", "2:/b:two", "3:/a:three", "5:/a:five"}));
}

TEST(Rosbag, AnyFlippedBitIsSurvived) {
  for (const char* compression : {"none", "bz2", "lz4"}) {
    const auto whole = overlapping_bag(compression).finish();
    for (std::size_t bit = 0; bit < whole.size() * 8; ++bit) {
      auto damaged = whole;
      damaged[bit / 8] = static_cast<char>(damaged[bit / 8] ^ 1 << bit % 8);
      auto source = open_bytes(damaged);
      if (!source) continue;
      EXPECT_LE(bag_lines(**source).size(), 12U);
    }
  }
}

TEST(Rosbag, ADamagedChunkDoesNotHideTheOthers) {
  auto whole = overlapping_bag("lz4").finish();
  whole[whole.find("op=\x05") + 30] = '\x55';
  auto source = open_bytes(whole);
  ASSERT_TRUE(source.has_value());
  EXPECT_GE(bag_lines(**source).size(), 3U);
  EXPECT_TRUE((*source)->diagnostics().any_damage());
}

/// What Python's rosbag reads: "topic nanoseconds crc32" lines, sorted.
std::vector<std::string> oracle_lines(const std::string& path) {
  const std::string command =
      "/usr/bin/python3 -c 'import rosbag,sys,zlib\n"
      "for t,m,s in rosbag.Bag(sys.argv[1]).read_messages(raw=True):\n"
      "  print(t,s.to_nsec(),zlib.crc32(m[1]))' '" +
      path + "' 2>/dev/null";
  std::vector<std::string> lines;
  FILE* pipe = popen(command.c_str(), "r");
  char line[512];
  while (std::fgets(line, sizeof line, pipe) != nullptr) {
    lines.emplace_back(line, std::char_traits<char>::length(line) - 1);
  }
  pclose(pipe);
  std::sort(lines.begin(), lines.end());
  return lines;
}

std::vector<std::string> our_lines(RawMessageSource& source) {
  std::vector<std::string> lines;
  Time last{};
  while (true) {
    auto message = source.next();
    EXPECT_TRUE(message.has_value());
    if (!message || !*message) break;
    EXPECT_GE((*message)->log_time, last);
    last = (*message)->log_time;
    const auto& bytes = (*message)->bytes;
    const auto sum =
        crc32(0, reinterpret_cast<const Bytef*>(bytes.data()), static_cast<uInt>(bytes.size()));
    lines.push_back(
        fmt::format("{} {} {}", source.channels()[(*message)->channel].topic, to_nanos(last), sum));
  }
  std::sort(lines.begin(), lines.end());
  return lines;
}

TEST(Rosbag, RealBagsReadAsPythonsRosbagReadsThem) {
  if (!std::filesystem::exists(SCANFUSE_SHARED_DATA)) GTEST_SKIP() << "no shared data: skipped";
  const std::string root = SCANFUSE_SHARED_DATA;
  for (const char* name :
       {"/people/positive_1.bag", "/sensors/sick/rms_1xxx_lms_1xx_movement_off.bag"}) {
    auto source = open_rosbag(root + name);
    ASSERT_TRUE(source.has_value()) << source.error().message;
    const auto lines = our_lines(**source);
    EXPECT_FALSE((*source)->diagnostics().any_damage());
    const auto expected = oracle_lines(root + name);
    if (expected.empty()) GTEST_SKIP() << "python3-rosbag is not installed: skipped";
    EXPECT_EQ(lines, expected) << name;
  }
}

TEST(Rosbag, ARealOldBagIsRefused) {
  const std::string path =
      SCANFUSE_SHARED_DATA "/formats/scan_tools/laser_scan_splitter/demo/demo.bag";
  if (!std::filesystem::exists(path)) GTEST_SKIP() << "no shared data: skipped";
  const auto source = open_rosbag(path);
  ASSERT_FALSE(source.has_value());
  EXPECT_EQ(source.error().code, Error::Code::kUnsupported);
}

TEST(Rosbag, RealScansDecodeWithoutLoss) {
  const std::string path = SCANFUSE_SHARED_DATA "/datmo/overtake_ego.bag";
  if (!std::filesystem::exists(path)) GTEST_SKIP() << "no shared data: skipped";
  auto source = open_rosbag(path);
  ASSERT_TRUE(source.has_value());
  const auto reader = decode_messages(std::move(*source));
  std::int64_t scans = 0, poses = 0, edges = 0, imus = 0;
  for (auto event = reader->next(); event && *event; event = reader->next()) {
    const auto& payload = (*event)->payload;
    if (const auto* scan = std::get_if<Scan>(&payload)) {
      EXPECT_EQ(scan->frame, scans++);
      EXPECT_EQ(scan->sensor, "/scan");
      EXPECT_EQ(scan->beams->columns, 360);
    }
    poses += std::holds_alternative<PoseSample>(payload);
    edges += std::holds_alternative<std::vector<TransformSample>>(payload);
    imus += std::holds_alternative<ImuSample>(payload);
  }
  EXPECT_EQ(scans, 135);
  EXPECT_EQ(poses, 2 * 1248);
  EXPECT_EQ(edges, 2496);
  EXPECT_EQ(imus, 1042);
  EXPECT_FALSE(reader->diagnostics().any_damage());
  EXPECT_EQ(reader->info().topics.size(), 7U);
}

}  // namespace
}  // namespace scanfuse::io
