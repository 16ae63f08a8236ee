#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "scanfuse/io/mcap/message_reader.hpp"
#include "scanfuse/io/mcap/message_source.hpp"
#include "scanfuse/io/mcap/writer.hpp"

namespace scanfuse::io::mcap {
namespace {

struct Given {
  std::uint64_t time = 0;
  std::string text;
  bool operator==(const Given&) const = default;
};

/// One topic, each message 100 bytes of data that say its number; `times` in file order.
std::vector<std::byte> file_of(const std::vector<std::uint64_t>& times,
                               WriterOptions options = {}) {
  std::vector<std::byte> out;
  auto writer = Writer::create(sink_to_memory(out), options);
  EXPECT_TRUE(writer.has_value());
  const auto schema = writer->add_schema({0, "Text", "ros2msg", "string data"});
  const auto channel = writer->add_channel({0, *schema, "/a", "text", {}});
  const auto other = writer->add_channel({0, 0, "/b", "text", {{"unit", "m"}}});
  for (std::size_t i = 0; i < times.size(); ++i) {
    std::string text = std::to_string(i);
    text.resize(100, '.');
    const auto id = i % 3 == 2 ? *other : *channel;
    EXPECT_TRUE(writer->write(MessageView{id, static_cast<std::uint32_t>(i), times[i], times[i],
                                          std::as_bytes(std::span(text.data(), text.size()))}));
  }
  EXPECT_TRUE(writer->write(Attachment{5, 6, "notes.txt", "text/plain", {std::byte{7}}}));
  EXPECT_TRUE(writer->write(Metadata{"run", {{"seed", "1"}}}));
  EXPECT_TRUE(writer->finish());
  return out;
}

struct Outcome {
  std::vector<Given> messages;
  Diagnostics diagnostics;
  bool indexed = false;
  bool failed = false;
};

Outcome read_all(std::vector<std::byte> bytes, ReaderOptions options = {}) {
  Outcome outcome;
  auto reader = MessageReader::open(bytes_in_memory(std::move(bytes)), options);
  if (!reader) return outcome.failed = true, outcome;
  outcome.indexed = reader->indexed();
  for (;;) {
    const auto message = reader->next();
    if (!message) return outcome.failed = true, outcome;
    if (!*message) break;
    const auto data = (*message)->data;
    std::string text(reinterpret_cast<const char*>(data.data()), data.size());
    outcome.messages.push_back({(*message)->log_time, text.substr(0, text.find('.'))});
  }
  outcome.diagnostics = reader->diagnostics();
  return outcome;
}

std::vector<std::uint64_t> counting(std::size_t n) {
  std::vector<std::uint64_t> times(n);
  for (std::size_t i = 0; i < n; ++i) times[i] = 10 * i;
  return times;
}

WriterOptions small_chunks(Compression compression) {
  WriterOptions options;
  options.compression = compression;
  options.chunk_bytes = 500;
  return options;
}

const auto kCompressions = {Compression::kNone, Compression::kLz4, Compression::kZstd};

TEST(McapReader, GivesBackWhatWasWrittenUnderEveryCompression) {
  for (const auto compression : kCompressions) {
    const auto outcome = read_all(file_of(counting(20), small_chunks(compression)));
    ASSERT_EQ(outcome.messages.size(), 20u);
    EXPECT_TRUE(outcome.indexed);
    EXPECT_TRUE(outcome.diagnostics.empty());
    EXPECT_EQ(outcome.messages[7], (Given{70, "7"}));
  }
}

TEST(McapReader, MergesChunksThatOverlapInTime) {
  std::vector<std::uint64_t> times;
  for (std::uint64_t i = 0; i < 40; ++i) times.push_back((i * 17) % 40);
  const auto outcome = read_all(file_of(times, small_chunks(Compression::kZstd)));
  ASSERT_EQ(outcome.messages.size(), 40u);
  for (std::size_t i = 0; i < 40; ++i) EXPECT_EQ(outcome.messages[i].time, i);
  EXPECT_TRUE(outcome.diagnostics.empty());
}

TEST(McapReader, SaysSoWhenMoreChunksOverlapThanItMayHold) {
  std::vector<std::uint64_t> times;
  for (std::uint64_t i = 0; i < 40; ++i) times.push_back((i * 17) % 40);
  ReaderOptions options;
  options.max_open_chunks = 2;
  const auto outcome = read_all(file_of(times, small_chunks(Compression::kNone)), options);
  EXPECT_EQ(outcome.messages.size(), 40u);
  EXPECT_GT(outcome.diagnostics.count("more chunks overlap in time than are merged"), 0);
  EXPECT_FALSE(outcome.diagnostics.any_damage());
}

TEST(McapReader, SortsEachChunkByItselfWithoutAnIndex) {
  auto options = small_chunks(Compression::kNone);
  options.chunk_index = false;
  const auto outcome = read_all(file_of({30, 10, 20, 0, 60, 50, 40, 70}, options));
  EXPECT_FALSE(outcome.indexed);
  ASSERT_EQ(outcome.messages.size(), 8u);
  EXPECT_EQ(outcome.messages[0].time, 10u);  // the first chunk holds the first three
  EXPECT_EQ(outcome.messages[1].time, 20u);
  EXPECT_EQ(outcome.messages[2].time, 30u);
  EXPECT_EQ(outcome.messages[3].time, 0u);
  EXPECT_TRUE(outcome.diagnostics.empty());
}

TEST(McapReader, GivesOnlyTheWantedTopics) {
  for (const bool chunks : {true, false}) {
    auto writing = small_chunks(Compression::kLz4);
    writing.chunks = chunks;
    ReaderOptions options;
    options.topics = {"/b"};
    const auto outcome = read_all(file_of(counting(9), writing), options);
    ASSERT_EQ(outcome.messages.size(), 3u);
    EXPECT_EQ(outcome.messages[0].text, "2");
    EXPECT_TRUE(outcome.diagnostics.empty());
  }
}

TEST(McapReader, SkipsADamagedChunkAndNamesItsPlace) {
  auto bytes = file_of(counting(20), small_chunks(Compression::kNone));
  const std::string wanted = "7....";
  const auto place = std::search(bytes.begin(), bytes.end(), wanted.begin(), wanted.end(),
                                 [](std::byte a, char b) { return a == std::byte(b); });
  *(place + 50) ^= std::byte{1};
  const auto outcome = read_all(bytes);
  EXPECT_LT(outcome.messages.size(), 20u);
  EXPECT_GE(outcome.messages.size(), 16u);
  ASSERT_EQ(outcome.diagnostics.count("chunk with a wrong checksum skipped"), 1);
  EXPECT_TRUE(outcome.diagnostics.any_damage());
  EXPECT_THAT(outcome.diagnostics.entries().begin()->second.first, testing::StartsWith("byte "));
}

TEST(McapReader, CountsAWrongChecksumOfTheDataSection) {
  WriterOptions options;
  options.chunks = false;
  auto bytes = file_of(counting(3), options);
  const std::string wanted = "1....";
  const auto place = std::search(bytes.begin(), bytes.end(), wanted.begin(), wanted.end(),
                                 [](std::byte a, char b) { return a == std::byte(b); });
  *(place + 50) ^= std::byte{1};
  const auto outcome = read_all(bytes);
  EXPECT_EQ(outcome.messages.size(), 3u);
  EXPECT_EQ(outcome.diagnostics.count("record damaged or with a wrong checksum"), 1);
}

TEST(McapReader, StepsOverUnknownRecords) {
  WriterOptions options;
  options.chunks = false;
  auto bytes = file_of(counting(3), options);
  const std::vector<std::byte> unknown{std::byte{0x99}, std::byte{2}, {}, {}, {}, {}, {}, {}, {},
                                       std::byte{1},    std::byte{2}};
  bytes.insert(bytes.begin() + 8, unknown.begin(), unknown.end());
  EXPECT_EQ(read_all(bytes).messages.size(), 3u);
}

// Every complete record of a file that ends early is given: those of whole chunks always, those of
// the chunk that was cut off as far as its bytes go.
TEST(McapReader, RecoversTheCompleteRecordsOfATruncatedFile) {
  for (const auto compression : kCompressions) {
    auto options = small_chunks(compression);
    options.chunk_bytes = 1000;
    const auto whole = file_of(counting(30), options);
    const auto expected = read_all(whole).messages;
    std::size_t last = 0;
    for (std::size_t size = 8; size < whole.size(); ++size) {
      const auto outcome = read_all({whole.begin(), whole.begin() + static_cast<long>(size)});
      ASSERT_FALSE(outcome.failed);
      ASSERT_TRUE(outcome.diagnostics.any_damage()) << size;
      ASSERT_LE(outcome.messages.size(), expected.size());
      ASSERT_TRUE(std::equal(outcome.messages.begin(), outcome.messages.end(), expected.begin()));
      ASSERT_GE(outcome.messages.size(), last) << size;
      last = outcome.messages.size();
    }
    EXPECT_EQ(last, expected.size());
  }
}

TEST(McapReader, RecoversMessagesOfAChunkThatWasNeverClosed) {
  WriterOptions options;
  options.compression = Compression::kNone;
  const auto whole = file_of(counting(30), options);
  const auto outcome = read_all({whole.begin(), whole.begin() + 2000});
  EXPECT_GE(outcome.messages.size(), 12u);
  EXPECT_EQ(outcome.diagnostics.count("last record cut off"), 1);
}

TEST(McapReader, AnyFlippedBitGivesAnErrorOrACountOrLeavesTheMessagesAlone) {
  for (const auto compression : kCompressions) {
    const auto whole = file_of(counting(6), small_chunks(compression));
    const auto expected = read_all(whole).messages;
    for (std::size_t bit = 0; bit < 8 * whole.size(); ++bit) {
      auto bytes = whole;
      bytes[bit / 8] ^= static_cast<std::byte>(1u << (bit % 8));
      const auto outcome = read_all(bytes);
      if (outcome.failed || !outcome.diagnostics.empty()) continue;
      ASSERT_EQ(outcome.messages, expected) << "byte " << bit / 8;
    }
  }
}

TEST(McapReader, RefusesWhatIsNoMcapFile) {
  EXPECT_TRUE(read_all({}).failed);
  EXPECT_TRUE(read_all(std::vector<std::byte>(100)).failed);
  const auto missing = open_mcap("no/such/file.mcap");
  ASSERT_FALSE(missing.has_value());
  EXPECT_EQ(missing.error().code, Error::Code::kNotFound);
}

// A chunk may claim any size; no more is set aside than its bytes can hold.
TEST(McapReader, DoesNotTrustTheSizeAChunkClaims) {
  for (const auto compression : kCompressions) {
    auto bytes = file_of(counting(5), small_chunks(compression));
    const std::size_t chunk = 8 + 9 + 8 + 8;  // behind magic and header ("", "scanfuse")
    ASSERT_EQ(bytes[chunk], std::byte{6});
    for (const int top : {3, 7}) {  // 2^24 .. 2^56 times too much
      auto huge = bytes;
      huge[chunk + 9 + 16 + static_cast<std::size_t>(top)] = std::byte{0x10};
      EXPECT_TRUE(read_all(huge).diagnostics.any_damage());
    }
  }
}

TEST(McapWriter, GivesTheSameBytesEveryTime) {
  for (const auto compression : kCompressions) {
    EXPECT_EQ(file_of(counting(50), small_chunks(compression)),
              file_of(counting(50), small_chunks(compression)));
  }
}

TEST(McapWriter, LeavesNoFileWhenNotFinished) {
  const auto path = std::filesystem::temp_directory_path() / "scanfuse_unfinished.mcap";
  std::filesystem::remove(path);
  {
    auto writer = Writer::create(path);
    ASSERT_TRUE(writer.has_value());
    EXPECT_TRUE(std::filesystem::exists(path.string() + ".part"));
  }
  EXPECT_FALSE(std::filesystem::exists(path));
  EXPECT_FALSE(std::filesystem::exists(path.string() + ".part"));
}

TEST(McapWriter, ReportsAFullDisk) {
  if (!std::filesystem::exists("/dev/full")) GTEST_SKIP() << "no /dev/full";
  const auto path = std::filesystem::temp_directory_path() / "scanfuse_full.mcap";
  std::error_code ignored;
  std::filesystem::remove(path.string() + ".part", ignored);
  std::filesystem::create_symlink("/dev/full", path.string() + ".part");
  auto writer = Writer::create(path);
  const bool written = writer && writer->finish().has_value();
  EXPECT_FALSE(written);
  EXPECT_FALSE(std::filesystem::exists(path));
  std::filesystem::remove(path.string() + ".part", ignored);
}

TEST(McapWriter, ReportsAFolderThatDoesNotExist) {
  const auto writer = Writer::create("/no/such/folder/out.mcap");
  ASSERT_FALSE(writer.has_value());
  EXPECT_EQ(writer.error().code, Error::Code::kNotFound);
}

TEST(McapSource, KnowsTopicsAndCountsWithAndWithoutSummary) {
  for (const bool summary : {true, false}) {
    auto options = small_chunks(Compression::kZstd);
    options.statistics = options.chunk_index = options.repeated_channels = summary;
    auto source = open_mcap(bytes_in_memory(file_of(counting(9), options)));
    ASSERT_TRUE(source.has_value());
    const auto& info = (*source)->info();
    EXPECT_EQ(info.format, "mcap");
    EXPECT_EQ(info.compression, "zstd");
    ASSERT_EQ(info.topics.size(), 2u);
    EXPECT_EQ(info.topics[0].name, "/a");
    EXPECT_EQ(info.topics[0].type, "Text");
    EXPECT_TRUE(info.topics[0].counted);
    EXPECT_EQ(info.topics[0].messages, 6);
    EXPECT_EQ(info.topics[1].messages, 3);
    EXPECT_EQ(info.start, time_from_nanos(0));
    EXPECT_EQ(info.end, time_from_nanos(80));
    const auto first = (*source)->next();
    ASSERT_TRUE(first && *first);
    EXPECT_EQ((*source)->channels()[(*first)->channel].definition, "string data");
  }
}

}  // namespace
}  // namespace scanfuse::io::mcap
