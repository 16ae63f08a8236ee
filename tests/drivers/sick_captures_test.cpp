#include <gmock/gmock.h>

#include <cmath>
#include <cstring>
#include <map>

#include "drivers/captures.hpp"
#include "scanfuse/drivers/sick/lmd_driver.hpp"
#include "scanfuse/drivers/sick/scansegment_driver.hpp"

// Telegrams of real devices, where the folder of recordings has them.
namespace scanfuse::drivers::sick {
namespace {

using drivers_testing::bytes_of_hex;
using drivers_testing::read_tcp_capture;
using drivers_testing::read_udp_capture;
using drivers_testing::shared_sensors;

struct Decoded {
  std::vector<Scan> scans;
  Diagnostics diagnostics;
};

Decoded decode(std::unique_ptr<Driver> driver,
               const std::vector<drivers_testing::Captured>& packets) {
  Output out;
  for (const auto& [time, bytes] : packets) driver->take(bytes, time, out);
  driver->finish(out);
  return {std::move(out.scans), driver->diagnostics()};
}

std::vector<LmdScan> telegrams_of(const std::vector<drivers_testing::Captured>& packets) {
  std::vector<LmdScan> telegrams;
  StreamCutter cutter;
  Diagnostics diagnostics;
  for (const auto& packet : packets) {
    cutter.feed(
        packet.bytes, &cut_cola,
        [&](ByteView bytes) {
          const auto telegram = open_cola(bytes);
          if (!is_lmd_scan(telegram.content)) return;
          auto scan = parse_lmd_scan(telegram);
          ASSERT_TRUE(scan) << scan.error().message;
          telegrams.push_back(std::move(*scan));
        },
        diagnostics);
  }
  EXPECT_EQ(diagnostics.count(StreamCutter::kGarbage), 0);
  return telegrams;
}

struct Capture {
  const char* file;
  int scans;
  int layers;
  int beams;
  double first_deg;
  double rate_hz;
};

std::ostream& operator<<(std::ostream& out, const Capture& capture) { return out << capture.file; }

class SickCaptures : public ::testing::TestWithParam<Capture> {};

// Every telegram is understood, none is lost, beams lie where the data sheet has them, stamps keep
// the device's pace.
TEST_P(SickCaptures, AreDecodedWithoutLoss) {
  const Capture& capture = GetParam();
  const auto file = shared_sensors() / "sick" / capture.file;
  if (!std::filesystem::exists(file)) GTEST_SKIP() << "no shared data: skipped";
  const auto [scans, diagnostics] = decode(make_lmd_driver({"sick", ""}), read_tcp_capture(file));
  EXPECT_EQ(static_cast<int>(scans.size()), capture.scans);
  EXPECT_FALSE(diagnostics.any_damage());
  EXPECT_EQ(diagnostics.count(StreamCutter::kGarbage), 0);
  for (const Scan& scan : scans) {
    ASSERT_TRUE(scan.beams);
    EXPECT_EQ(scan.beams->columns, capture.beams);
    EXPECT_NEAR(scan.beams->first_azimuth_rad, capture.first_deg * M_PI / 180, 1e-4);
    EXPECT_GT(scan.returns.size(), 20U);
    for (const Return& r : scan.returns) {
      ASSERT_LT(std::hypot(r.x_m, r.y_m, r.z_m), 265.0F);
      ASSERT_LT(r.layer, capture.layers);
    }
  }
  const double took_s = to_seconds(scans.back().stamp - scans.front().stamp);
  EXPECT_NEAR(static_cast<double>(scans.size() - 1) / took_s, capture.rate_hz,
              0.03 * capture.rate_hz);
}

INSTANTIATE_TEST_SUITE_P(
    Sick, SickCaptures,
    ::testing::Values(Capture{"20210302_lms111.pcapng.json.gz", 175, 1, 541, -135, 50},
                      Capture{"20210301_lms511.pcapng.json.gz", 136, 1, 1141, -95, 25},
                      Capture{"20210113_tim871s_elephant.pcapng.json.gz", 150, 1, 811, -135, 15},
                      Capture{"20210125-tim781s-scandata.pcapng.json.gz", 140, 1, 811, -135, 15},
                      Capture{"sopas_et_field_test_1_2_both_010.pcapng.json.gz", 139, 1, 811, -135,
                              15},
                      Capture{"20210722_143600_ros2_mrs1104_sick_scan_xd.pcapng.json.gz", 24, 4,
                              1101, -137.5, 12.5}));

// What the maker's own driver says of these telegrams: every range of every beam, exactly.
TEST(SickMrs1000, EqualsTheMakersDriverInEveryBeam) {
  const auto folder = shared_sensors() / "sick";
  const auto file = folder / "mrs1xxx_test01_tcp_data.json.gz";
  if (!std::filesystem::exists(file)) GTEST_SKIP() << "no shared data: skipped";
  const auto telegrams = telegrams_of(read_tcp_capture(file));
  const auto reference = drivers_testing::read_json(folder / "mrs1xxx_test01_ref_messages.json.gz");
  int compared = 0, equal = 0;
  for (const auto& message : reference["RefLaserscanMsg"]["/scan"]) {
    const auto raw = bytes_of_hex(message["ranges"].get<std::string>());
    std::vector<float> ranges(raw.size() / sizeof(float));
    std::memcpy(ranges.data(), raw.data(), raw.size());
    if (std::ranges::all_of(ranges, [](float r) { return r == 0; })) continue;
    ++compared;
    const auto frame = message["frame_id"].get<std::string>();  // "cloud_NEG_500_DIST2"
    const int sign = frame.substr(6, 3) == "NEG" ? -1 : 1;
    const int layer = sign * std::atoi(frame.substr(10, 3).c_str());
    const std::string channel = frame.substr(14, 5);
    int matches = 0;
    for (const LmdScan& telegram : telegrams) {
      const LmdChannel* distances = telegram.find(channel);
      if (telegram.layer_angle != layer || distances == nullptr) continue;
      ASSERT_EQ(distances->values.size(), ranges.size());
      ASSERT_EQ(ranges.size(), 1101U);
      bool same = true;
      for (std::size_t i = 0; i < ranges.size(); ++i) {
        same = same && std::abs(distances->value(i) * 1e-3 - ranges[i]) < 1e-4;
      }
      matches += same ? 1 : 0;
    }
    equal += matches == 1 ? 1 : 0;
  }
  EXPECT_EQ(compared, 24);
  EXPECT_EQ(equal, 24);
}

// The layer that the maker's cloud shows at +5 degrees is the highest here too.
TEST(SickMrs1000, HasItsLayersFromLowToHigh) {
  const auto file = shared_sensors() / "sick" / "mrs1xxx_test01_tcp_data.json.gz";
  if (!std::filesystem::exists(file)) GTEST_SKIP() << "no shared data: skipped";
  const auto [scans, diagnostics] = decode(make_lmd_driver({"sick", ""}), read_tcp_capture(file));
  ASSERT_GT(scans.size(), 5U);
  const Scan& scan = scans[3];
  EXPECT_EQ(scan.beams->layers, 4);
  for (const Return& r : scan.returns) {
    const double elevation_deg = std::atan2(r.z_m, std::hypot(r.x_m, r.y_m)) * 180 / M_PI;
    EXPECT_NEAR(elevation_deg, -2.5 + 2.5 * r.layer, 1e-3);
  }
}

struct SegmentCapture {
  const char* file;
  int layers;
  int beams;
  double rate_hz;
};

class ScanSegmentCaptures : public ::testing::TestWithParam<SegmentCapture> {};

TEST_P(ScanSegmentCaptures, AreDecodedWithoutLoss) {
  const SegmentCapture& capture = GetParam();
  const auto file = shared_sensors() / "sick" / capture.file;
  if (!std::filesystem::exists(file)) GTEST_SKIP() << "no shared data: skipped";
  const auto packets = read_udp_capture(file);
  const auto [scans, diagnostics] = decode(make_scansegment_driver({"multiscan", ""}), packets);
  EXPECT_FALSE(diagnostics.any_damage());
  EXPECT_EQ(diagnostics.count(StreamCutter::kGarbage), 0);
  EXPECT_EQ(diagnostics.count("segments missing"), 0);
  ASSERT_GT(scans.size(), 4U);
  for (std::size_t i = 2; i + 1 < scans.size(); ++i) {
    std::map<int, int> returns;
    for (const Return& r : scans[i].returns) ++returns[r.layer];
    EXPECT_EQ(static_cast<int>(returns.size()), capture.layers);
    for (const auto& [layer, count] : returns) EXPECT_GT(count, capture.beams / 4);
    const double turn_s = to_seconds(scans[i].stamp - scans[i - 1].stamp);
    EXPECT_NEAR(turn_s, 1 / capture.rate_hz, 0.1 / capture.rate_hz) << i;
  }
}

INSTANTIATE_TEST_SUITE_P(
    Sick, ScanSegmentCaptures,
    ::testing::Values(SegmentCapture{"multiscan_compact_test01_udp_scandata.json.gz", 16, 360, 20},
                      SegmentCapture{"picoscan_compact_test01_udp_scandata.json.gz", 1, 1200, 40}));

Bytes content_of(const std::filesystem::path& path) {
  auto source = io::open_bytes(path);
  if (!source) return {};
  const auto text = io::read_start(**source, 1 << 20);
  const auto bytes = view_of(*text);
  return {bytes.begin(), bytes.end()};
}

// The two samples of the maker hold the same scans in both formats; what they are is in its README.
TEST(ScanSegmentSamples, SayWhatTheMakerWroteDown) {
  const auto folder = shared_sensors() / "scansegment" / "tests" / "sample_files";
  if (!std::filesystem::exists(folder)) GTEST_SKIP() << "no shared data: skipped";
  const auto compact = parse_segment(content_of(folder / "sample.compact"));
  const auto packed = parse_msgpack_segment(content_of(folder / "sample.msgpack"));
  ASSERT_TRUE(compact) << compact.error().message;
  ASSERT_TRUE(packed) << packed.error().message;
  for (const auto* segment : {&*compact, &*packed}) {
    EXPECT_EQ(segment->number, 666U);
    EXPECT_EQ(segment->frame, 999U);
    EXPECT_EQ(segment->telegram, 333U);
    EXPECT_EQ(segment->transmit_us, 444U);
    EXPECT_EQ(segment->sender, 555U);
    ASSERT_EQ(segment->lines.size(), 2U);
    for (const auto& line : segment->lines) {
      ASSERT_EQ(line.beams.size(), 10U);
      for (const auto& beam : line.beams) ASSERT_EQ(beam.ranges_m.size(), 2U);
    }
    EXPECT_EQ(segment->lines[0].beams[3].strengths[1], 21036);
    EXPECT_EQ(segment->lines[1].beams[3].strengths[0], 44432);
    EXPECT_NEAR(segment->lines[1].beams[9].azimuth_rad, 99 * M_PI / 180, 2e-4);
  }
  EXPECT_NEAR(packed->lines[0].beams[0].ranges_m[0], 0.123456, 1e-6);
  EXPECT_NEAR(packed->lines[1].beams[0].ranges_m[0], 0.456123, 1e-6);
  EXPECT_NEAR(compact->lines[0].beams[0].ranges_m[0], 0.123, 1e-6);
}

TEST(ScanSegmentSamples, AgreeInBothFormats) {
  const auto folder = shared_sensors() / "scansegment" / "tests" / "sample_files";
  if (!std::filesystem::exists(folder)) GTEST_SKIP() << "no shared data: skipped";
  const auto compact = parse_segment(content_of(folder / "sample_30deg.compact"));
  const auto packed = parse_msgpack_segment(content_of(folder / "sample_30deg.msgpack"));
  ASSERT_TRUE(compact) << compact.error().message;
  ASSERT_TRUE(packed) << packed.error().message;
  ASSERT_EQ(compact->lines.size(), 16U);
  ASSERT_EQ(packed->lines.size(), 16U);
  for (std::size_t l = 0; l < 16; ++l) {
    ASSERT_EQ(packed->lines[l].beams.size(), 30U);
    for (std::size_t b = 0; b < 30; ++b) {
      const auto &a = compact->lines[l].beams[b], &c = packed->lines[l].beams[b];
      EXPECT_NEAR(a.azimuth_rad, c.azimuth_rad, 3e-4);
      EXPECT_EQ(a.properties & 1, 1);
      EXPECT_EQ(c.properties & 1, 1);
      for (std::size_t e = 0; e < 3; ++e) {
        EXPECT_NEAR(a.ranges_m[e], c.ranges_m[e], 1e-3);
        EXPECT_EQ(a.strengths[e], c.strengths[e]);
      }
    }
  }
}

}  // namespace
}  // namespace scanfuse::drivers::sick
