#include <gmock/gmock.h>

#include <cstring>

#include "io/reading.hpp"
#include "io/temporary_folder.hpp"
#include "scanfuse/core/random.hpp"
#include "scanfuse/io/pcd/lzf.hpp"
#include "scanfuse/io/pcd/read_pcd.hpp"

namespace scanfuse::io {
namespace {

using scanfuse::io_testing::all_finite;
using scanfuse::io_testing::read_out;
using scanfuse::io_testing::TemporaryFolder;
using ::testing::HasSubstr;

std::string pcd_header(int points, const std::string& data) {
  return "# .PCD v0.7 - Point Cloud Data\nVERSION 0.7\nFIELDS x y z intensity ring\n"
         "SIZE 4 4 4 4 2\nTYPE F F F F U\nCOUNT 1 1 1 1 1\nWIDTH " +
         std::to_string(points) + "\nHEIGHT 1\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS " +
         std::to_string(points) + "\nDATA " + data + "\n";
}

template <class T>
void append_raw(std::string& bytes, T value) {
  bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
}

/// LZF of literal runs and of runs of one byte: enough to make test files.
std::string pack_lzf(const std::string& raw) {
  std::string packed;
  for (std::size_t i = 0; i < raw.size();) {
    std::size_t run = 1;
    while (i + run < raw.size() && raw[i + run] == raw[i] && run < 200) ++run;
    packed += '\0';
    packed += raw[i];
    if (run >= 10) {
      packed += static_cast<char>(7 << 5);
      packed += static_cast<char>(run - 1 - 9);
      packed += '\0';
      i += run;
    } else {
      ++i;
    }
  }
  return packed;
}

constexpr int kCloudPoints = 40;

float coordinate(int point, int axis) { return static_cast<float>(point) * 0.5f - axis; }

std::string cloud_in(const std::string& encoding) {
  std::string body = pcd_header(kCloudPoints, encoding);
  std::string rows, columns[5];
  for (int i = 0; i < kCloudPoints; ++i) {
    if (encoding == "ascii") {
      body += fmt::format("{} {} {} {} {}\n", coordinate(i, 0), coordinate(i, 1), coordinate(i, 2),
                          7, i % 4);
    }
    for (int axis = 0; axis < 3; ++axis) {
      append_raw(rows, coordinate(i, axis));
      append_raw(columns[axis], coordinate(i, axis));
    }
    append_raw(rows, 7.0f);
    append_raw(columns[3], 7.0f);
    append_raw(rows, static_cast<std::uint16_t>(i % 4));
    append_raw(columns[4], static_cast<std::uint16_t>(i % 4));
  }
  if (encoding == "binary") body += rows;
  if (encoding == "binary_compressed") {
    std::string all;
    for (const std::string& column : columns) all += column;
    const std::string packed = pack_lzf(all);
    append_raw(body, static_cast<std::uint32_t>(packed.size()));
    append_raw(body, static_cast<std::uint32_t>(all.size()));
    body += packed;
  }
  return body;
}

TEST(Pcd, AllThreeEncodingsGiveTheSamePoints) {
  for (const char* encoding : {"ascii", "binary", "binary_compressed"}) {
    Diagnostics diagnostics;
    const auto scan = read_pcd(cloud_in(encoding), "c.pcd", diagnostics);
    ASSERT_TRUE(scan) << encoding << ": " << scan.error().message;
    EXPECT_TRUE(diagnostics.empty());
    ASSERT_EQ(scan->returns.size(), static_cast<std::size_t>(kCloudPoints));
    for (int i = 0; i < kCloudPoints; ++i) {
      const Return& r = scan->returns[static_cast<std::size_t>(i)];
      EXPECT_EQ(r.x_m, coordinate(i, 0));
      EXPECT_EQ(r.y_m, coordinate(i, 1));
      EXPECT_EQ(r.z_m, coordinate(i, 2));
      EXPECT_EQ(r.intensity, 7);
      EXPECT_EQ(r.layer, i % 4);
    }
  }
}

TEST(Pcd, AnyLayoutOfFieldsIsUnderstood) {
  std::string file =
      "VERSION .7\nFIELDS normal y _ x t\nSIZE 4 8 1 4 4\nTYPE F F U F U\nCOUNT 3 1 4 1 1\n"
      "WIDTH 1\nHEIGHT 1\nPOINTS 1\nDATA binary\n";
  for (int k = 0; k < 3; ++k) append_raw(file, 9.0f);
  append_raw(file, -2.5);
  append_raw(file, std::uint32_t{0});
  append_raw(file, 1.5f);
  append_raw(file, std::uint32_t{20'000'000});
  Diagnostics diagnostics;
  const auto scan = read_pcd(file, "c.pcd", diagnostics);
  ASSERT_TRUE(scan) << scan.error().message;
  EXPECT_EQ(scan->returns[0].x_m, 1.5f);
  EXPECT_EQ(scan->returns[0].y_m, -2.5f);
  EXPECT_NEAR(scan->returns[0].time_offset_s, 0.02, 1e-9);
}

TEST(Pcd, ErrorsNameTheLine) {
  const auto message = [](const std::string& file) {
    Diagnostics diagnostics;
    const auto scan = read_pcd(file, "scan.pcd", diagnostics);
    return scan ? std::string("none") : scan.error().message;
  };
  EXPECT_EQ(message("VERSION 0.7\nFIELDS x y z i\nSIZE 4 4 4\n"),
            "scan.pcd:3: FIELDS names 4 columns, SIZE 3");
  EXPECT_THAT(message("FIELDS x y\nSIZE 4 5\n"), HasSubstr("scan.pcd:2: SIZE '5'"));
  EXPECT_THAT(message("FIELDS x y\nSIZE 4 4\nTYPE F Q\n"), HasSubstr("scan.pcd:3: TYPE 'Q'"));
  EXPECT_THAT(message("FIELDS x y\nSIZE 4 4\nTYPE F F\nPOINTS -1\n"), HasSubstr("scan.pcd:4"));
  EXPECT_THAT(message("FIELDS x y\nSIZE 4 4\nTYPE F F\nPOINTS 1\nDATA zip\n"),
              HasSubstr("scan.pcd:5: DATA 'zip'"));
  EXPECT_THAT(message("FIELDS a b\nSIZE 4 4\nTYPE F F\nPOINTS 1\nDATA ascii\n1 2\n"),
              HasSubstr("no x and y"));
  EXPECT_THAT(message(""), HasSubstr("no DATA line"));
}

TEST(Pcd, PointsThatAreNotFiniteAreNotedAndBadLinesAreDamage) {
  Diagnostics diagnostics;
  const auto scan = read_pcd(
      "FIELDS x y\nSIZE 4 4\nTYPE F F\nPOINTS 5\nDATA ascii\n1 2\nnan nan\n1\nfoo 2\n3 4\n",
      "c.pcd", diagnostics);
  ASSERT_TRUE(scan);
  EXPECT_EQ(scan->returns.size(), 2u);
  EXPECT_EQ(diagnostics.count("points that are not finite dropped"), 1);
  EXPECT_EQ(diagnostics.count("bad row skipped"), 2);
}

TEST(Pcd, AHugeAnnouncedSizeIsNotBelieved) {
  Diagnostics diagnostics;
  std::string file = "FIELDS x y\nSIZE 8 8\nTYPE F F\nPOINTS 199999999\nDATA binary_compressed\n";
  append_raw(file, std::uint32_t{4});
  append_raw(file, std::uint32_t{3199999984u});
  file += "abcd";
  EXPECT_FALSE(read_pcd(file, "c.pcd", diagnostics));
  const auto cut =
      read_pcd("FIELDS x y\nSIZE 8 8\nTYPE F F\nPOINTS 199999999\nDATA binary\n0123456789abcdef",
               "c.pcd", diagnostics);
  EXPECT_EQ(diagnostics.count("cut off points"), 199999998);
}

TEST(Pcd, TruncatedAndFlippedFilesGiveAnErrorOrFinitePoints) {
  RandomStream random(9);
  for (const char* encoding : {"ascii", "binary", "binary_compressed"}) {
    const std::string whole = cloud_in(encoding);
    const auto check = [](const std::string& file) {
      scanfuse::io_testing::ReadOut out;
      auto scan = read_pcd(file, "c.pcd", out.diagnostics);
      if (scan) out.scans.push_back(std::move(*scan));
      EXPECT_TRUE(all_finite(out));
    };
    for (std::size_t size = 0; size < whole.size(); ++size) check(whole.substr(0, size));
    for (int round = 0; round < 1000; ++round) {
      std::string flipped = whole;
      flipped[random.below(flipped.size())] ^= static_cast<char>(1 << random.below(8));
      check(flipped);
    }
  }
}

TEST(Pcd, AFolderIsReadInNaturalOrderWithTimesFromItsNames) {
  const TemporaryFolder folder;
  const auto cloud = cloud_in("ascii");
  for (const char* name : {"scan_10.pcd", "scan_9.pcd", "scan_1.pcd"}) folder.write(name, cloud);
  const auto out = read_out(open_pcd(folder.path(), {}));
  ASSERT_EQ(out.scans.size(), 3u);
  EXPECT_EQ(to_nanos(out.scans[2].stamp), 200'000'000);
  EXPECT_EQ(out.diagnostics.count("no times known: ten scans a second assumed"), 1);

  const TemporaryFolder stamped;
  stamped.write("1317384506402394000.pcd", cloud);
  stamped.write("1317384506302394000.pcd", cloud);
  const auto second = read_out(open_pcd(stamped.path(), {}));
  ASSERT_EQ(second.scans.size(), 2u);
  EXPECT_EQ(to_nanos(second.scans[0].stamp), 1317384506302394000);
  EXPECT_TRUE(second.diagnostics.empty());
}

TEST(Pcd, TimestampsTxtCountsAndABadFileIsPassedOver) {
  const TemporaryFolder folder;
  folder.write("0.pcd", cloud_in("binary"));
  folder.write("1.pcd", "no cloud\n");
  folder.write("2.pcd", cloud_in("binary"));
  folder.write("timestamps.txt", "10.5\n10.6\n2011-09-26 13:02:25.964389445\n");
  const auto out = read_out(open_pcd(folder.path(), {}));
  ASSERT_EQ(out.scans.size(), 2u);
  EXPECT_EQ(to_nanos(out.scans[0].stamp), 10'500'000'000);
  EXPECT_EQ(to_nanos(out.scans[1].stamp), 1317042145964389445);
  EXPECT_EQ(out.diagnostics.count("file skipped"), 1);
  const TemporaryFolder bad;
  bad.write("1.pcd", "no cloud\n");
  EXPECT_TRUE(read_out(open_pcd(bad.path(), {})).error);
}

TEST(Lzf, RunsAndBackReferencesAreUnpacked) {
  const auto unpacked = unpack_lzf(std::string("\x02"
                                               "abc\x80\x02",
                                               6),
                                   9);
  ASSERT_TRUE(unpacked);
  EXPECT_EQ(std::string(unpacked->begin(), unpacked->end()), "abcabcabc");
  EXPECT_FALSE(unpack_lzf(std::string("\x02"
                                      "abc\x80\x09",
                                      6),
                          9))
      << "before the start";
  EXPECT_FALSE(unpack_lzf(std::string("\x02"
                                      "abc",
                                      4),
                          9))
      << "too short";
  EXPECT_FALSE(unpack_lzf(std::string("\x05"
                                      "abc",
                                      4),
                          6))
      << "cut off";
}

}  // namespace
}  // namespace scanfuse::io
