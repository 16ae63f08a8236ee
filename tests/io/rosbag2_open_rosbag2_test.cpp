#include <gtest/gtest.h>
#include <unistd.h>
#include <zstd.h>

#include <filesystem>
#include <fstream>

#include "io/ros_test_scans.hpp"
#include "io/rosbag2_builder.hpp"
#include "scanfuse/io/ros/decoding_reader.hpp"
#include "scanfuse/io/ros/encode.hpp"
#include "scanfuse/io/rosbag2/bag_metadata.hpp"
#include "scanfuse/io/rosbag2/db3_source.hpp"
#include "scanfuse/io/rosbag2/open_rosbag2.hpp"

namespace scanfuse::io {
namespace {

namespace fs = std::filesystem;

std::vector<std::byte> as_bytes(const std::string& text) {
  const auto* data = reinterpret_cast<const std::byte*>(text.data());
  return {data, data + text.size()};
}

/// "nanoseconds:topic:bytes" of every message.
std::vector<std::string> bag2_lines(RawMessageSource& source) {
  std::vector<std::string> lines;
  while (true) {
    auto message = source.next();
    if (!message || !*message) return lines;
    const std::string text(reinterpret_cast<const char*>((*message)->bytes.data()),
                           (*message)->bytes.size());
    lines.push_back(fmt::format("{}:{}:{}", to_nanos((*message)->log_time),
                                source.channels()[(*message)->channel].topic, text));
  }
}

void fill_small(Db3Builder& builder) {
  builder.topic(3, "/a", "std_msgs/msg/String");
  builder.topic(9, "/b", "std_msgs/msg/String");
  builder.message(9, 30, as_bytes("three"));
  builder.message(3, 10, as_bytes("one"));
  builder.message(9, 20, as_bytes(std::string(700, 'x')));
}

Result<std::unique_ptr<RawMessageSource>> open_image(std::vector<std::byte> image,
                                                     const std::vector<std::string>& topics = {}) {
  auto database = rosbag2::Database::open(std::move(image), "test.db3");
  if (!database) return tl::unexpected(database.error());
  return rosbag2::open_db3(std::move(*database), topics);
}

/// A folder of its own that goes away again.
class BagFolder {
 public:
  BagFolder()
      : path_(fs::path(testing::TempDir()) /
              ("scanfuse rosbag2 #1% " + std::to_string(::getpid()))) {
    fs::remove_all(path_);
    fs::create_directories(path_);
  }
  ~BagFolder() { fs::remove_all(path_); }
  void write(const std::string& name, const std::vector<std::byte>& bytes) const {
    std::ofstream(path_ / name, std::ios::binary)
        .write(reinterpret_cast<const char*>(bytes.data()),
               static_cast<std::streamsize>(bytes.size()));
  }
  [[nodiscard]] const fs::path& path() const { return path_; }

