#include <gmock/gmock.h>

#include <cmath>
#include <limits>

#include "scanfuse/core/random.hpp"
#include "scanfuse/drivers/hokuyo/scip.hpp"
#include "scanfuse/drivers/ibeo/lux.hpp"
#include "scanfuse/drivers/ouster/ouster.hpp"
#include "scanfuse/drivers/rplidar/rplidar.hpp"
#include "scanfuse/drivers/sick/lmd_driver.hpp"
#include "scanfuse/drivers/sick/scansegment.hpp"
#include "scanfuse/drivers/velodyne/vlp16.hpp"

// Telegrams field by field: what is written is what is read, and worked examples of the makers.
namespace scanfuse::drivers {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

Bytes bytes(std::string_view text) {
  const ByteView view = view_of(text);
  return {view.begin(), view.end()};
}

sick::LmdScan lmd_scan(std::uint64_t seed) {
  RandomStream random(seed);
  sick::LmdScan scan;
  scan.serial = 20'260'117;
  scan.status = 0x0002;
  scan.telegram_counter = 65535;
  scan.scan_counter = 7;
  scan.start_us = 0xFFFFFF00;
  scan.transmit_us = 0x00000200;
  scan.layer_angle = -250;
  scan.scan_frequency = 5000;
  scan.sample_frequency = 36;
  scan.encoders = {{123'456, 7}};
  for (const char* content : {"DIST1", "RSSI1"}) {
    sick::LmdChannel channel;
    channel.content = content;
    channel.scale = 0.1F;
    channel.offset = -3;
    channel.first_angle = -450'000;
    channel.step = 5000;
    for (int i = 0; i < 541; ++i) {
      channel.values.push_back(static_cast<std::uint16_t>(random.below(65536)));
    }
    scan.channels16.push_back(channel);
    for (auto& value : channel.values) value &= 0xFF;
    scan.channels8.push_back(std::move(channel));
  }
  scan.position = std::array<float, 6>{1, -2, 3.5F, 0, -0.25F, 6};
  scan.rotation_type = 3;
  scan.name = "left door";
  scan.comment = "with a space";
  scan.time = sick::LmdTime{2026, 2, 28, 23, 59, 58, 999'999};
  return scan;
}

void expect_equal(const sick::LmdScan& a, const sick::LmdScan& b) {
  EXPECT_EQ(a.serial, b.serial);
  EXPECT_EQ(a.status, b.status);
  EXPECT_EQ(a.telegram_counter, b.telegram_counter);
  EXPECT_EQ(a.start_us, b.start_us);
  EXPECT_EQ(a.transmit_us, b.transmit_us);
  EXPECT_EQ(a.layer_angle, b.layer_angle);
  EXPECT_EQ(a.scan_frequency, b.scan_frequency);
  EXPECT_EQ(a.encoders, b.encoders);
  EXPECT_EQ(a.position, b.position);
  EXPECT_EQ(a.name, b.name);
  EXPECT_EQ(a.comment, b.comment);
  ASSERT_TRUE(b.time);
  EXPECT_EQ(a.time->year, b.time->year);
  EXPECT_EQ(a.time->microsecond, b.time->microsecond);
  for (const auto member : {&sick::LmdScan::channels16, &sick::LmdScan::channels8}) {
    ASSERT_EQ((a.*member).size(), (b.*member).size());
    for (std::size_t i = 0; i < (a.*member).size(); ++i) {
      const auto &x = (a.*member)[i], &y = (b.*member)[i];
      EXPECT_EQ(x.content, y.content);
      EXPECT_EQ(x.scale, y.scale);
      EXPECT_EQ(x.offset, y.offset);
      EXPECT_EQ(x.first_angle, y.first_angle);
      EXPECT_EQ(x.step, y.step);
      EXPECT_EQ(x.values, y.values);
    }
  }
}

TEST(Cola, SaysAScanInBothDialects) {
  for (const auto dialect : {sick::Cola::kA, sick::Cola::kB}) {
    const auto said = lmd_scan(3);
    const Bytes telegram = sick::encode_lmd_scan(said, dialect);
    const Cut cut = sick::cut_cola(telegram);
    ASSERT_EQ(cut.telegram, telegram.size());
    const auto opened = sick::open_cola(telegram);
    EXPECT_EQ(opened.dialect, dialect);
    ASSERT_TRUE(sick::is_lmd_scan(opened.content));
    const auto heard = sick::parse_lmd_scan(opened);
    ASSERT_TRUE(heard) << heard.error().message;
    expect_equal(said, *heard);
  }
}

// The maker's examples of a request for scans.
TEST(Cola, AsksAsInTheMakersExamples) {
  EXPECT_EQ(sick::scan_request(sick::Cola::kA, true), bytes("\x02sEN LMDscandata 1\x03"));
  EXPECT_EQ(
      sick::scan_request(sick::Cola::kB, true),
      bytes(std::string_view("\x02\x02\x02\x02\x00\x00\x00\x11sEN LMDscandata \x01\x33", 26)));
}

TEST(Cola, DriverUnderstandsDialectATooAndAsksInIt) {
  const auto driver = sick::make_lmd_driver({"sick", ""});
  EXPECT_EQ(sick::open_cola(driver->hello()).dialect, sick::Cola::kB);
  driver->lost();
  EXPECT_EQ(sick::open_cola(driver->hello()).dialect, sick::Cola::kA);
  Output out;
  for (int i = 0; i < 3; ++i) {
    driver->take(sick::encode_lmd_scan(lmd_scan(4), sick::Cola::kA), Time{}, out);
  }
  EXPECT_GE(out.scans.size(), 2U);
  driver->lost();
  EXPECT_EQ(sick::open_cola(driver->hello()).dialect, sick::Cola::kA);
}

TEST(Cola, DecimalNumbersWithSignsAreRead) {
  // As the devices write them for some fields: +500 for 1F4h, -1 for FFFFh.
  const Bytes telegram = sick::encode_lmd_scan(lmd_scan(5), sick::Cola::kA);
  std::string text(text_of(telegram));
  const auto at = text.find(" FF06 ");  // the layer angle: -250
  ASSERT_NE(at, text.npos);
  text.replace(at, 6, " -250 ");
  const auto heard = sick::parse_lmd_scan(sick::open_cola(view_of(text)));
  ASSERT_TRUE(heard) << heard.error().message;
  EXPECT_EQ(heard->layer_angle, -250);
}

TEST(Cola, RefusesATelegramCutInTheMiddleOfItsRanges) {
  const Bytes whole = sick::encode_lmd_scan(lmd_scan(6), sick::Cola::kB);
  const auto opened = sick::open_cola(whole);
  const auto heard = sick::parse_lmd_scan({sick::Cola::kB, opened.content.first(400)});
  ASSERT_FALSE(heard);
  EXPECT_THAT(heard.error().message, HasSubstr("byte 400"));
}

TEST(ScanSegment, SaysASegmentInBothFormats) {
  RandomStream random(8);
  sick::Segment said;
  said.telegram = 12;
  said.transmit_us = 1'700'000'000'000'123;
  said.frame = 99;
  said.number = 4;
  said.sender = 77;
  for (int l = 0; l < 5; ++l) {
    sick::SegmentLine line;
    line.start_us = 1'700'000'000'000'000 + static_cast<std::uint64_t>(l);
    line.stop_us = line.start_us + 4000;
    line.elevation_rad = 0.1F * static_cast<float>(l - 2);
    for (int b = 0; b < (l < 3 ? 30 : 240); ++b) {
      sick::SegmentBeam beam;
      beam.azimuth_rad = -1 + 0.01F * static_cast<float>(b);
      beam.properties = static_cast<std::uint8_t>(b % 2);
      for (int e = 0; e < 3; ++e) {
        beam.ranges_m.push_back(static_cast<float>(random.below(60'000)) * 1e-3F);
        beam.strengths.push_back(static_cast<std::uint16_t>(random.below(65536)));
      }
      line.beams.push_back(std::move(beam));
    }
    said.lines.push_back(std::move(line));
  }
  for (const Bytes& telegram : {sick::encode_compact(said), sick::encode_msgpack(said)}) {
    EXPECT_EQ(sick::cut_scansegment(telegram).telegram, telegram.size());
    const auto heard = sick::parse_segment(telegram);
    ASSERT_TRUE(heard) << heard.error().message;
    EXPECT_EQ(heard->telegram, 12U);
    EXPECT_EQ(heard->transmit_us, said.transmit_us);
    EXPECT_EQ(heard->frame, 99U);
    EXPECT_EQ(heard->number, 4U);
    ASSERT_EQ(heard->lines.size(), 5U);
    for (std::size_t l = 0; l < 5; ++l) {
      EXPECT_EQ(heard->lines[l].start_us, said.lines[l].start_us);
      EXPECT_EQ(heard->lines[l].elevation_rad, said.lines[l].elevation_rad);
      ASSERT_EQ(heard->lines[l].beams.size(), said.lines[l].beams.size());
      for (std::size_t b = 0; b < said.lines[l].beams.size(); ++b) {
        const auto &x = said.lines[l].beams[b], &y = heard->lines[l].beams[b];
        EXPECT_NEAR(x.azimuth_rad, y.azimuth_rad, 1.01e-4);
        EXPECT_EQ(x.strengths, y.strengths);
        EXPECT_EQ(x.properties, y.properties);
        for (std::size_t e = 0; e < 3; ++e) EXPECT_NEAR(x.ranges_m[e], y.ranges_m[e], 1e-5);
      }
    }
  }
}

// The examples of [Scip2008, section 6] and of its PP command.
TEST(Scip, EncodesAsInTheMakersExamples) {
  EXPECT_EQ(hokuyo::encode_characters(1234, 2), "CB");
  EXPECT_EQ(hokuyo::encode_characters(5432, 3), "1Dh");
  EXPECT_EQ(hokuyo::encode_characters(16'000'000, 4), "m2@0");
  EXPECT_EQ(hokuyo::decode_characters("1Dh"), 5432U);
  EXPECT_EQ(hokuyo::decode_characters("1 h"), std::nullopt);
  EXPECT_EQ(hokuyo::checksum("00"), 'P');
  EXPECT_EQ(hokuyo::checksum("99"), 'b');
  EXPECT_EQ(hokuyo::checksum("SCAN:600"), 'e');
  const auto answer =
      hokuyo::parse_answer(bytes("PP\n00P\nAMIN:44;7\nAMAX:725;o\nAFRT:384;6\nSCAN:600;e\n\n"));
  ASSERT_TRUE(answer) << answer.error().message;
  const auto parameters = hokuyo::parse_parameters(*answer);
  EXPECT_EQ(parameters.first_step, 44);
  EXPECT_EQ(parameters.last_step, 725);
  EXPECT_EQ(parameters.front_step, 384);
  EXPECT_EQ(parameters.turns_per_minute, 600);
}

TEST(Scip, SaysAScan) {
  RandomStream random(9);
  for (const char* command : {"MD0000108001000", "ME0000108001000", "MD0010043003000"}) {
    hokuyo::ScipScan said;
    said.has_strengths = command[1] == 'E';
    said.first_step = std::atoi(std::string(command + 2, 4).c_str());
    said.last_step = std::atoi(std::string(command + 6, 4).c_str());
    said.cluster = std::atoi(std::string(command + 10, 2).c_str());
    said.time_ms = 0xABCDEF;
    for (int i = said.first_step; i <= said.last_step; i += said.cluster) {
      said.ranges_mm.push_back(static_cast<std::uint32_t>(random.below(1 << 18)));
      if (said.has_strengths) said.strengths.push_back(static_cast<std::uint32_t>(i));
    }
    const Bytes telegram = hokuyo::encode_answer(hokuyo::answer_of(said, command));
    EXPECT_EQ(hokuyo::cut_scip(telegram).telegram, telegram.size());
    const auto answer = hokuyo::parse_answer(telegram);
    ASSERT_TRUE(answer) << answer.error().message;
    ASSERT_TRUE(hokuyo::is_scan(*answer));
    const auto heard = hokuyo::parse_scan(*answer);
    ASSERT_TRUE(heard) << heard.error().message;
    EXPECT_EQ(heard->ranges_mm, said.ranges_mm);
    EXPECT_EQ(heard->strengths, said.strengths);
    EXPECT_EQ(heard->time_ms, said.time_ms);
    // Any digit that changes is noticed.
    Bytes damaged = telegram;
    damaged[telegram.size() / 2] ^= std::byte{1};
    EXPECT_FALSE(hokuyo::parse_answer(damaged));
  }
}

TEST(Scip, TurnsToRangesOnlyWhereThereAreNoStrengths) {
  const auto driver = hokuyo::make_scip_driver({"hokuyo", ""});
  Output out;
  driver->take(hokuyo::encode_answer(hokuyo::answer_of(hokuyo::ScipParameters{})), Time{}, out);
  EXPECT_THAT(std::string(text_of(out.reply)), HasSubstr("ME0000108001000\n"));
  out.reply.clear();
  driver->take(hokuyo::encode_answer({"ME0000108001000", "0E", {}}), Time{}, out);
  EXPECT_THAT(std::string(text_of(out.reply)), HasSubstr("MD0000108001000\n"));
}

TEST(Rplidar, AnnouncesAsTheMakerDoes) {
  EXPECT_EQ(rplidar::descriptor(rplidar::Mode::kStandard),
            bytes(std::string_view("\xA5\x5A\x05\x00\x00\x40\x81", 7)));
  EXPECT_EQ(rplidar::descriptor(rplidar::Mode::kExpress),
            bytes(std::string_view("\xA5\x5A\x54\x00\x00\x40\x82", 7)));
}

TEST(Rplidar, SaysNodesAndCapsules) {
  RandomStream random(10);
  for (int i = 0; i < 1000; ++i) {
    rplidar::Node node{random.chance(0.5), static_cast<std::uint8_t>(random.below(64)),
                       static_cast<std::uint16_t>(random.below(360 * 64)),
                       static_cast<std::uint16_t>(random.below(65536))};
    const auto heard = rplidar::parse_node(rplidar::encode_node(node));
    ASSERT_TRUE(heard);
    EXPECT_EQ(heard->starts_turn, node.starts_turn);
    EXPECT_EQ(heard->quality, node.quality);
    EXPECT_EQ(heard->angle_q6, node.angle_q6);
    EXPECT_EQ(heard->range_q2, node.range_q2);
  }
  rplidar::Capsule capsule;
  capsule.restarted = true;
  capsule.start_q6 = 22'000;
  for (std::size_t k = 0; k < 32; ++k) {
    capsule.ranges_mm[k] = static_cast<std::uint16_t>(random.below(16384));
    capsule.corrections_q3[k] = static_cast<std::int8_t>(random.below(64)) - 32;
  }
  Bytes telegram = rplidar::encode_capsule(capsule);
  ASSERT_EQ(telegram.size(), rplidar::kCapsuleBytes);
  const auto heard = rplidar::parse_capsule(telegram);
  ASSERT_TRUE(heard) << heard.error().message;
  EXPECT_EQ(heard->ranges_mm, capsule.ranges_mm);
  EXPECT_EQ(heard->corrections_q3, capsule.corrections_q3);
  EXPECT_EQ(heard->start_q6, capsule.start_q6);
  EXPECT_TRUE(heard->restarted);
  telegram[40] ^= std::byte{4};
  EXPECT_FALSE(rplidar::parse_capsule(telegram));
}

TEST(Lux, SaysAScan) {
  ibeo::LuxScan said;
  said.number = 65535;
  said.start_ntp = 0xE5000000'80000000;
  said.end_ntp = 0xE5000000'90000000;
  said.start_angle = 1600;
  said.end_angle = -1920;
  said.x_cm = -12;
  said.flags = 3;
  for (int i = 0; i < 500; ++i) {
    said.points.push_back({static_cast<std::uint8_t>(i % 4), static_cast<std::uint8_t>(i % 3), 0,
                           static_cast<std::int16_t>(1600 - 7 * i),
                           static_cast<std::uint16_t>(100 + i), 44});
  }
  const Bytes message = ibeo::encode_lux_scan(said, 0xE5000000'A0000000);
  EXPECT_EQ(ibeo::cut_lux(message).telegram, message.size());
  EXPECT_EQ(message[0], std::byte{0xAF});
  const auto head = ibeo::parse_lux_head(message);
  EXPECT_EQ(head.type, 0x2202);
  EXPECT_EQ(head.ntp, 0xE5000000'A0000000);
  const auto heard = ibeo::parse_lux_scan(ByteView(message).subspan(ibeo::kLuxHeadBytes));
  ASSERT_TRUE(heard) << heard.error().message;
  EXPECT_EQ(heard->number, said.number);
  EXPECT_EQ(heard->end_ntp, said.end_ntp);
  EXPECT_EQ(heard->end_angle, said.end_angle);
  EXPECT_EQ(heard->x_cm, -12);
  ASSERT_EQ(heard->points.size(), said.points.size());
  EXPECT_EQ(heard->points[499].angle, said.points[499].angle);
  EXPECT_EQ(heard->points[499].layer, said.points[499].layer);
  EXPECT_EQ(heard->points[499].echo, said.points[499].echo);
  EXPECT_FALSE(ibeo::parse_lux_scan(ByteView(message).subspan(24, 300)));
}

TEST(Vlp16, HasItsLayersAndSaysDualReturns) {
  std::vector<int> layers;
  for (int channel = 0; channel < 4; ++channel) layers.push_back(velodyne::layer_of(channel));
  EXPECT_THAT(layers, ElementsAre(0, 8, 1, 9));
  velodyne::Vlp16Packet packet;
  packet.mode = velodyne::ReturnMode::kDual;
  for (std::size_t block = 0; block < 12; ++block) {
    packet.blocks[block].azimuth = static_cast<std::uint16_t>(40 * (block / 2));
    packet.blocks[block].echoes[0] = {static_cast<std::uint16_t>(1000 + 500 * (block % 2)), 9};
    packet.blocks[block].echoes[1] = {2000, 8};
  }
  const auto parsed = velodyne::parse_vlp16(velodyne::encode_vlp16(packet));
  ASSERT_TRUE(parsed) << parsed.error().message;
  const auto driver = velodyne::make_vlp16_driver({"vlp16", ""});
  Output out;
  driver->take(velodyne::encode_vlp16(packet), time_from_nanos(1'700'000'000'000'000'000), out);
  driver->finish(out);
  ASSERT_EQ(out.scans.size(), 1U);
  // Six firings: two echoes of channel 0, and what is said twice of channel 1 only once.
  EXPECT_EQ(out.scans[0].returns.size(), 18U);
}

// A point on the lidar's axis of encoder 0 lies behind the sensor, where the connector is.
TEST(Ouster, PlacesPointsAsItsManualDoes) {
  auto beams = ouster::simulated_beams();
  beams.origin_mm = 15.8;
  beams.sensor_from_lidar[11] = 36.2;
  const auto read = ouster::parse_beams(ouster::metadata_of(beams));
  ASSERT_TRUE(read) << read.error().message;
  EXPECT_EQ(read->altitudes_deg, beams.altitudes_deg);
  EXPECT_EQ(read->columns_per_turn, 1024);
  std::vector<ouster::OusterColumn> columns(ouster::kColumnsPerPacket);
  for (std::size_t i = 0; i < columns.size(); ++i) {
    columns[i].number = static_cast<std::uint16_t>(64 * i);
    columns[i].time_ns = 1000 * i;
    columns[i].pixels.resize(16);
    columns[i].pixels[7] = {10'000, 50, 0, 0};  // 1 degree up
  }
  const auto driver = ouster::make_ouster_driver({"ouster", ouster::metadata_of(beams)});
  Output out;
  driver->take(ouster::encode_packet(columns), time_from_nanos(1'700'000'000'000'000'000), out);
  driver->finish(out);
  ASSERT_EQ(out.scans.size(), 1U);
  ASSERT_EQ(out.scans[0].returns.size(), 16U);
  const Return& behind = out.scans[0].returns[0];
  const double up = M_PI / 180, flat_m = (10 - 0.0158) * std::cos(up) + 0.0158;
  EXPECT_NEAR(behind.x_m, -flat_m, 1e-4);
  EXPECT_NEAR(behind.y_m, 0, 1e-4);
  EXPECT_NEAR(behind.z_m, (10 - 0.0158) * std::sin(up) + 0.0362, 1e-4);
  // A quarter turn later, clockwise: to the left of a sensor that looks ahead.
  const Return& later = out.scans[0].returns[4];
  EXPECT_NEAR(later.x_m, 0, 1e-4);
  EXPECT_NEAR(later.y_m, flat_m, 1e-4);
}

TEST(Ouster, SaysWhatItsMetadataLack) {
  for (const char* text : {"", "[]", "{}", R"({"beam_altitude_angles":[1,2]})",
                           R"({"beam_altitude_angles":[1],"beam_azimuth_angles":[1],
                               "lidar_mode":"-3x10"})"}) {
    const auto beams = ouster::parse_beams(text);
    ASSERT_FALSE(beams) << text;
    EXPECT_THAT(beams.error().message, HasSubstr("metadata of the Ouster"));
  }
}

}  // namespace
}  // namespace scanfuse::drivers
