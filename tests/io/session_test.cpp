#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "io/temporary_folder.hpp"
#include "scanfuse/io/session/features_json.hpp"
#include "scanfuse/io/session/rig_toml.hpp"
#include "scanfuse/io/session/scan_table.hpp"
#include "scanfuse/io/session/session_folder.hpp"

// session.toml, scans, features.json and rig.toml: what reads back, and what bad files say.
namespace scanfuse::io {
namespace {

using io_testing::TemporaryFolder;
using ::testing::AllOf;
using ::testing::HasSubstr;

constexpr const char* kSession =
    "[camera]\nwidth_px = 1624\nheight_px = 1234\nfx_px = 2757.4\nfy_px = 2758.6\ncx_px = 831.6\n"
    "cy_px = 638.9\nk1 = -0.076\nk2 = 0.371\n"
    "[[board]]\nrows = 2\ncolumns = 3\nsquare_mm = 20\n"
    "[[board]]\nrows = 2\ncolumns = 2\nsquare_m = 0.02\n"
    "[turntable]\nfirst_deg = -1\nstep_deg = 0.25\npositions = 3\n"
    "[lidar]\nrange_unit = \"mm\"\ninvalid_ranges = [0, 65535]\n";

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const auto at = text.find(from);
  EXPECT_NE(at, text.npos) << from;
  return at == text.npos ? text : text.replace(at, from.size(), to);
}

std::string session_fault(const std::string& text) {
  const auto read = parse_session_file(text, "session.toml");
  EXPECT_FALSE(read);
  return read ? "" : read.error().message;
}

TEST(SessionFile, ReadsUnitsBoardsAndAngles) {
  const auto read = parse_session_file(kSession, "session.toml");
  ASSERT_TRUE(read) << read.error().message;
  EXPECT_DOUBLE_EQ(read->camera->fy_px, 2758.6);
  EXPECT_DOUBLE_EQ(read->boards[0].spec.square_m, 0.02);
  ASSERT_EQ(read->turntable_rad.size(), 3u);
  EXPECT_NEAR(degrees(read->turntable_rad[2]), -0.5, 1e-12);
  EXPECT_DOUBLE_EQ(read->lidar.range_unit_m, 1e-3);
  EXPECT_EQ(read->lidar.invalid_ranges, (std::vector<double>{0, 65535}));
}

TEST(SessionFile, WhatIsWrittenReadsBack) {
  const auto read = parse_session_file(kSession, "session.toml");
  ASSERT_TRUE(read);
  const auto again = parse_session_file(session_file_text(*read), "again");
  ASSERT_TRUE(again) << again.error().message;
  EXPECT_DOUBLE_EQ(again->camera->k2, 0.371);
  EXPECT_EQ(again->turntable_rad.size(), 3u);
  EXPECT_NEAR(again->turntable_rad[1], read->turntable_rad[1], 1e-14);
  EXPECT_EQ(again->lidar.range_unit_m, 1e-3);
}

TEST(SessionFile, FaultsNameTheirPlaceAndTheRemedy) {
  EXPECT_THAT(session_fault(replaced(kSession, "rows = 2", "rowz = 2")),
              AllOf(HasSubstr("session.toml:11:"), HasSubstr("'rowz'"), HasSubstr("'rows'")));
  EXPECT_THAT(session_fault(replaced(kSession, "square_mm = 20", "square_mm = -3")),
              HasSubstr("square_mm needs a number"));
  EXPECT_THAT(session_fault(replaced(kSession, "\"mm\"", "\"inch\"")),
              AllOf(HasSubstr("session.toml:23:"), HasSubstr("none of: m, mm")));
  EXPECT_THAT(
      session_fault(replaced(kSession, "[[board]]\nrows = 2\ncolumns = 2\nsquare_m = 0.02\n", "")),
      HasSubstr("a V has two"));
  EXPECT_THAT(session_fault(replaced(kSession, "first_deg = -1\n", "angles_deg = [1, 2]\n")),
              HasSubstr("angles_deg or first_deg"));
  EXPECT_THAT(session_fault(replaced(kSession, "fx_px = 2757.4\n", "")),
              HasSubstr("fx_px is missing"));
  EXPECT_THAT(session_fault("[camera\n"), HasSubstr("session.toml:1:"));
  EXPECT_FALSE(parse_session_file("lidar = 3\n", "x"));
}

std::vector<BeamReturn> scan_of(const std::string& text, const LidarConventions& lidar = {}) {
  Diagnostics diagnostics;
  auto scan = parse_scan_table(text, "scan_0000.csv", lidar, diagnostics);
  EXPECT_TRUE(scan) << scan.error().message;
  return scan ? std::move(*scan) : std::vector<BeamReturn>{};
}

TEST(ScanTable, CodesNanAndZeroAreNoRange) {
  LidarConventions lidar;
  lidar.invalid_ranges = {0, 65.535};
  const auto scan =
      scan_of("angle,range\n0,1\n1,0\n2,nan\n3,65.535\n4,-1\n5,\n6,inf\n7,2\n8,1.5\n", lidar);
  ASSERT_EQ(scan.size(), 9u);
  for (const std::size_t k : {1u, 2u, 3u, 4u, 5u, 6u})
    EXPECT_TRUE(std::isnan(scan[k].range_m)) << k;
  EXPECT_DOUBLE_EQ(scan[7].range_m, 2);
  EXPECT_NEAR(scan[7].angle_rad, radians(7), 1e-15);
}

TEST(ScanTable, DirectionAndOrderAreBroughtToOurs) {
  LidarConventions lidar;
  lidar.clockwise = true;
  const auto scan = scan_of("range,angle,intensity\n1,0,5\n2,10,6\n3,20,7\n", lidar);
  ASSERT_EQ(scan.size(), 3u);
  EXPECT_NEAR(scan.front().angle_rad, radians(-20), 1e-15);
  EXPECT_DOUBLE_EQ(scan.front().range_m, 3);
  EXPECT_DOUBLE_EQ(scan.front().intensity, 7);
  const auto shuffled = scan_of("angle,range\n2,1.2\n0,1\n1,1.1\n");
  EXPECT_DOUBLE_EQ(shuffled[1].range_m, 1.1);
}

TEST(ScanTable, MillimetresDeclaredAsMetresAreSaid) {
  Diagnostics diagnostics;
  const auto scan =
      parse_scan_table("angle,range\n0,1000\n1,1010\n2,1020\n", "scan_0003.csv", {}, diagnostics);
  ASSERT_FALSE(scan);
  EXPECT_THAT(scan.error().message,
              AllOf(HasSubstr("scan_0003.csv"), HasSubstr("range_unit = \"mm\"")));
  LidarConventions radians_declared;
  radians_declared.angle_unit_rad = 1;
  const auto angles =
      parse_scan_table("angle,range\n-45,1\n0,1\n45,1\n", "s.csv", radians_declared, diagnostics);
  ASSERT_FALSE(angles);
  EXPECT_THAT(angles.error().message, HasSubstr("angle_unit = \"deg\""));
  EXPECT_FALSE(parse_scan_table("angle,range\n0,0\n1,0\n", "s.csv", {}, diagnostics));
  EXPECT_FALSE(parse_scan_table("", "s.csv", {}, diagnostics));
}

TEST(ScanTable, WhatIsWrittenReadsBack) {
  LidarConventions lidar;
  lidar.clockwise = true;
  lidar.range_unit_m = 1e-3;
  lidar.zero_rad = 0.3;
  const std::vector<BeamReturn> scan{{-0.2, 1.2345, 3}, {0, std::nan(""), 4}, {0.1, 2, 5}};
  const auto again = scan_of(scan_table_text(scan, lidar), lidar);
  ASSERT_EQ(again.size(), 3u);
  EXPECT_NEAR(again[0].angle_rad, -0.2, 1e-10);
  EXPECT_NEAR(again[0].range_m, 1.2345, 1e-12);
  EXPECT_TRUE(std::isnan(again[1].range_m));
}

TurntableFeatures small_features() {
  TurntableFeatures features;
  features.boards = {BoardSpec{1, 2, 0.02}, BoardSpec{2, 1, 0.02}};
  features.corners_px = {std::vector<Eigen::Vector2d>{{1, 2}, {3, 4}},
                         std::vector<Eigen::Vector2d>{{5, 6}, {7.25, 8}}};
  for (int k = 0; k < 3; ++k) {
    TurntablePosition position;
    position.stripe_px[0] = {{0.1 * k, 1}};
    position.scan = {{0, 1.0 + k, std::nan("")}, {0.1, std::nan(""), std::nan("")}};
    features.positions.push_back(position);
  }
  return features;
}

TEST(FeaturesJson, WhatIsWrittenReadsBack) {
  const auto features = small_features();
  TurntableFeatures again = features;
  again.corners_px = {};
  for (auto& position : again.positions) position = {};
  const auto read = parse_features(features_text(features), "features.json", again);
  ASSERT_TRUE(read) << read.error().message;
  EXPECT_EQ(again.corners_px, features.corners_px);
  EXPECT_EQ(again.positions[2].stripe_px[0], features.positions[2].stripe_px[0]);
  EXPECT_DOUBLE_EQ(again.positions[2].scan[0].range_m, 3);
  EXPECT_TRUE(std::isnan(again.positions[2].scan[1].range_m));
}

TEST(FeaturesJson, FaultsNameTheirPlace) {
  auto features = small_features();
  const auto text = features_text(features);
  const auto fault = [&](const std::string& bad) {
    auto into = features;
    const auto read = parse_features(bad, "features.json", into);
    EXPECT_FALSE(read);
    return read ? "" : read.error().message;
  };
  EXPECT_THAT(fault(text.substr(0, text.size() / 2)), HasSubstr("features.json: byte"));
  EXPECT_THAT(fault(replaced(text, "\"range_m\":[2,null]", "\"range_m\":[2]")),
              AllOf(HasSubstr("positions[1].scan"), HasSubstr("2 angles, 1 ranges")));
  features.boards[0].rows = 7;
  EXPECT_THAT(fault(text), HasSubstr("session.toml says 7 rows"));
  features = small_features();
  features.positions.resize(2);
  EXPECT_THAT(fault(text), HasSubstr("3 positions; session.toml gives 2"));
}

RigFile some_rig() {
  RigFile file;
  file.rig.axis_direction = Eigen::Vector3d(0.1, -1, 0.2).normalized();
  const Eigen::Vector3d p(0.3, 0.1, 0.6);
  file.rig.axis_point_m = p - file.rig.axis_direction * file.rig.axis_direction.dot(p);
  file.rig.camera_from_lidar = {
      Eigen::Quaterniond(Eigen::AngleAxisd(1.1, Eigen::Vector3d(1, 2, 3).normalized())),
      {0.1, 0.2, 0.3}};
  file.rig.range_bias_m = 0.0012;
  file.rig.covariance.diagonal().setConstant(1e-8);
  file.rig.covariance(0, 5) = file.rig.covariance(5, 0) = 3e-9;
  file.rig.last_turntable_rad = 0.37;
  return file;
}

TEST(RigToml, WhatIsWrittenReadsBack) {
  const auto file = some_rig();
  const auto again = parse_rig(rig_text(file), "rig.toml");
  ASSERT_TRUE(again) << again.error().message;
  EXPECT_LT((again->rig.axis_direction - file.rig.axis_direction).norm(), 1e-15);
  EXPECT_LT((again->rig.axis_point_m - file.rig.axis_point_m).norm(), 1e-15);
  EXPECT_LT(
      again->rig.camera_from_lidar.rotation.angularDistance(file.rig.camera_from_lidar.rotation),
      1e-14);
  EXPECT_EQ(again->rig.covariance, file.rig.covariance);
  EXPECT_FALSE(again->camera);
}

TEST(RigToml, FaultsAreSaid) {
  const auto text = rig_text(some_rig());
  const auto fault = [](const std::string& bad) {
    const auto read = parse_rig(bad, "rig.toml");
    EXPECT_FALSE(read);
    return read ? "" : read.error().message;
  };
  EXPECT_THAT(fault(""), HasSubstr("a rig needs [axis]"));
  EXPECT_THAT(fault(replaced(text, "direction = [", "direction = [1")), HasSubstr("length 1"));
  EXPECT_THAT(fault(replaced(text, "rotation = [[", "rotation = [[4")), HasSubstr("orthogonal"));
  auto unlikely = some_rig();
  unlikely.rig.covariance(3, 3) = -1;
  EXPECT_THAT(fault(rig_text(unlikely)), HasSubstr("negative eigenvalue"));
}

TEST(SessionFolder, FilesAreFoundByTheirNumbers) {
  const TemporaryFolder folder;
  folder.write("session.toml", kSession);
  folder.write("board.png", "x");
  for (const char* name : {"stripe_0000.png", "stripe_2.jpg", "stripe_0002_off.png"}) {
    folder.write(name, "x");
  }
  folder.write("scan_0000.csv", "angle,range\n0,1000\n1,1000\n");
  folder.write("scan_0001.csv", "angle,reach\n0,1000\n");
  const auto session = open_session(folder.path());
  ASSERT_TRUE(session) << session.error().message;
  EXPECT_FALSE(session->positions[0].stripe.empty());
  EXPECT_TRUE(session->positions[1].stripe.empty());
  EXPECT_FALSE(session->positions[2].stripe_off.empty());
  const auto content = read_session_content(*session);
  ASSERT_TRUE(content) << content.error().message;
  ASSERT_EQ(content->left_out.size(), 2u);
  EXPECT_THAT(content->left_out[0].reason, AllOf(HasSubstr("scan_0001.csv"), HasSubstr("range")));
  EXPECT_THAT(content->left_out[1].reason, HasSubstr("scan_0002.csv is missing"));
  folder.write("scan_0009.csv", "angle,range\n0,1000\n");
  const auto more = open_session(folder.path());
  ASSERT_FALSE(more);
  EXPECT_THAT(more.error().message, AllOf(HasSubstr("scan_0009.csv"), HasSubstr("gives 3")));
}

TEST(SessionFolder, OneRecordingHoldsAllScans) {
  const TemporaryFolder folder;
  folder.write("session.toml", std::string(kSession) + "recording = \"all.csv\"\n");
  folder.write("all.csv", "position,angle,range\n0,0,1000\n0,1,1001\n2,0,900\n");
  const auto session = open_session(folder.path());
  ASSERT_TRUE(session) << session.error().message;
  const auto content = read_session_content(*session);
  ASSERT_TRUE(content) << content.error().message;
  EXPECT_EQ(content->features.positions[0].scan.size(), 2u);
  EXPECT_NEAR(content->features.positions[2].scan[0].range_m, 0.9, 1e-12);
  EXPECT_EQ(content->left_out.size(), 1u);
}

TEST(SessionFolder, FolderWithoutSessionIsAnError) {
  const TemporaryFolder folder;
  const auto session = open_session(folder.path());
  ASSERT_FALSE(session);
  EXPECT_THAT(session.error().message, HasSubstr("session.toml"));
}

}  // namespace
}  // namespace scanfuse::io
