#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>

#include "io/temporary_folder.hpp"
#include "scanfuse/io/mcap/message_source.hpp"
#include "scanfuse/io/mcap/result_messages.hpp"
#include "scanfuse/io/mcap/topic_writer.hpp"
#include "scanfuse/io/ros/decoding_reader.hpp"

// Our files read by Foxglove's packages, and theirs read by us: tests/npm/mcap_roundtrip.mjs.
namespace scanfuse::io {
namespace {

namespace fs = std::filesystem;

const fs::path kNpmFolder = SCANFUSE_SOURCE "/tests/npm";

/// Whether the packages are there; otherwise the tests are skipped.
bool npm_is_installed() { return fs::exists(kNpmFolder / "node_modules/@mcap/core"); }

constexpr const char* kNotInstalled = "no npm packages (npm ci --prefix tests/npm): skipped";

/// What the script prints, as JSON; null when it fails.
nlohmann::json run_npm(const std::string& arguments) {
  const io_testing::TemporaryFolder folder;  // of its own: tests run side by side
  const fs::path output = folder.path() / "output.json";
  const std::string command = "node '" + (kNpmFolder / "mcap_roundtrip.mjs").string() + "' " +
                              arguments + " > '" + output.string() + "'";
  if (std::system(command.c_str()) != 0) return nullptr;
  std::ifstream file(output);
  return nlohmann::json::parse(file, nullptr, false);
}

Scan npm_scan(int i) {
  Scan scan;
  scan.stamp = time_from_nanos(1'000'000'000LL * (1000 + i));
  scan.frame_id = "laser";
  scan.returns = {{1, 2, 0.5f, 40, 0.001f, 3, 2, 1}, {float(i), 0.25f, 0, 10, 0.002f, 9, 0, 0}};
  return scan;
}

void write_for_npm(const fs::path& path, mcap::Compression compression) {
  mcap::WriterOptions options;
  options.compression = compression;
  options.chunk_bytes = 1000;
  auto writer = mcap::TopicWriter::create(path, options);
  ASSERT_TRUE(writer.has_value());
  for (int i = 0; i < 25; ++i) {
    const Scan scan = npm_scan(i);
    TruthFrame truth;
    truth.stamp = scan.stamp;
    truth.frame = i;
    truth.objects.resize(2);
    truth.objects[1].position_m = {0.1 + i, -3};
    ASSERT_TRUE(writer->write_cdr("/scan", scan.stamp, ros::encode_cdr(scan)));
    ASSERT_TRUE(writer->write_json("/scanfuse/truth", "scanfuse.Truth", truth.stamp,
                                   mcap::truth_json(truth)));
  }
  ASSERT_TRUE(writer->finish());
}

TEST(McapNpm, FoxglovesPackagesReadWhatWeWrite) {
  if (!npm_is_installed()) GTEST_SKIP() << kNotInstalled;
  using mcap::Compression;
  const io_testing::TemporaryFolder folder;
  for (const auto compression : {Compression::kNone, Compression::kLz4, Compression::kZstd}) {
    const fs::path path = folder.path() / "ours.mcap";
    write_for_npm(path, compression);
    const auto found = run_npm("read '" + path.string() + "'");
    ASSERT_TRUE(found.is_object());
    EXPECT_EQ(found["messages"], 50);
    EXPECT_EQ(found["streamed"], 50);
    EXPECT_EQ(found["counted"], 50);
    const auto& scan = found["topics"]["/scan"];
    EXPECT_EQ(scan["messages"], 25);
    EXPECT_EQ(scan["first"]["header"]["stamp"]["sec"], 1000);
    EXPECT_EQ(scan["first"]["width"], 2);
    EXPECT_EQ(scan["first"]["fields"][0]["name"], "x");
    const auto& truth = found["topics"]["/scanfuse/truth"];
    EXPECT_EQ(truth["type"], "scanfuse.Truth");
    EXPECT_EQ(truth["first"]["objects"][1]["x_m"], 0.1);
  }
}

TEST(McapNpm, WeReadWhatFoxglovesPackagesWrite) {
  if (!npm_is_installed()) GTEST_SKIP() << kNotInstalled;
  const io_testing::TemporaryFolder folder;
  for (const std::string compression : {"none", "zstd"}) {
    const fs::path path = folder.path() / (compression + ".mcap");
    (void)run_npm("write '" + path.string() + "' " + compression);
    auto source = open_mcap(path);
    ASSERT_TRUE(source.has_value()) << source.error().message;
    EXPECT_EQ((*source)->info().compression, compression);
    auto reader = decode_messages(std::move(*source));
    for (int i = 0; i < 25; ++i) {
      const auto event = reader->next();
      ASSERT_TRUE(event && *event);
      const auto& scan = std::get<Scan>((*event)->payload);
      EXPECT_EQ(scan.stamp, time_from_nanos(1'000'000'000LL * (1000 + i) + 500));
      EXPECT_EQ(scan.frame_id, "laser");
      ASSERT_EQ(scan.returns.size(), 3u);  // infinity and NaN are no returns
      EXPECT_FLOAT_EQ(scan.returns[0].squared_range(), float((1 + i) * (1 + i)));
    }
    EXPECT_FALSE(reader->next()->has_value());
    EXPECT_TRUE(reader->diagnostics().empty());
  }
}

}  // namespace
}  // namespace scanfuse::io