 private:
  fs::path path_;
};

TEST(Rosbag2, MessagesComeInOrderOfTimeWithAndWithoutAnIndex) {
  for (const bool indexed : {false, true}) {
    Db3Builder builder;
    fill_small(builder);
    if (indexed) builder.index_times();
    auto source = open_image(builder.image());
    ASSERT_TRUE(source.has_value()) << source.error().message;
    EXPECT_EQ(
        bag2_lines(**source),
        (std::vector<std::string>{"10:/a:one", "20:/b:" + std::string(700, 'x'), "30:/b:three"}));
    EXPECT_EQ((*source)->info().topics[1].messages, 2);
    EXPECT_EQ((*source)->info().start, time_from_nanos(10));
    EXPECT_TRUE((*source)->diagnostics().empty());
  }
}

TEST(Rosbag2, OnlyTheWantedTopicsCome) {
  Db3Builder builder;
  fill_small(builder);
  auto source = open_image(builder.image(), {"/a"});
  ASSERT_TRUE(source.has_value());
  EXPECT_EQ(bag2_lines(**source), (std::vector<std::string>{"10:/a:one"}));
}

TEST(Rosbag2, DefinitionsAreFoundWhereTheSchemaHasThem) {
  Db3Builder builder;
  fill_small(builder);
  builder.run(
      "CREATE TABLE message_definitions(id INTEGER PRIMARY KEY, topic_type TEXT, encoding "
      "TEXT, encoded_message_definition TEXT)");
  builder.run(
      "INSERT INTO message_definitions VALUES(1,'std_msgs/msg/String','ros2msg','string data')");
  auto source = open_image(builder.image());
  ASSERT_TRUE(source.has_value());
  EXPECT_EQ((*source)->channels()[0].definition, "string data");
}

TEST(Rosbag2, ADatabaseThatIsNoBagIsAnError) {
  Db3Builder builder;
  builder.run("DROP TABLE topics");
  EXPECT_FALSE(open_image(builder.image()).has_value());
  EXPECT_FALSE(open_image(as_bytes("SQLite format 3")).has_value());
  EXPECT_FALSE(open_image({}).has_value());
}

TEST(Rosbag2, AViewInPlaceOfATableIsRefused) {
  Db3Builder builder;
  builder.run("DROP TABLE messages");
  builder.run(
      "CREATE VIEW messages AS WITH RECURSIVE n(i) AS (SELECT 1 UNION ALL SELECT i+1 FROM n) "
      "SELECT i AS rowid, 1 AS topic_id, i AS timestamp, x'00' AS data FROM n");
  EXPECT_FALSE(open_image(builder.image()).has_value());
}

TEST(Rosbag2, AMissingFileIsNotFound) {
  EXPECT_EQ(open_rosbag2("/nonexistent/x.db3").error().code, Error::Code::kNotFound);
}

TEST(Rosbag2, SplitFilesAreReadInOrderOfTheMetadataOrOfTheirNumbers) {
  Db3Builder first, second;
  first.topic(1, "/a", "std_msgs/msg/String");
  first.message(1, 1, as_bytes("one"));
  second.topic(1, "/b", "std_msgs/msg/String");  // the same number for another topic
  second.topic(2, "/a", "std_msgs/msg/String");
  second.message(1, 2, as_bytes("two"));
  second.message(2, 3, as_bytes("three"));
  const BagFolder folder;
  folder.write("bag_9.db3", first.image());
  folder.write("bag_10.db3", second.image());
  const std::vector<std::string> expected{"1:/a:one", "2:/b:two", "3:/a:three"};
  auto source = open_rosbag2(folder.path());
  ASSERT_TRUE(source.has_value()) << source.error().message;
  EXPECT_EQ((*source)->info().topics.size(), 2U);
  EXPECT_EQ(bag2_lines(**source), expected);
  folder.write("metadata.yaml",
               as_bytes("rosbag2_bagfile_information:\n  relative_file_paths:\n    - bag_9.db3\n"
                        "    - \"old_name/bag_10.db3\"\n    - gone.db3\n  message_count: 3\n"));
  source = open_rosbag2(folder.path());
  ASSERT_TRUE(source.has_value());
  EXPECT_EQ(bag2_lines(**source), expected);
  EXPECT_TRUE((*source)->diagnostics().any_damage()) << "a split file is missing";
}

std::vector<std::byte> zstd_packed(const std::vector<std::byte>& bytes) {
  std::vector<std::byte> out(ZSTD_compressBound(bytes.size()));
  out.resize(ZSTD_compress(out.data(), out.size(), bytes.data(), bytes.size(), 1));
  return out;
}

TEST(Rosbag2, CompressionByMessageAndByFileIsUndone) {
  Db3Builder plain, by_message;
  for (auto* builder : {&plain, &by_message}) builder->topic(1, "/a", "std_msgs/msg/String");
  plain.message(1, 5, as_bytes("five"));
  by_message.message(1, 5, zstd_packed(as_bytes("five")));
  const BagFolder folder;
  folder.write("a.db3", by_message.image());
  folder.write("b.db3.zstd", zstd_packed(plain.image()));
  for (const char* name : {"a.db3", "b.db3.zstd"}) {
    auto source = open_rosbag2(folder.path() / name);
    ASSERT_TRUE(source.has_value()) << source.error().message;
    EXPECT_EQ(bag2_lines(**source), (std::vector<std::string>{"5:/a:five"})) << name;
  }
}

TEST(Rosbag2, WrittenScansComeBack) {
  Db3Builder builder;
  const auto message = ros::encode_cdr(ros::planar_scan());
  builder.topic(1, "/scan", message.type);
  builder.message(1, 100, message.bytes);
  builder.message(1, 200, message.bytes);
  builder.message(1, 300, as_bytes("no scan"));
  const auto reader = decode_messages(*open_image(builder.image()));
  for (int frame = 0; frame < 2; ++frame) {
    const auto event = reader->next();
    ASSERT_TRUE(event && *event);
    const auto& scan = std::get<Scan>((*event)->payload);
    EXPECT_EQ(scan.frame, frame);
    EXPECT_EQ(scan.returns.size(), ros::planar_scan().returns.size());
  }
  EXPECT_FALSE(reader->next()->has_value());
  EXPECT_TRUE(reader->diagnostics().any_damage());
  EXPECT_TRUE(reader->info().topics[0].is_scan);
}

TEST(Rosbag2, CutOrFlippedAnywhereItIsSurvived) {
  Db3Builder builder;
  fill_small(builder);
  builder.index_times();
  const auto whole = builder.image();
  for (std::size_t length = 0; length < whole.size(); length += 13) {
    auto source = open_image({whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(length)});
    if (source) (void)bag2_lines(**source);
  }
  for (std::size_t bit = 0; bit < whole.size() * 8; bit += 11) {
    auto damaged = whole;
    damaged[bit / 8] ^= std::byte{1} << bit % 8;
    auto source = open_image(damaged);
    if (!source) continue;
    EXPECT_LE(bag2_lines(**source).size(), 100U);
  }
}

TEST(Rosbag2, RealBagsHoldAsManyMessagesAsTheirMetadataSay) {
  const fs::path root = SCANFUSE_SHARED_DATA "/formats/rosbag2";
  if (!fs::exists(root)) GTEST_SKIP() << "no shared data: skipped";
  int bags = 0;
  for (const auto& entry : fs::recursive_directory_iterator(root)) {
    if (entry.path().filename() != "metadata.yaml") continue;
    const auto files = rosbag2::list_bag_files(entry.path().parent_path());
    if (!files || !files->missing.empty()) continue;
    std::ifstream stream(entry.path());
    const std::string yaml{std::istreambuf_iterator<char>(stream), {}};
    const auto key = yaml.find("  message_count: ");
    auto source = open_rosbag2(entry.path().parent_path());
    ASSERT_TRUE(source.has_value()) << source.error().message;
    const auto lines = bag2_lines(**source);
    std::int64_t listed = 0;
    for (const auto& topic : (*source)->info().topics) listed += topic.messages;
    EXPECT_EQ(listed, static_cast<std::int64_t>(lines.size())) << entry.path();
    EXPECT_EQ(lines.size(), std::stoul(yaml.substr(key + 17))) << entry.path();
    EXPECT_FALSE((*source)->diagnostics().any_damage()) << entry.path();
    ++bags;
  }
  EXPECT_GE(bags, 10);
}

}  // namespace
}  // namespace scanfuse::io
