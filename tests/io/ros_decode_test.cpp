#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "io/ros_message_builder.hpp"
#include "io/ros_test_scans.hpp"
#include "scanfuse/geometry/angles.hpp"
#include "scanfuse/io/ros/decode.hpp"

namespace scanfuse::io::ros {
namespace {

using Form = MessageBuilder::Form;
constexpr Form kForms[] = {Form::kRos1, Form::kCdrLittle, Form::kCdrBig, Form::kCdr2Little};
constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr float kInf = std::numeric_limits<float>::infinity();

RawChannel channel_for(Form form, const std::string& type) {
  return {"/topic", type, form == Form::kRos1 ? "ros1" : "cdr", ""};
}

Result<DecodedMessage> decode(const MessageBuilder& message, Form form, const std::string& type) {
  return decode_message(channel_for(form, type), message.bytes());
}

MessageBuilder laser_scan(Form form, float first, float step, float time_step,
                          const std::vector<float>& ranges, const std::vector<float>& intensities) {
  MessageBuilder message(form);
  message.header(100, 250'000'000, "laser");
  message.put_all<float>({first, first + step * 4, step, time_step, 0.1F, 0.5F, 10.0F});
  message.sequence(ranges).sequence(intensities);
  return message;
}

TEST(RosDecode, LaserScanReadsAlikeInEveryEncoding) {
  for (const Form form : kForms) {
    const auto message = laser_scan(form, -1, 0.5F, 0.01F, {1, 2, 3, 4, 5}, {9, 8, 7, 6, 5});
    const auto decoded = decode(message, form, "sensor_msgs/LaserScan");
    ASSERT_TRUE(decoded.has_value()) << decoded.error().message;
    const auto& scan = std::get<Scan>(decoded->payload);
    EXPECT_EQ(scan.stamp, time_from_nanos(100'250'000'000));
    EXPECT_EQ(scan.frame_id, "laser");
    EXPECT_EQ(scan.sensor, "/topic");
    ASSERT_EQ(scan.returns.size(), 5U);
    EXPECT_NEAR(scan.returns[1].x_m, 2 * std::cos(-0.5), 1e-6);
    EXPECT_NEAR(scan.returns[1].y_m, 2 * std::sin(-0.5), 1e-6);
    EXPECT_EQ(scan.returns[1].intensity, 8);
    EXPECT_EQ(scan.returns[4].beam, 4);
    EXPECT_NEAR(scan.returns[4].time_offset_s, 0.04, 1e-7);
    EXPECT_EQ(scan.beams->columns, 5);
    EXPECT_EQ(scan.beams->max_range_m, 10);
  }
}

TEST(RosDecode, CodesForNoEchoAreNoReturns) {
  const auto message = laser_scan(Form::kRos1, 0, 0.1F, 0,
                                  {kNan, kInf, -kInf, 0, -1, 0.4F, 0.5F, 10, 11, 9.99F}, {});
  const auto decoded = decode(message, Form::kRos1, "sensor_msgs/LaserScan");
  const auto& scan = std::get<Scan>(decoded->payload);
  ASSERT_EQ(scan.returns.size(), 2U);
  EXPECT_EQ(scan.returns[0].beam, 6);
  EXPECT_EQ(scan.returns[1].beam, 9);
}

TEST(RosDecode, AClockwiseScannerCountsItsColumnsByIncreasingBearing) {
  const auto message = laser_scan(Form::kRos1, 1, -0.5F, 0.01F, {1, 2, 3}, {});
  const auto decoded = decode(message, Form::kRos1, "sensor_msgs/LaserScan");
  const auto& scan = std::get<Scan>(decoded->payload);
  EXPECT_EQ(scan.returns[0].beam, 2);
  EXPECT_NEAR(std::atan2(scan.returns[0].y_m, scan.returns[0].x_m), 1, 1e-6);
  EXPECT_EQ(scan.returns[0].time_offset_s, 0);
  EXPECT_NEAR(scan.beams->first_azimuth_rad, 0, 1e-6);
  EXPECT_GT(scan.beams->step_rad, 0);
}

TEST(RosDecode, AnglesThatPlaceNoBeamsAreAnError) {
  for (const float step : {0.0F, kNan, kInf, 1e30F}) {
    const auto message = laser_scan(Form::kRos1, 0, step, 0, {1, 2, 3}, {});
    const auto decoded = decode(message, Form::kRos1, "sensor_msgs/LaserScan");
    ASSERT_FALSE(decoded.has_value());
    EXPECT_NE(decoded.error().message.find("sensor_msgs/LaserScan on /topic: byte"),
              std::string::npos);
  }
}

TEST(RosDecode, ASenselessTimeIncrementIsLeftOutAndNoted) {
  for (const float step : {kNan, kInf, 1e9F}) {
    const auto message = laser_scan(Form::kRos1, 0, 0.1F, step, {1, 2, 3}, {});
    const auto decoded = decode(message, Form::kRos1, "sensor_msgs/LaserScan");
    ASSERT_TRUE(decoded.has_value());
    EXPECT_FALSE(decoded->diagnostics.empty());
    EXPECT_EQ(std::get<Scan>(decoded->payload).returns[2].time_offset_s, 0);
  }
}

TEST(RosDecode, EchoesOfABeamAreNumberedFromTheNearest) {
  for (const Form form : kForms) {
    MessageBuilder message(form);
    message.header(1, 0, "laser").put_all<float>({0, 1, 1, 0, 0, 0.5F, 10});
    message.put(std::uint32_t{2}).sequence<float>({7, kNan, 3}).sequence<float>({});
    message.put(std::uint32_t{2}).sequence<float>({70, 0, 30}).sequence<float>({});
    const auto decoded = decode(message, form, "sensor_msgs/msg/MultiEchoLaserScan");
    ASSERT_TRUE(decoded.has_value()) << decoded.error().message;
    const auto& returns = std::get<Scan>(decoded->payload).returns;
    ASSERT_EQ(returns.size(), 2U);
    EXPECT_EQ(returns[0].x_m, 3);
    EXPECT_EQ(returns[0].echo, 0);
    EXPECT_EQ(returns[0].intensity, 30);
    EXPECT_EQ(returns[1].x_m, 7);
    EXPECT_EQ(returns[1].echo, 1);
  }
}

struct FieldSpec {
  const char* name;
  std::uint32_t offset;
  std::uint8_t datatype;
};

/// A cloud of `height` rows whose data were laid out by the caller.
MessageBuilder cloud(Form form, std::uint32_t height, std::uint32_t width,
                     const std::vector<FieldSpec>& fields, bool big_endian, std::uint32_t step,
                     std::uint32_t row_step, const std::vector<std::byte>& data,
                     std::uint32_t seconds = 1000) {
  MessageBuilder message(form);
  message.header(seconds, 0, "lidar").put(height).put(width);
  message.put(static_cast<std::uint32_t>(fields.size()));
  for (const auto& field : fields) {
    message.text(field.name).put(field.offset).put(field.datatype).put(std::uint32_t{1});
  }
  message.put(static_cast<std::uint8_t>(big_endian)).put(step).put(row_step);
  message.sequence(data).put(std::uint8_t{0});
  return message;
}

template <class T>
void lay(std::vector<std::byte>& data, std::size_t at, T value, bool big_endian = false) {
  if (data.size() < at + sizeof(T)) data.resize(at + sizeof(T));
  std::byte image[sizeof(T)];
  std::memcpy(image, &value, sizeof(T));
  for (std::size_t i = 0; i < sizeof(T); ++i) {
    data[at + i] = image[big_endian ? sizeof(T) - 1 - i : i];
  }
}

TEST(RosDecode, CloudsOfAnyLayoutAndByteOrderRead) {
  for (const bool big_endian : {false, true}) {
    std::vector<std::byte> data;  // padded points in two padded rows
    for (std::size_t row = 0; row < 2; ++row) {
      for (std::size_t column = 0; column < 2; ++column) {
        const std::size_t at = row * 80 + column * 32;
        lay<double>(data, at + 8, 1.5 + static_cast<double>(row), big_endian);
        lay<float>(data, at + 4, 2.5F + static_cast<float>(column), big_endian);
        lay<std::int16_t>(data, at + 2, -3, big_endian);
        lay<std::uint16_t>(data, at + 18, 500, big_endian);
        lay<std::uint8_t>(data, at, static_cast<std::uint8_t>(row + 5), big_endian);
        lay<std::uint32_t>(data, at + 20, 50'000'000, big_endian);
      }
    }
    data.resize(160);
    for (const Form form : kForms) {
      const auto message = cloud(form, 2, 2,
                                 {{"z", 2, 3},
                                  {"unknown", 400, 99},
                                  {"y", 4, 7},
                                  {"x", 8, 8},
                                  {"reflectivity", 18, 4},
                                  {"ring", 0, 2},
                                  {"t", 20, 6}},
                                 big_endian, 32, 80, data);
      const auto decoded = decode(message, form, "sensor_msgs/PointCloud2");
      ASSERT_TRUE(decoded.has_value()) << decoded.error().message;
      const auto& returns = std::get<Scan>(decoded->payload).returns;
      ASSERT_EQ(returns.size(), 4U);
      EXPECT_EQ(returns[3].x_m, 2.5F);
      EXPECT_EQ(returns[3].y_m, 3.5F);
      EXPECT_EQ(returns[3].z_m, -3);
      EXPECT_EQ(returns[3].intensity, 500);
      EXPECT_EQ(returns[3].layer, 6);
      EXPECT_NEAR(returns[3].time_offset_s, 0.05, 1e-7);
      EXPECT_EQ(returns[3].beam, -1);
    }
  }
}

/// One point per value, x = 1, with the values as field `name`.
Result<DecodedMessage> cloud_with_times(const char* name, const std::vector<double>& values) {
  std::vector<std::byte> data;
  for (std::size_t i = 0; i < values.size(); ++i) {
    lay<float>(data, 20 * i, 1);
    lay<double>(data, 20 * i + 12, values[i]);
  }
  const auto message = cloud(Form::kRos1, 1, static_cast<std::uint32_t>(values.size()),
                             {{"x", 0, 7}, {"y", 4, 7}, {"z", 8, 7}, {name, 12, 8}}, false, 20, 0,
                             data, 1'700'000'000);
  return decode(message, Form::kRos1, "sensor_msgs/PointCloud2");
}

TEST(RosDecode, PointTimesMayBeOffsetsOrInstantsInSecondsOrNanoseconds) {
  const std::vector<std::vector<double>> spellings{
      {0, 0.05}, {1'700'000'000.0, 1'700'000'000.05}, {1.7e18, 1.7e18 + 5e7}};
  for (const auto& times : spellings) {
    const auto decoded = cloud_with_times("timestamp", times);
    ASSERT_TRUE(decoded.has_value());
    const auto& returns = std::get<Scan>(decoded->payload).returns;
    EXPECT_NEAR(returns[0].time_offset_s, 0, 1e-6);
    EXPECT_NEAR(returns[1].time_offset_s, 0.05, 1e-6);
  }
}

TEST(RosDecode, PointTimesThatMakeNoSenseAreLeftOut) {
  for (const double time : {12345.0, 1e300, -1e300, double{kNan}, double{kInf}}) {
    const auto decoded = cloud_with_times("t", {time});
    ASSERT_TRUE(decoded.has_value());
    EXPECT_EQ(std::get<Scan>(decoded->payload).returns[0].time_offset_s, 0);
  }
}

TEST(RosDecode, PointsThatAreNoEchoAreDropped) {
  std::vector<std::byte> data;
  const float xs[] = {kNan, kInf, 0, 1e30F, 1};
  for (std::size_t i = 0; i < 5; ++i) lay<float>(data, 12 * i, xs[i]), data.resize(12 * i + 12);
  const auto message =
      cloud(Form::kRos1, 1, 5, {{"x", 0, 7}, {"y", 4, 7}, {"z", 8, 7}}, false, 12, 60, data);
  const auto decoded = decode(message, Form::kRos1, "sensor_msgs/PointCloud2");
  EXPECT_EQ(std::get<Scan>(decoded->payload).returns.size(), 1U);
}

TEST(RosDecode, CloudsWhoseSizesDoNotAgreeAreErrors) {
  const std::vector<FieldSpec> xyz{{"x", 0, 7}, {"y", 4, 7}, {"z", 8, 7}};
  const std::vector<std::byte> data(24);
  const auto refused = [&](std::uint32_t height, std::uint32_t width,
                           const std::vector<FieldSpec>& fields, std::uint32_t step,
                           std::uint32_t row_step) {
    const auto message = cloud(Form::kRos1, height, width, fields, false, step, row_step, data);
    return !decode(message, Form::kRos1, "sensor_msgs/PointCloud2").has_value();
  };
  EXPECT_FALSE(refused(1, 2, xyz, 12, 24));
  EXPECT_FALSE(refused(0, ~0U, xyz, 12, 0));
  EXPECT_TRUE(refused(1, 3, xyz, 12, 36));
  EXPECT_TRUE(refused(1, 2, xyz, 8, 24)) << "z reaches over the point";
  EXPECT_TRUE(refused(1, 2, xyz, 0, 24));
  EXPECT_TRUE(refused(2, 2, xyz, 12, 12)) << "rows overlap";
  EXPECT_TRUE(refused(~0U, ~0U, xyz, 12, ~0U));
  EXPECT_TRUE(refused(1, 2, {{"x", 0, 7}, {"y", 4, 7}}, 12, 24)) << "no z";
  EXPECT_TRUE(refused(1, 2, {{"x", 0, 7}, {"y", 4, 7}, {"z", 8, 17}}, 12, 24));
  EXPECT_TRUE(refused(1, 2, {{"x", 0, 7}, {"y", 4, 7}, {"z", ~0U, 7}}, 12, 24));
}

MessageBuilder pose_message(Form form, double x, const std::vector<double>& quaternion) {
  MessageBuilder message(form);
  message.header(5, 0, "map").put_all<double>({x, 2, 3}).put_all(quaternion);
  return message;
}

TEST(RosDecode, PosesAreNormalisedAndUnsetRotationsNoted) {
  for (const Form form : kForms) {
    auto decoded = decode(pose_message(form, 1, {0, 0, 2, 0}), form, "geometry_msgs/PoseStamped");
    ASSERT_TRUE(decoded.has_value()) << decoded.error().message;
    const auto& turned = std::get<PoseSample>(decoded->payload);
    EXPECT_EQ(turned.pose.rotation.z(), 1);
    EXPECT_EQ(turned.pose.translation_m.z(), 3);
    EXPECT_FALSE(turned.speed_m_per_s.has_value());
    decoded = decode(pose_message(form, 1, {0, 0, 0, 0}), form, "geometry_msgs/PoseStamped");
    EXPECT_EQ(std::get<PoseSample>(decoded->payload).pose.rotation.w(), 1);
    EXPECT_FALSE(decoded->diagnostics.empty());
    EXPECT_FALSE(decode(pose_message(form, kNan, {0, 0, 0, 1}), form, "geometry_msgs/PoseStamped"));
  }
}

TEST(RosDecode, ATransformThatIsNotFiniteDoesNotHideTheOthers) {
  for (const Form form : kForms) {
    MessageBuilder message(form);
    message.put(std::uint32_t{2});
    message.header(5, 0, "map").text("odom").put_all<double>({kNan, 2, 3, 0, 0, 0, 1});
    message.header(5, 0, "odom").text("base").put_all<double>({1, 2, 3, 0, 0, 0, 1});
    const auto decoded = decode(message, form, "tf2_msgs/msg/TFMessage");
    ASSERT_TRUE(decoded.has_value()) << decoded.error().message;
    const auto& edges = std::get<std::vector<TransformSample>>(decoded->payload);
    ASSERT_EQ(edges.size(), 1U);
    EXPECT_EQ(edges[0].child, "base");
    EXPECT_FALSE(edges[0].is_static);
    EXPECT_TRUE(decoded->diagnostics.any_damage());
  }
}

TEST(RosDecode, CutAtAnyByteAMessageIsAnErrorThatNamesTheByte) {
  for (const Form form : kForms) {
    const auto whole = laser_scan(form, 0, 0.1F, 0, {1, 2, 3}, {4, 5, 6}).bytes();
    for (std::size_t length = 0; length < whole.size(); ++length) {
      const auto decoded = decode_message(channel_for(form, "sensor_msgs/LaserScan"),
                                          std::span(whole).first(length));
      ASSERT_FALSE(decoded.has_value());
      EXPECT_NE(decoded.error().message.find("byte "), std::string::npos);
    }
  }
}

TEST(RosDecode, BytesLeftOverAreAnError) {
  auto bytes = laser_scan(Form::kRos1, 0, 0.1F, 0, {1, 2, 3}, {}).bytes();
  bytes.push_back({});
  EXPECT_FALSE(decode_message(channel_for(Form::kRos1, "sensor_msgs/LaserScan"), bytes));
}

TEST(RosDecode, UnknownTypesAndEncodingsAreKnownAsSuch) {
  EXPECT_EQ(kind_of("sensor_msgs/msg/LaserScan", "cdr"), MessageKind::kLaserScan);
  EXPECT_EQ(kind_of("tf/tfMessage", "ros1"), MessageKind::kTransforms);
  EXPECT_EQ(kind_of("sensor_msgs/LaserScan", "protobuf"), MessageKind::kUnknown);
  EXPECT_EQ(kind_of("std_msgs/String", "ros1"), MessageKind::kUnknown);
}

}  // namespace
}  // namespace scanfuse::io::ros
