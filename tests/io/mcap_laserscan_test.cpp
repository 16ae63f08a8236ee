#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

#include "scanfuse/io/mcap/message_source.hpp"

namespace scanfuse::io {
namespace {

std::vector<RawMessage> all_messages(const std::filesystem::path& path, RecordingInfo& info) {
  std::vector<RawMessage> messages;
  auto source = open_mcap(path);
  EXPECT_TRUE(source.has_value()) << (source ? "" : source.error().message);
  if (!source) return messages;
  info = (*source)->info();
  for (;;) {
    auto message = (*source)->next();
    EXPECT_TRUE(message.has_value());
    if (!message || !*message) break;
    messages.push_back(std::move(**message));
  }
  EXPECT_TRUE((*source)->diagnostics().empty());
  return messages;
}

// 300 scans written by another writer, as ros1 and ros2, under each compression.
TEST(McapLaserscan, SixFilesOfAnotherWriterGiveTheSame300Messages) {
  const std::filesystem::path folder = SCANFUSE_SHARED_DATA "/formats/mcap_laserscan";
  if (!std::filesystem::exists(folder)) GTEST_SKIP() << "no shared data: skipped";
  for (const std::string profile : {"ros1", "ros2"}) {
    std::vector<RawMessage> first;
    for (const std::string compression : {"none", "lz4", "zstd"}) {
      RecordingInfo info;
      auto messages =
          all_messages(folder / ("laserscan_" + profile + "_" + compression + ".mcap"), info);
      ASSERT_EQ(messages.size(), 300u);
      ASSERT_EQ(info.topics.size(), 1u);
      EXPECT_EQ(info.topics[0].messages, 300);
      EXPECT_EQ(info.topics[0].encoding, profile == "ros1" ? "ros1" : "cdr");
      EXPECT_EQ(info.compression, compression);
      EXPECT_EQ(info.start, messages.front().log_time);
      EXPECT_EQ(info.end, messages.back().log_time);
      if (first.empty()) first = messages;
      for (std::size_t i = 0; i < messages.size(); ++i) {
        ASSERT_EQ(messages[i].bytes, first[i].bytes) << compression << ' ' << i;
        ASSERT_EQ(messages[i].log_time, first[i].log_time);
      }
    }
  }
}

}  // namespace
}  // namespace scanfuse::io
