#include "scanfuse/io/passive/passive.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "scanfuse/simulate/passive.hpp"

namespace scanfuse::io {
namespace {

using ::testing::HasSubstr;

const std::string kTwo =
    "[[sensor]]\nname = \"a\"\nposition_m = [0, 0, 0]\nsigma_azimuth_rad = 0.005\n"
    "sigma_elevation_rad = 0.004\n"
    "[[sensor]]\nname = \"b\"\nposition_m = [100, 0, 0]\nsigma_azimuth_rad = 0.01\n";

std::string message(const std::string& text) {
  const auto scene = parse_sensors(text, "s.toml");
  return scene ? "no error" : scene.error().message;
}

std::filesystem::path temporary(const std::string& name, const std::string& text = "") {
  const auto path = std::filesystem::path(::testing::TempDir()) / name;
  if (!text.empty()) std::ofstream(path) << text;
  return path;
}

TEST(Sensors, ReadWhatTheyTellAndWhatTheyDoNot) {
  const auto scene =
      parse_sensors(kTwo +
                        "clutter_per_rad = 0.5\norientation_rad = [1.5, 0, 0]\n[scene]\n"
                        "volume_m = [[0, 1], [-2, 2], [0, 9]]\nexpected_targets = 3\n",
                    "s.toml");
  ASSERT_TRUE(scene) << scene.error().message;
  EXPECT_TRUE(scene->sensors[0].tells_elevation());
  EXPECT_FALSE(scene->sensors[1].tells_elevation());
  EXPECT_EQ(scene->sensors[1].clutter_density, 0.5);
  EXPECT_NEAR(scene->sensors[1].world_from_sensor.planar().heading_rad, 1.5, 1e-12);
  EXPECT_EQ((*scene->volume_m)[1][0], -2);
  EXPECT_EQ(scene->expected_targets, 3);
}

TEST(Sensors, StandWhereLatitudeAndLongitudePutThem) {
  const auto scene = parse_sensors(
      "[[sensor]]\nname = \"a\"\nlatitude_deg = 48\nlongitude_deg = 11\nheight_m = 500\n"
      "sigma_azimuth_rad = 0.01\n"
      "[[sensor]]\nname = \"b\"\nlatitude_deg = 48.1\nlongitude_deg = 11\nheight_m = 500\n"
      "sigma_azimuth_rad = 0.01\n",
      "s.toml");
  ASSERT_TRUE(scene) << scene.error().message;
  const auto& b = scene->sensors[1].world_from_sensor.translation_m;
  // One degree of latitude is 111.20 km at 48 degrees on WGS 84; 11 km away the ground is 9.7 m
  // lower than the tangent plane.
  EXPECT_NEAR(b.y(), 11120, 3);
  EXPECT_NEAR(b.x(), 0, 1e-6);
  EXPECT_NEAR(b.z(), -9.7, 0.1);
}

TEST(Sensors, WrongFilesNameTheLineAndWhatToDo) {
  EXPECT_THAT(message(kTwo + "sigma_azimut_rad = 1\n"), HasSubstr("s.toml:10:20: unknown key"));
  EXPECT_THAT(message(kTwo + "sigma_azimut_rad = 1\n"), HasSubstr("'sigma_azimuth_rad'?"));
  EXPECT_THAT(message(kTwo + "clutter_per_sr = 1\n"), HasSubstr("clutter_per_rad"));
  EXPECT_THAT(message(kTwo + "clutter_per_rad = -1\n"), HasSubstr("from 0"));
  EXPECT_THAT(message(kTwo + "detection_probability = 1.5\n"), HasSubstr("from 0 to 1"));
  EXPECT_THAT(message(kTwo + "orientation_rad = [1, 2]\n"), HasSubstr("3 numbers"));
  EXPECT_THAT(message(kTwo + "latitude_deg = 3\n"), HasSubstr("not both"));
  EXPECT_THAT(message(kTwo.substr(0, kTwo.rfind("[["))), HasSubstr("1 [[sensor]]"));
  EXPECT_THAT(message(kTwo + kTwo), HasSubstr("twice"));
  EXPECT_THAT(message(kTwo + "[scene]\nvolume_m = [[1, 0], [0, 1], [0, 1]]\n"),
              HasSubstr("ascending"));
  EXPECT_THAT(message("[[sensor]]\nname = \"a\"\n"), HasSubstr("position_m"));
  EXPECT_THAT(message("sensor = 3\n"), HasSubstr("0 [[sensor]]"));
  EXPECT_THAT(message("[[sensor]\n"), HasSubstr("s.toml:1:"));
  std::string one_place = kTwo;
  one_place.replace(one_place.find("100"), 3, "0");
  EXPECT_THAT(message(one_place), HasSubstr("one place"));
}

TEST(Bearings, ComeBackAsTheyWereWritten) {
  simulate::PassiveOptions options;
  options.scans = 3;
  options.false_alarms = 2;
  const auto recording = simulate::simulate_passive(options, 5);
  const auto bearings = temporary("bearings.csv"), sensors = temporary("sensors.toml");
  ASSERT_TRUE(write_sensors(sensors, recording->scene));
  ASSERT_TRUE(write_bearings(bearings, recording->scans, recording->scene));
  const auto scene = read_sensors(sensors);
  ASSERT_TRUE(scene) << scene.error().message;
  Diagnostics diagnostics;
  const auto scans = read_bearings(bearings, *scene, &diagnostics);
  ASSERT_TRUE(scans) << scans.error().message;
  EXPECT_TRUE(diagnostics.empty());
  ASSERT_EQ(scans->size(), 3U);
  for (std::size_t k = 0; k < 3; ++k) {
    ASSERT_EQ((*scans)[k].bearings.size(), recording->scans[k].bearings.size());
    for (std::size_t i = 0; i < (*scans)[k].bearings.size(); ++i) {
      const Bearing &a = (*scans)[k].bearings[i], &b = recording->scans[k].bearings[i];
      EXPECT_EQ(a.azimuth_rad, b.azimuth_rad);
      EXPECT_EQ(a.elevation_rad, b.elevation_rad);
      EXPECT_EQ(a.measurement, b.measurement);
      EXPECT_EQ(a.truth, b.truth);
    }
  }
}

TEST(Bearings, BadRowsAreCountedAndTheRestIsKept) {
  const auto scene = parse_sensors(kTwo, "s.toml");
  const auto path = temporary("bad.csv",
                              "scan,time_s,sensor,measurement,azimuth_rad,elevation_rad\n"
                              "1,1.0,a,0,0.5,0.1\n"
                              "0,0.0,b,0,0.5,\n"       // before scan 1: sorted
                              "0,0.0,a,0,nan,0.1\n"    // no number
                              "0,0.0,a,1,0.5,2.0\n"    // no elevation
                              "0,0.0,a,2,90,0.1\n"     // degrees
                              "0,0.0,a,3,0.5,\n"       // elevation missing
                              "0,0.0,c,0,0.5,0.1\n"    // no such sensor
                              "1,1.0,a,0,0.6,0.1\n");  // given twice
  Diagnostics diagnostics;
  const auto scans = read_bearings(path, *scene, &diagnostics);
  ASSERT_TRUE(scans) << scans.error().message;
  ASSERT_EQ(scans->size(), 2U);
  EXPECT_EQ((*scans)[0].scan, 0);
  EXPECT_EQ((*scans)[0].bearings.size(), 1U);
  EXPECT_EQ((*scans)[1].bearings[0].azimuth_rad, 0.5);
  EXPECT_EQ(diagnostics.count("bad row skipped"), 5);
  EXPECT_EQ(diagnostics.count("measurement given twice, the first counts"), 1);
  EXPECT_EQ(diagnostics.count("scans out of order, sorted"), 1);
  EXPECT_TRUE(diagnostics.any_damage());
}

TEST(Fixes, HaveTheColumnsThatScriptsRelyOn) {
  EXPECT_EQ(fix_header(),
            "scan,time_s,target,x_m,y_m,z_m,cov_xx_m2,cov_xy_m2,cov_xz_m2,cov_yy_m2,cov_yz_m2,"
            "cov_zz_m2,existence_probability,chi2,sensors\n");
  const auto scene = parse_sensors(kTwo, "s.toml");
  BearingScan scan;
  scan.scan = 7;
  scan.bearings.resize(3);
  scan.bearings[1].sensor = 1;
  scan.bearings[2].measurement = 1;
  Fix fix;
  fix.target = 4;
  fix.bearings = {0, 1};
  EXPECT_EQ(fix_rows(scan, std::vector{fix}, *scene),
            "7,0.000000000,4,0,0,0,1,0,0,1,0,1,1,0,a+b\n");
  const std::vector<std::int64_t> targets{4, 4, -1};
  const std::vector<double> probabilities{1, 0.5, 0.25};
  EXPECT_EQ(assignment_header() + assignment_rows(scan, targets, probabilities, *scene),
            "scan,sensor,measurement,target,probability\n7,a,0,4,1\n7,b,0,4,0.5\n7,a,1,,0.25\n");
}

}  // namespace
}  // namespace scanfuse::io
