#include "scanfuse/io/csv/csv_points.hpp"

#include <gmock/gmock.h>
#include <lzma.h>
#include <zlib.h>

#include "io/reading.hpp"
#include "scanfuse/core/random.hpp"
#include "scanfuse/io/csv/points_writer.hpp"
#include "scanfuse/io/text/numbers.hpp"

namespace scanfuse::io {
namespace {

using scanfuse::io_testing::all_finite;
using scanfuse::io_testing::lines_of;
using scanfuse::io_testing::read_out;
using ::testing::HasSubstr;

auto read_points(std::string text, const OpenOptions& options = {}) {
  return read_out(open_csv_points(lines_of(std::move(text)), options));
}

std::string gzipped(const std::string& text) {
  z_stream stream{};
  deflateInit2(&stream, 6, Z_DEFLATED, 15 + 16, 8, Z_DEFAULT_STRATEGY);
  std::string packed(text.size() + 1000, '\0');
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(text.data()));
  stream.avail_in = static_cast<uInt>(text.size());
  stream.next_out = reinterpret_cast<Bytef*>(packed.data());
  stream.avail_out = static_cast<uInt>(packed.size());
  deflate(&stream, Z_FINISH);
  packed.resize(stream.total_out);
  deflateEnd(&stream);
  return packed;
}

std::string xz_packed(const std::string& text) {
  std::string packed(text.size() + 1000, '\0');
  std::size_t size = 0;
  const int outcome = lzma_easy_buffer_encode(
      0, LZMA_CHECK_CRC32, nullptr, reinterpret_cast<const std::uint8_t*>(text.data()), text.size(),
      reinterpret_cast<std::uint8_t*>(packed.data()), &size, packed.size());
  packed.resize(outcome == LZMA_OK ? size : 0);
  return packed;
}

const std::string kTwoFrames =
    "frame,time_s,x_m,y_m,z_m,layer,intensity\n"
    "0,1575811624.359102488,1.5,-2,0.25,1,0.5\n"
    "0,1575811624.359102488,2,3,0,0,0\n"
    "1,1575811624.459102488,4,5,6,2,7\n";

TEST(CsvPoints, RowsOfAFrameMakeOneScanWithExactStamps) {
  const auto out = read_points(kTwoFrames);
  ASSERT_EQ(out.scans.size(), 2u);
  EXPECT_EQ(to_nanos(out.scans[0].stamp), 1575811624359102488);
  EXPECT_EQ(out.scans[0].frame, 0);
  ASSERT_EQ(out.scans[0].returns.size(), 2u);
  EXPECT_EQ(out.scans[0].returns[0].x_m, 1.5f);
  EXPECT_EQ(out.scans[0].returns[0].y_m, -2.0f);
  EXPECT_EQ(out.scans[0].returns[0].z_m, 0.25f);
  EXPECT_EQ(out.scans[0].returns[0].layer, 1);
  EXPECT_EQ(out.scans[0].returns[0].intensity, 0.5f);
  EXPECT_EQ(out.scans[1].returns.size(), 1u);
  EXPECT_TRUE(out.diagnostics.empty());
}

TEST(CsvPoints, ColumnsAreFoundByNameInAnyOrderAndUnknownOnesNoted) {
  const auto out = read_points("y_m,colour,time_s,x_m,frame\n2,red,0.1,1,7\n");
  ASSERT_EQ(out.scans.size(), 1u);
  EXPECT_EQ(out.scans[0].frame, 7);
  EXPECT_EQ(out.scans[0].returns[0].x_m, 1.0f);
  EXPECT_EQ(out.scans[0].returns[0].y_m, 2.0f);
  EXPECT_EQ(out.diagnostics.count("unknown column ignored"), 1);
  EXPECT_FALSE(out.diagnostics.any_damage());
}

TEST(CsvPoints, AMissingColumnIsAnErrorThatNamesIt) {
  const auto out = read_points("frame,x_m,y_m\n0,1,2\n");
  ASSERT_TRUE(out.error);
  EXPECT_THAT(out.error->message, HasSubstr("time_s"));
  const auto both = read_points("frame,x_m,t\n0,1,2\n");
  ASSERT_TRUE(both.error);
  EXPECT_THAT(both.error->message, HasSubstr("y_m"));
  EXPECT_THAT(both.error->message, HasSubstr("time_s"));
}

TEST(CsvPoints, QuotesCarriageReturnsMarksBlankLinesAndCommentsAreNoObstacle) {
  const auto out = read_points(
      "\xef\xbb\xbf# a comment\r\n\r\n\"frame\",time_s,\"x_m\" ,y_m,sensor\r\n"
      "0,0.5,\"1\",2,\"left, \"\"front\"\"\"\r\n\r\n# more\r\n0,0.5, 3 ,4,\"left, \"\"front\"\"\"");
  ASSERT_EQ(out.scans.size(), 1u) << (out.error ? out.error->message : "");
  EXPECT_EQ(out.scans[0].sensor, "left, \"front\"");
  EXPECT_EQ(out.scans[0].returns.size(), 2u);
  EXPECT_TRUE(out.diagnostics.empty());
}

TEST(CsvPoints, BadRowsAreCountedAsDamageWithTheirLine) {
  const auto out = read_points(
      "frame,time_s,x_m,y_m\n0,0,1,2\n0,0,nan,2\n0,0,1,inf\n0,0,one,2\n0,0,1\n0,,1,2\n"
      "0,0,1e300,2\nx,0,1,2\n0,1e99,1,1\n0,0,3,4\n");
  ASSERT_EQ(out.scans.size(), 1u);
  EXPECT_EQ(out.scans[0].returns.size(), 2u);
  EXPECT_EQ(out.diagnostics.count("bad row skipped"), 8);
  EXPECT_TRUE(out.diagnostics.any_damage());
  EXPECT_THAT(out.diagnostics.entries().at("bad row skipped").first, HasSubstr("test.csv:3"));
}

TEST(CsvPoints, AFileWithoutAnyGoodRowIsAnError) {
  for (const char* text : {"", "\n\n# only\n", "frame,time_s,x_m,y_m\n",
                           "frame,time_s,x_m,y_m\n0,0,nan,1\n0,0,1,nan\n"}) {
    EXPECT_TRUE(read_points(text).error) << text;
  }
}

TEST(CsvPoints, SensorsOfOneFrameMakeScansOfTheirOwnInOrderOfTime) {
  const auto out = read_points(
      "frame,time_s,x_m,y_m,sensor\n0,0.02,1,1,right\n0,0.01,2,2,left\n0,0.02,3,3,right\n"
      "1,0.12,1,1,right\n");
  ASSERT_EQ(out.scans.size(), 3u);
  EXPECT_EQ(out.scans[0].sensor, "left");
  EXPECT_EQ(out.scans[1].sensor, "right");
  EXPECT_EQ(out.scans[1].returns.size(), 2u);
}

TEST(CsvPoints, OnlyTheTopicsAskedForAreGiven) {
  OpenOptions options;
  options.topics = {"left"};
  const auto out = read_points(
      "frame,time_s,x_m,y_m,sensor\n0,0,1,1,right\n0,0,2,2,left\n1,1,3,3,right\n", options);
  ASSERT_EQ(out.scans.size(), 1u);
  EXPECT_EQ(out.scans[0].sensor, "left");
}

TEST(CsvPoints, TheScansStampIsTheEarliestOfItsBeams) {
  const auto out = read_points("frame,time_s,x_m,y_m\n0,10.020,1,1\n0,10.010,2,2\n0,10.030,3,3\n");
  ASSERT_EQ(out.scans.size(), 1u);
  EXPECT_EQ(to_nanos(out.scans[0].stamp), 10'010'000'000);
  EXPECT_NEAR(out.scans[0].returns[0].time_offset_s, 0.010, 1e-7);
  EXPECT_NEAR(out.scans[0].returns[1].time_offset_s, 0, 1e-7);
  EXPECT_NEAR(out.scans[0].returns[2].time_offset_s, 0.020, 1e-7);
}

TEST(CsvPoints, ThePapersAxesAreTurnedToForwardAndLeft) {
  OpenOptions options;
  options.paper_axes = true;
  const auto out = read_points("x,y\n3,10\n", options);  // 3 m to the right, 10 m ahead
  ASSERT_EQ(out.scans.size(), 1u);
  EXPECT_EQ(out.scans[0].returns[0].x_m, 10.0f);
  EXPECT_EQ(out.scans[0].returns[0].y_m, -3.0f);
}

TEST(CsvPoints, FramesOutOfOrderAndTimeJumpsAreNoted) {
  const auto out =
      read_points("frame,time_s,x_m,y_m\n0,0,1,1\n2,0.2,1,1\n1,0.1,1,1\n3,0.1,1,1\n4,100,1,1\n");
  EXPECT_EQ(out.scans.size(), 5u);
  EXPECT_EQ(out.diagnostics.count("frame out of order"), 1);
  EXPECT_EQ(out.diagnostics.count("time runs backwards"), 1);
  EXPECT_EQ(out.diagnostics.count("equal stamps"), 1);
  EXPECT_EQ(out.diagnostics.count("time jump of more than 10 s"), 1);
}

TEST(CsvPoints, GzipAndXzAreUnpackedWhileReading) {
  for (const std::string& packed :
       {gzipped(kTwoFrames), xz_packed(kTwoFrames),
        gzipped(kTwoFrames.substr(0, 60)) + gzipped(kTwoFrames.substr(60))}) {
    const auto out = read_points(packed);
    ASSERT_EQ(out.scans.size(), 2u) << (out.error ? out.error->message : "");
    EXPECT_TRUE(out.diagnostics.empty());
  }
}

TEST(CsvPoints, ACutPackedFileGivesWhatIsWholeAndCountsTheDamage) {
  std::string text = "frame,time_s,x_m,y_m\n";
  RandomStream random(5);
  for (int i = 0; i < 50000; ++i) {
    text += fmt::format("{},{},{},{}\n", i / 100, i / 100, random.uniform(), random.uniform());
  }
  for (const std::string& packed : {gzipped(text), xz_packed(text)}) {
    const auto out = read_points(packed.substr(0, packed.size() / 2));
    EXPECT_FALSE(out.error);
    EXPECT_GT(out.scans.size(), 100u);
    EXPECT_EQ(out.diagnostics.count("file breaks off"), 1);
    EXPECT_TRUE(out.diagnostics.any_damage());
  }
}

TEST(CsvPoints, TruncatedAndFlippedFilesGiveAnErrorOrFiniteScans) {
  RandomStream random(11);
  const std::string packed = gzipped(kTwoFrames), strong = xz_packed(kTwoFrames);
  for (const std::string& whole : {kTwoFrames, packed, strong}) {
    for (std::size_t size = 0; size < whole.size(); ++size) {
      EXPECT_TRUE(all_finite(read_points(whole.substr(0, size))));
    }
    for (int round = 0; round < 400; ++round) {
      std::string flipped = whole;
      flipped[random.below(flipped.size())] ^= static_cast<char>(1 << random.below(8));
      EXPECT_TRUE(all_finite(read_points(flipped)));
    }
  }
}

TEST(CsvPoints, WhatIsWrittenReadsBackTheSame) {
  const auto first = read_points(kTwoFrames);
  std::string text = "frame,time_s,x_m,y_m,z_m,layer,intensity,sensor\n";
  for (const Scan& scan : first.scans) text += point_rows(scan);
  const auto second = read_points(text);
  ASSERT_EQ(second.scans.size(), first.scans.size());
  for (std::size_t k = 0; k < first.scans.size(); ++k) {
    EXPECT_EQ(second.scans[k].stamp, first.scans[k].stamp);
    ASSERT_EQ(second.scans[k].returns.size(), first.scans[k].returns.size());
    EXPECT_EQ(second.scans[k].returns[0].x_m, first.scans[k].returns[0].x_m);
    EXPECT_EQ(second.scans[k].returns[0].intensity, first.scans[k].returns[0].intensity);
  }
}

TEST(LineReader, LinesPastAMegabyteArePassedOver) {
  Diagnostics diagnostics;
  auto lines = lines_of("first\n" + std::string(5'000'000, 'x') + "\nlast");
  EXPECT_EQ(lines.next(diagnostics), "first");
  EXPECT_EQ(lines.next(diagnostics), "last");
  EXPECT_EQ(lines.line_number(), 3);
  EXPECT_EQ(lines.next(diagnostics), std::nullopt);
  EXPECT_EQ(diagnostics.count("line too long"), 1);
}

TEST(LineReader, LinesOfAnyLengthComeWhole) {
  std::string text;
  std::vector<std::string> wanted;
  RandomStream random(2);
  for (int i = 0; i < 300; ++i) {
    wanted.emplace_back(random.below(40000), static_cast<char>('a' + random.below(26)));
    text += wanted.back() + (i % 2 == 0 ? "\n" : "\r\n");
  }
  Diagnostics diagnostics;
  auto lines = lines_of(text);
  for (const std::string& line : wanted) ASSERT_EQ(lines.next(diagnostics), line);
  EXPECT_EQ(lines.next(diagnostics), std::nullopt);
}

TEST(Numbers, SecondsAreExactToTheNanosecond) {
  const auto nanos = [](std::string_view text) {
    const auto seconds = parse_seconds(text);
    return seconds ? seconds->count() : INT64_MIN;
  };
  EXPECT_EQ(nanos("1575811624.359102488"), 1575811624359102488);
  EXPECT_EQ(nanos("-0.000000001"), -1);
  EXPECT_EQ(nanos("0.0000000015"), 2);
  EXPECT_EQ(nanos("00012.5"), 12'500'000'000);
  EXPECT_EQ(nanos("1.01893e+09"), 1'018'930'000'000'000'000);
  EXPECT_EQ(nanos("1e-9"), 1);
  EXPECT_EQ(nanos(".5"), 500'000'000);
  EXPECT_EQ(nanos("5."), 5'000'000'000);
  EXPECT_EQ(nanos("+7"), 7'000'000'000);
  for (const char* text :
       {"", ".", "-", "1.2.3", "1e", "1e999", "nan", "inf", "5 s", "9e9", "0x1"}) {
    EXPECT_EQ(nanos(text), INT64_MIN) << text;
  }
  EXPECT_EQ(print_seconds(time_from_nanos(1575811624359102488)), "1575811624.359102488");
  EXPECT_EQ(print_seconds(time_from_nanos(-1)), "-0.000000001");
  RandomStream random(3);
  for (int i = 0; i < 1000; ++i) {
    const auto value = static_cast<std::int64_t>(random.uniform(-4.5e18, 4.5e18));
    EXPECT_EQ(nanos(print_seconds(time_from_nanos(value))), value);
  }
}

TEST(Numbers, OnlyFiniteDecimalsCount) {
  EXPECT_EQ(parse_number(" +1.5 "), 1.5);
  EXPECT_EQ(parse_number("1e-400"), 0.0);
  for (const char* text : {"", "nan", "inf", "-inf", "1e400", "1,5", "0x10", "--1", "+-1", "1 2"}) {
    EXPECT_FALSE(parse_number(text)) << text;
  }
  EXPECT_EQ(parse_whole("12.0"), 12);
  EXPECT_FALSE(parse_whole("12.5"));
  EXPECT_EQ(print_number(0.1), "0.1");
  EXPECT_EQ(print_number(std::nan("")), "");
}

TEST(CsvPoints, TheFourLayerRoadSequenceIsReadWhole) {
  const std::filesystem::path folder = SCANFUSE_SHARED_DATA "/road/kitti_seq0000";
  if (!std::filesystem::exists(folder)) GTEST_SKIP() << "no shared data: skipped";
  const auto out = read_out(open_recording(folder / "scans_4layer.points.csv.xz"));
  ASSERT_EQ(out.scans.size(), 90u);
  std::size_t returns = 0;
  for (const Scan& scan : out.scans) returns += scan.returns.size();
  EXPECT_EQ(returns, 478982u);
  EXPECT_TRUE(out.diagnostics.empty());
  EXPECT_TRUE(all_finite(out));
}

}  // namespace
}  // namespace scanfuse::io
