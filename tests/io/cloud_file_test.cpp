#include "scanfuse/io/cloud/cloud_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "io/temporary_folder.hpp"

namespace scanfuse::io {
namespace {

using ::testing::HasSubstr;

Cloud some_cloud() {
  Cloud cloud;
  cloud.frame = CloudFrame::kAxis;
  for (int p = 0; p < 3; ++p) {
    const Eigen::Quaterniond turn(Eigen::AngleAxisd(0.1 * p, Eigen::Vector3d::UnitZ()));
    cloud.profiles.push_back({0.1 * p, {turn, {0.01 * p, 0.5, -0.25}}});
    for (int b = 0; b < 4; ++b) {
      cloud.points.push_back({{0.5 * b, 0.25 * p, 1.125}, 10.0 * b, p, 2 * b});
    }
  }
  return cloud;
}

void expect_same(const Cloud& a, const Cloud& b) {
  EXPECT_EQ(a.frame, b.frame);
  ASSERT_EQ(a.profiles.size(), b.profiles.size());
  for (std::size_t k = 0; k < a.profiles.size(); ++k) {
    EXPECT_DOUBLE_EQ(a.profiles[k].turntable_rad, b.profiles[k].turntable_rad);
    EXPECT_LT((a.profiles[k].cloud_from_lidar.translation_m -
               b.profiles[k].cloud_from_lidar.translation_m)
                  .norm(),
              1e-12);
  }
  ASSERT_EQ(a.points.size(), b.points.size());
  for (std::size_t k = 0; k < a.points.size(); ++k) {
    EXPECT_LT((a.points[k].position_m - b.points[k].position_m).norm(), 1e-6);
    EXPECT_EQ(a.points[k].profile, b.points[k].profile);
    EXPECT_EQ(a.points[k].beam, b.points[k].beam);
    EXPECT_EQ(a.points[k].intensity, b.points[k].intensity);
  }
}

TEST(CloudFile, PlyAndPcdReadBack) {
  const io_testing::TemporaryFolder folder;
  for (const char* name : {"cloud.ply", "cloud.pcd"}) {
    const auto path = folder.path() / name;
    ASSERT_TRUE(write_cloud(path, some_cloud()));
    Diagnostics diagnostics;
    const auto again = read_cloud(path, diagnostics);
    ASSERT_TRUE(again) << again.error().message;
    expect_same(some_cloud(), *again);
    EXPECT_TRUE(diagnostics.empty());
  }
  EXPECT_FALSE(write_cloud(folder.path() / "cloud.xyz", some_cloud()));
}

TEST(CloudFile, AsciiPlyFromElsewhere) {
  Diagnostics diagnostics;
  const auto cloud = parse_cloud(
      "ply\r\nformat ascii 1.0\r\ncomment by hand\r\nelement vertex 3\r\nproperty float nx\r\n"
      "property float x\r\nproperty float y\r\nproperty float z\r\nelement face 1\r\n"
      "property list uchar int vertex_indices\r\nend_header\r\n"
      "0 1 2 3\r\n0 nan 5 6\r\n0 7 8 9\r\n3 0 1 2\r\n",
      "a.ply", diagnostics);
  ASSERT_TRUE(cloud) << cloud.error().message;
  ASSERT_EQ(cloud->points.size(), 2u);
  EXPECT_EQ(cloud->points[1].position_m, Eigen::Vector3d(7, 8, 9));
  EXPECT_TRUE(std::isnan(cloud->points[0].intensity));
  EXPECT_FALSE(cloud->has_profiles());
  EXPECT_EQ(diagnostics.count("points that are not finite dropped"), 1);
}

TEST(CloudFile, CutFilesGiveWhatIsThere) {
  const std::string whole = ply_bytes(some_cloud());
  Diagnostics diagnostics;
  const auto cut = parse_cloud(whole.substr(0, whole.size() - 50), "cut.ply", diagnostics);
  ASSERT_TRUE(cut);
  EXPECT_EQ(cut->points.size(), 10u);
  EXPECT_TRUE(diagnostics.any_damage());
  const auto header =
      parse_cloud(whole.substr(0, whole.find("end_header")), "cut.ply", diagnostics);
  ASSERT_FALSE(header);
  EXPECT_THAT(header.error().message, HasSubstr("end_header"));
}

TEST(CloudFile, FaultsNameLineAndRemedy) {
  Diagnostics diagnostics;
  const auto fault = [&](const std::string& text) {
    const auto read = parse_cloud(text, "bad", diagnostics);
    EXPECT_FALSE(read);
    return read ? "" : read.error().message;
  };
  EXPECT_THAT(fault("hello"), HasSubstr("neither PLY nor PCD"));
  EXPECT_THAT(fault("ply\nformat binary_big_endian 1.0\nend_header\n"), HasSubstr("bad:2:"));
  EXPECT_THAT(fault("ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nend_header\n1\n"),
              HasSubstr("x, y and z"));
  EXPECT_THAT(fault("ply\ncomment scanfuse profile 5 x\nend_header\n"), HasSubstr("bad:2:"));
  EXPECT_THAT(fault("ply\nelement vertex 99999999999999999999\nend_header\n"), HasSubstr("bad:2:"));
}

}  // namespace
}  // namespace scanfuse::io
