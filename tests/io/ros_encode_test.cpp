#include <gtest/gtest.h>

#include <cmath>

#include "io/ros_test_scans.hpp"
#include "scanfuse/io/ros/decode.hpp"
#include "scanfuse/io/ros/encode.hpp"

namespace scanfuse::io::ros {
namespace {

DecodedMessage read_back(const EncodedMessage& message, const std::string& topic = "/topic") {
  auto decoded = decode_message({topic, message.type, "cdr", ""}, message.bytes);
  EXPECT_TRUE(decoded.has_value()) << decoded.error().message;
  return decoded ? std::move(*decoded) : DecodedMessage{};
}

void expect_same_returns(const Scan& a, const Scan& b, double tolerance) {
  ASSERT_EQ(a.returns.size(), b.returns.size());
  for (std::size_t i = 0; i < a.returns.size(); ++i) {
    const Return &p = a.returns[i], &q = b.returns[i];
    EXPECT_NEAR(p.x_m, q.x_m, tolerance);
    EXPECT_NEAR(p.y_m, q.y_m, tolerance);
    EXPECT_NEAR(p.z_m, q.z_m, tolerance);
    EXPECT_EQ(p.intensity, q.intensity);
    EXPECT_NEAR(p.time_offset_s, q.time_offset_s, 1e-6);
    EXPECT_EQ(p.beam, q.beam);
    EXPECT_EQ(p.layer, q.layer);
    EXPECT_EQ(p.echo, q.echo);
  }
}

TEST(RosEncode, APlanarScanComesBackFromLaserScan) {
  const Scan scan = planar_scan();
  const auto message = encode_cdr(scan);
  EXPECT_EQ(message.type, "sensor_msgs/msg/LaserScan");
  const auto back = std::get<Scan>(read_back(message).payload);
  expect_same_returns(scan, back, 1e-5);
  EXPECT_EQ(back.stamp, scan.stamp);
  EXPECT_EQ(back.frame_id, scan.frame_id);
  ASSERT_TRUE(back.beams.has_value());
  EXPECT_EQ(back.beams->columns, scan.beams->columns);
  EXPECT_NEAR(back.beams->first_azimuth_rad, scan.beams->first_azimuth_rad, 1e-6);
  EXPECT_NEAR(back.beams->step_rad, scan.beams->step_rad, 1e-8);
  EXPECT_NEAR(back.beams->max_range_m, scan.beams->max_range_m, 1e-5);
}

TEST(RosEncode, AScanThatTurnsClockwiseKeepsItsTimesInLaserScan) {
  Scan scan = planar_scan();
  for (auto& point : scan.returns) {
    point.time_offset_s = static_cast<float>(1e-4 * (scan.beams->columns - 1 - point.beam));
  }
  const auto message = encode_cdr(scan);
  ASSERT_EQ(message.type, "sensor_msgs/msg/LaserScan");
  auto back = std::get<Scan>(read_back(message).payload);
  std::reverse(back.returns.begin(), back.returns.end());
  expect_same_returns(scan, back, 1e-5);
}

TEST(RosEncode, AScanThatLaserScanCannotCarryComesBackBitForBitFromPointCloud2) {
  const Scan scan = layered_scan();
  const auto message = encode_cdr(scan);
  EXPECT_EQ(message.type, "sensor_msgs/msg/PointCloud2");
  const auto back = std::get<Scan>(read_back(message).payload);
  expect_same_returns(scan, back, 0);
  EXPECT_EQ(back.stamp, scan.stamp);
}

TEST(RosEncode, WhatLaserScanWouldLoseGoesIntoAPointCloud) {
  const auto changed = [](auto change) {
    Scan scan = planar_scan();
    change(scan);
    return fits_laser_scan(scan);
  };
  EXPECT_TRUE(changed([](Scan&) {}));
  EXPECT_TRUE(changed([](Scan& s) { s.returns.clear(); }));
  EXPECT_FALSE(changed([](Scan& s) { s.beams.reset(); }));
  EXPECT_FALSE(changed([](Scan& s) { s.beams->layers = 2; }));
  EXPECT_FALSE(changed([](Scan& s) { s.returns[3].z_m = 0.1F; }));
  EXPECT_FALSE(changed([](Scan& s) { s.returns[3].echo = 1; }));
  EXPECT_FALSE(changed([](Scan& s) { s.returns[3].beam = s.returns[2].beam; }));
  EXPECT_FALSE(changed([](Scan& s) { s.returns[3].beam = -1; }));
  EXPECT_FALSE(changed([](Scan& s) { s.returns[3].time_offset_s += 1e-3F; }));
  EXPECT_FALSE(changed([](Scan& s) { s.beams->max_range_m = 1; }));
}

/// Beams of four layers over half a turn; of the outermost ones nothing came back.
Scan layered_fan() {
  Scan scan;
  scan.beams = BeamPattern{radians(100), radians(0.25), 721, 4, 0.3, 200};
  for (int beam = 40; beam < 600; beam += 1 + beam % 3) {
    const double azimuth = scan.beams->first_azimuth_rad + beam * scan.beams->step_rad;
    Return point;
    point.x_m = static_cast<float>(20 * std::cos(azimuth));
    point.y_m = static_cast<float>(20 * std::sin(azimuth));
    point.beam = beam;
    point.layer = static_cast<std::int16_t>(beam % 3);
    scan.returns.push_back(point);
  }
  return scan;
}

TEST(RosEncode, ThePatternOfTheBeamsSurvivesAPointCloud) {
  const Scan scan = layered_fan();
  const auto back = std::get<Scan>(read_back(encode_cdr(scan)).payload);
  EXPECT_EQ(back.returns.size(), scan.returns.size());
  ASSERT_TRUE(back.beams.has_value());
  EXPECT_EQ(back.beams->columns, 721);
  EXPECT_EQ(back.beams->layers, 4);
  EXPECT_NEAR(back.beams->first_azimuth_rad, radians(100), 1e-6);
  EXPECT_NEAR(back.beams->step_rad, radians(0.25), 1e-8);
}

TEST(RosEncode, ReturnsThatStandOnNoEvenPatternComeBackWithoutOne) {
  Scan scan = layered_fan();
  std::swap(scan.returns[10].beam, scan.returns[80].beam);
  EXPECT_FALSE(std::get<Scan>(read_back(encode_cdr(scan)).payload).beams.has_value());
  scan.returns.resize(3);
  EXPECT_FALSE(std::get<Scan>(read_back(encode_cdr(scan)).payload).beams.has_value());
}

TEST(RosEncode, EmptyScansComeBackEmpty) {
  Scan scan;
  EXPECT_TRUE(std::get<Scan>(read_back(encode_cdr(scan)).payload).returns.empty());
}

TEST(RosEncode, OdometryTransformsAndImuComeBackAsTheyWere) {
  PoseSample pose{
      time_from_nanos(1'700'000'000'123'456'789), "odom", "base", test_pose(), 3.5, -0.25};
  const auto pose_back = std::get<PoseSample>(read_back(encode_cdr(pose)).payload);
  EXPECT_EQ(pose_back.stamp, pose.stamp);
  EXPECT_EQ(pose_back.child_frame_id, "base");
  EXPECT_EQ(pose_back.pose.rotation.coeffs(), pose.pose.rotation.coeffs());
  EXPECT_EQ(pose_back.pose.translation_m, pose.pose.translation_m);
  EXPECT_EQ(pose_back.speed_m_per_s, 3.5);
  EXPECT_EQ(pose_back.yaw_rate_rad_per_s, -0.25);

  pose.speed_m_per_s.reset();
  EXPECT_FALSE(std::get<PoseSample>(read_back(encode_cdr(pose)).payload).speed_m_per_s);

  const std::vector<TransformSample> edges{{pose.stamp, "map", "odom", test_pose(), true},
                                           {pose.stamp, "odom", "base", {}, true}};
  const auto message = encode_cdr(std::span<const TransformSample>(edges));
  const auto edges_back =
      std::get<std::vector<TransformSample>>(read_back(message, "/tf_static").payload);
  ASSERT_EQ(edges_back.size(), 2U);
  EXPECT_EQ(edges_back[0].parent, "map");
  EXPECT_EQ(edges_back[1].child, "base");
  EXPECT_TRUE(edges_back[1].is_static);
  EXPECT_EQ(edges_back[0].parent_from_child.translation_m, test_pose().translation_m);

  ImuSample imu{pose.stamp, "imu", std::nullopt, {1, 2, 3}, {4, 5, 6}};
  auto imu_back = std::get<ImuSample>(read_back(encode_cdr(imu)).payload);
  EXPECT_FALSE(imu_back.orientation.has_value());
  EXPECT_EQ(imu_back.acceleration_m_per_s2, imu.acceleration_m_per_s2);
  imu.orientation = test_pose().rotation;
  imu_back = std::get<ImuSample>(read_back(encode_cdr(imu)).payload);
  EXPECT_EQ(imu_back.orientation->coeffs(), imu.orientation->coeffs());
}

TEST(RosEncode, StampsBefore1970ComeBack) {
  Scan scan;
  scan.stamp = time_from_nanos(-1'500'000'000);
  EXPECT_EQ(std::get<Scan>(read_back(encode_cdr(scan)).payload).stamp, scan.stamp);
}

TEST(RosEncode, EveryMessageBringsItsDefinitionWithAllParts) {
  const auto odometry = encode_cdr(PoseSample{}).definition;
  for (const char* part : {"MSG: geometry_msgs/Quaternion", "MSG: builtin_interfaces/Time",
                           "geometry_msgs/TwistWithCovariance twist"}) {
    EXPECT_NE(odometry.find(part), std::string::npos) << part;
  }
  EXPECT_FALSE(encode_cdr(planar_scan()).definition.empty());
  EXPECT_FALSE(encode_cdr(layered_scan()).definition.empty());
  EXPECT_FALSE(encode_cdr(ImuSample{}).definition.empty());
}

}  // namespace
}  // namespace scanfuse::io::ros
