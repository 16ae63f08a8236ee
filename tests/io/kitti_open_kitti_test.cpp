#include <gmock/gmock.h>

#include <limits>

#include "io/reading.hpp"
#include "io/temporary_folder.hpp"
#include "scanfuse/core/random.hpp"
#include "scanfuse/io/kitti/open_kitti.hpp"
#include "scanfuse/io/kitti/oxts.hpp"

namespace scanfuse::io {
namespace {

using scanfuse::io_testing::all_finite;
using scanfuse::io_testing::read_out;
using scanfuse::io_testing::TemporaryFolder;

std::string bin_of(const std::vector<float>& values) {
  return {reinterpret_cast<const char*>(values.data()), values.size() * sizeof(float)};
}

/// An oxts packet at a place and heading, 5 m/s forward, 0.25 rad/s to the left.
std::string oxts_line(double latitude_deg, double longitude_deg, double yaw_rad) {
  std::string line = fmt::format("{} {} 100 0 0 {} 0 0 5", latitude_deg, longitude_deg, yaw_rad);
  for (int k = 9; k < 30; ++k) line += k == 22 ? " 0.25" : " 0";
  return line + "\n";
}

const std::string kScan = bin_of({10, 0, 0, 0.5f, 0, -5, -1, 0.25f});

TEST(Kitti, ReturnsAreReadWithAnEstimatedLayer) {
  Diagnostics diagnostics;
  const auto scan = read_kitti_bin(kScan, "0.bin", diagnostics);
  ASSERT_TRUE(scan);
  ASSERT_EQ(scan->returns.size(), 2u);
  EXPECT_EQ(scan->returns[0].x_m, 10);
  EXPECT_EQ(scan->returns[0].intensity, 0.5f);
  EXPECT_GT(scan->returns[0].layer, scan->returns[1].layer) << "0 is the lowest";
  EXPECT_TRUE(diagnostics.empty());
}

TEST(Kitti, CutAndInfiniteReturnsAreDamageAndNothingAtAllAnError) {
  Diagnostics diagnostics;
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const auto scan = read_kitti_bin(bin_of({1, 2, 3, 0, nan, 1, 1, 1, 5}), "0.bin", diagnostics);
  ASSERT_TRUE(scan);
  EXPECT_EQ(scan->returns.size(), 1u);
  EXPECT_EQ(diagnostics.count("returns that are not finite dropped"), 1);
  EXPECT_EQ(diagnostics.count("cut off points"), 1);
  EXPECT_FALSE(read_kitti_bin("", "0.bin", diagnostics));
  EXPECT_FALSE(read_kitti_bin(bin_of({nan, nan, nan, nan}), "0.bin", diagnostics));
}

TEST(Kitti, ARawDriveGivesScansPosesAndTheMountInOrderOfTime) {
  const TemporaryFolder drive;
  for (const char* name : {"0000000000", "0000000001"}) {
    drive.write(std::string("velodyne_points/data/") + name + ".bin", kScan);
  }
  drive.write("velodyne_points/timestamps.txt",
              "2011-09-26 13:02:25.964389445\n2011-09-26 13:02:26.064389445\n");
  drive.write("oxts/data/0000000000.txt", oxts_line(49, 8, 0));
  drive.write("oxts/data/0000000001.txt", oxts_line(49, 8.0001, 0.1));
  drive.write("oxts/timestamps.txt",
              "2011-09-26 13:02:25.950000000\n2011-09-26 13:02:26.050000000\n");
  drive.write("calib_imu_to_velo.txt", "R: 1 0 0 0 1 0 0 0 1\nT: -0.8 0.3 -0.7\n");
  const auto out = read_out(open_recording(drive.path()));
  ASSERT_EQ(out.scans.size(), 2u) << (out.error ? out.error->message : "");
  ASSERT_EQ(out.poses.size(), 2u);
  EXPECT_EQ(to_nanos(out.scans[0].stamp), 1317042145964389445);
  EXPECT_LT(out.poses[0].stamp, out.scans[0].stamp);
  ASSERT_EQ(out.transforms.size(), 1u);
  EXPECT_NEAR(out.transforms[0].parent_from_child.translation_m.x(), 0.8, 1e-12);
  EXPECT_EQ(out.poses[1].yaw_rate_rad_per_s, 0.25);
  EXPECT_TRUE(out.diagnostics.empty());
}

TEST(Kitti, AFolderOfTheTrackingSetFindsItsPacketsBeside) {
  const TemporaryFolder root;
  root.write("velodyne/0003/000000.bin", kScan);
  root.write("velodyne/0003/000001.bin", kScan);
  root.write("oxts/0003.txt", oxts_line(49, 8, 0) + "broken\n");
  const auto out = read_out(open_recording(root.path() / "velodyne" / "0003"));
  EXPECT_EQ(out.scans.size(), 2u);
  EXPECT_EQ(out.poses.size(), 1u);
  EXPECT_EQ(out.diagnostics.count("bad oxts packet skipped"), 1);
  EXPECT_EQ(out.diagnostics.count("no times known: ten scans a second assumed"), 1);
}

TEST(Oxts, LengthsNearTheFirstPacketAreRight) {
  OxtsProjection projection;
  const auto first = parse_oxts(oxts_line(49, 8, 0));
  const auto north = parse_oxts(oxts_line(49.0001, 8, 0));
  const auto east = parse_oxts(oxts_line(49, 8.0001, 1));
  ASSERT_TRUE(first && north && east);
  EXPECT_EQ(projection.world_from_imu(*first).translation_m.norm(), 0);
  const double arc_m = radians(0.0001) * 6378137;
  EXPECT_NEAR(projection.world_from_imu(*north).translation_m.y(), arc_m, 1e-3);
  const Pose3 moved = projection.world_from_imu(*east);
  EXPECT_NEAR(moved.translation_m.x(), arc_m * std::cos(radians(49)), 1e-3);
  EXPECT_NEAR(moved.planar().heading_rad, 1, 1e-12);
  EXPECT_FALSE(parse_oxts("90 0 0"));
  EXPECT_FALSE(parse_oxts("x"));
}

TEST(Kitti, FlippedFilesGiveFiniteReturns) {
  RandomStream random(6);
  for (int round = 0; round < 1000; ++round) {
    std::string flipped = kScan;
    flipped[random.below(flipped.size())] ^= static_cast<char>(1 << random.below(8));
    scanfuse::io_testing::ReadOut out;
    auto scan = read_kitti_bin(flipped, "0.bin", out.diagnostics);
    if (scan) out.scans.push_back(std::move(*scan));
    EXPECT_TRUE(all_finite(out));
  }
}

}  // namespace
}  // namespace scanfuse::io
