#include "scanfuse/preprocess/virtual_scan_builder.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "scanfuse/core/random.hpp"

namespace scanfuse::preprocess {
namespace {

Return return_at(double range, double bearing, double z, int beam = -1, int layer = 0) {
  Return r;
  r.x_m = static_cast<float>(range * std::cos(bearing));
  r.y_m = static_cast<float>(range * std::sin(bearing));
  r.z_m = static_cast<float>(z);
  r.beam = beam;
  r.layer = static_cast<std::int16_t>(layer);
  return r;
}

/// A wall `range` away over `columns` beams of 0.25 deg around x, seen by `layers` layers 0.8 deg
/// apart.
Scan wall(double range, int columns, int layers) {
  Scan scan;
  const double step = radians(0.25), first = -step * (columns - 1) / 2;
  scan.beams = BeamPattern{first, step, columns, layers, 0.1, 200};
  for (int layer = 0; layer < layers; ++layer) {
    for (int c = 0; c < columns; ++c) {
      const double tilt = radians(0.8) * (layer - 0.5 * (layers - 1));
      scan.returns.push_back(return_at(range, first + c * step, range * std::tan(tilt), c, layer));
    }
  }
  return scan;
}

bool is_ordered(const VirtualScan& scan) {
  return std::ranges::is_sorted(scan.points, {}, &PlanarPoint::bearing_rad);
}

TEST(VirtualScanBuilder, KeepsOnePointOfEachBearingWithTheLayersThatAgree) {
  VirtualScanBuilder build;
  const Scan scan = wall(20, 440, 4);
  const VirtualScan& flat = build(scan);
  ASSERT_EQ(flat.points.size(), 440U);
  EXPECT_TRUE(is_ordered(flat));
  EXPECT_FALSE(flat.full_circle);
  for (std::size_t i = 0; i < flat.points.size(); ++i) {
    const PlanarPoint& p = flat.points[i];
    EXPECT_EQ(p.support, 4);
    EXPECT_NEAR(p.bearing_rad, std::atan2(p.y_m, p.x_m), 2e-6);
    EXPECT_EQ(p.column - flat.points[0].column, static_cast<int>(i));
    EXPECT_EQ(scan.returns[p.source].x_m, p.x_m);
  }
}

TEST(VirtualScanBuilder, APointKnowsTheHeightAndDepthOfWhatItStandsFor) {
  VirtualScanBuilder build;
  Scan scan = wall(20, 440, 4);
  const double lowest = scan.returns.front().z_m, highest = scan.returns.back().z_m;
  for (Return& r : scan.returns) {
    if (r.layer == 3) r = return_at(20.2, std::atan2(r.y_m, r.x_m), r.z_m, r.beam, r.layer);
  }
  for (const PlanarPoint& p : build(scan).points) {
    EXPECT_NEAR(p.z_low_m, lowest, 1e-4);
    EXPECT_NEAR(p.z_high_m, highest, 1e-4);
    EXPECT_NEAR(p.depth_m, 0.2, 1e-3);
  }
  for (const PlanarPoint& p : build(wall(20, 440, 1)).points) EXPECT_EQ(p.depth_m, 0);
}

TEST(VirtualScanBuilder, ALonelyReturnOfTheLowestLayerIsGround) {
  Scan scan = wall(40, 100, 4);
  for (int c = 0; c < 100; ++c) {
    const double bearing = scan.beams->first_azimuth_rad + c * scan.beams->step_rad;
    scan.returns[static_cast<std::size_t>(c)] = return_at(12, bearing, -0.5, c, 0);
  }
  VirtualScanBuilder build;
  for (const PlanarPoint& p : build(scan).points) EXPECT_NEAR(p.range_m, 40, 1e-3);
  EXPECT_EQ(build(scan).points.size(), 100U);
}

/// How many points stay of a row of `columns` returns 30 m away that only the second layer of four
/// sees, 0.3 m above the ground.
std::size_t kept_of_low_row(int columns) {
  Scan scan = wall(30, columns, 1);
  scan.beams->layers = 4;
  for (Return& r : scan.returns) {
    r.z_m = -0.3F;
    r.layer = 1;
  }
  Pose3 mounting;
  mounting.translation_m.z() = 0.6;
  VirtualScanBuilder build;
  return build(scan, mounting).points.size();
}

TEST(VirtualScanBuilder, ALowRowOfOneLayerIsAnObjectWhenItIsNoLongerThanOne) {
  EXPECT_EQ(kept_of_low_row(14), 14U) << "1.8 m, as wide as a car";
  EXPECT_EQ(kept_of_low_row(100), 0U) << "13 m of ground";
  EXPECT_EQ(kept_of_low_row(2), 0U) << "strays";
}

TEST(VirtualScanBuilder, ASupportedReturnGoesBeforeANearerLonelyOne) {
  Scan scan = wall(30, 60, 4);
  scan.returns.push_back(
      return_at(9, scan.beams->first_azimuth_rad + 20 * scan.beams->step_rad, 0.4, 20, 3));
  VirtualScanBuilder build;
  for (const PlanarPoint& p : build(scan).points) EXPECT_NEAR(p.range_m, 30, 1e-3);
}

TEST(VirtualScanBuilder, AReturnWithoutNeighbourIsDroppedAndAFarCarOfThreeIsKept) {
  Scan scan = wall(60, 3, 1);
  scan.beams->columns = 440;
  scan.returns.push_back(
      return_at(25, scan.beams->first_azimuth_rad + 200 * scan.beams->step_rad, 0, 200, 0));
  VirtualScanBuilder build;
  ASSERT_EQ(build(scan).points.size(), 3U);
  EXPECT_NEAR(build(scan).points[0].range_m, 60, 1e-3);
}

TEST(VirtualScanBuilder, TheMountingTurnsTheScanAndTheOrderStaysByBearing) {
  for (const double yaw : {0.0, 1.0, 3.0, kPi, -2.5}) {
    const Scan scan = wall(20, 440, 4);
    VirtualScanBuilder build;
    const VirtualScan& flat = build(scan, Pose3::from_planar({1, 0, yaw}, 0.55));
    ASSERT_EQ(flat.points.size(), 440U) << "yaw " << yaw;
    EXPECT_TRUE(is_ordered(flat));
    for (const PlanarPoint& p : flat.points) {
      EXPECT_LE(std::abs(wrap_pi(p.bearing_rad - yaw)), radians(55.1));
      EXPECT_GE(p.bearing_rad, -kPi - 1e-6);
      EXPECT_LE(p.bearing_rad, kPi + 1e-6);
    }
  }
}

TEST(VirtualScanBuilder, BeamNumbersThatLieDoNoHarm) {
  Scan honest = wall(20, 200, 4), lying = honest;
  RandomStream random(1);
  for (Return& r : lying.returns) r.beam = static_cast<std::int32_t>(random.below(1000)) - 300;
  VirtualScanBuilder build;
  const VirtualScan expected = build(honest);
  const VirtualScan& found = build(lying);
  ASSERT_EQ(found.points.size(), expected.points.size());
  for (std::size_t i = 0; i < found.points.size(); ++i) {
    EXPECT_NEAR(found.points[i].bearing_rad, expected.points[i].bearing_rad, 2e-5);
  }
}

TEST(VirtualScanBuilder, OddNumbersAreLeftOutAndNothingIsReadBeyondTheScan) {
  const float inf = std::numeric_limits<float>::infinity(), nan = std::nanf("");
  Scan scan = wall(20, 50, 2);
  for (const float odd : {inf, -inf, nan, 1e30F, 0.0F}) {
    Return r = return_at(10, 0, 0, 25, 1);
    r.x_m = odd;
    r.y_m = odd;
    scan.returns.push_back(r);
    r = return_at(10, 0, 0, 25, 1);
    r.z_m = odd == 0 ? nan : odd;
    scan.returns.push_back(r);
  }
  VirtualScanBuilder build;
  for (const PlanarPoint& p : build(scan).points) {
    EXPECT_TRUE(std::isfinite(p.bearing_rad) && std::isfinite(p.range_m));
  }
  scan.beams->step_rad = nan;
  EXPECT_TRUE(is_ordered(build(scan)));
  scan.beams = BeamPattern{nan, -1, -5, -7, 0, 0};
  EXPECT_TRUE(is_ordered(build(scan)));
  EXPECT_TRUE(build(Scan{}).points.empty());
}

TEST(VirtualScanBuilder, TheStepIsFoundInScansWithoutABeamPattern) {
  Scan scan = wall(10, 300, 1);
  scan.beams.reset();
  for (Return& r : scan.returns) r.beam = -1;
  VirtualScanBuilder build;
  EXPECT_NEAR(build(scan).step_rad, radians(0.25), 1e-4);
  EXPECT_EQ(build(scan).points.size(), 300U);
}

/// A spinning 64-layer sensor `height` above ground of slope `grade` along x, and a box 12 m ahead.
Scan street(double height, double grade) {
  Scan scan;
  for (int layer = 0; layer < 64; ++layer) {
    const double down = radians(-24.8 + layer * 26.8 / 63);
    for (int c = 0; c < 1200; ++c) {
      const double bearing = -kPi + c * 2 * kPi / 1200;
      const double fall = grade * std::cos(bearing) - std::tan(down);
      double range = fall > 0 ? height / fall : 1e9;
      const bool at_box = std::abs(std::tan(bearing) * 12) < 0.9 && std::abs(bearing) < 1;
      const double box_range = 12 / std::cos(bearing);
      const double box_z = box_range * std::tan(down) - (grade * 12 - height);
      if (at_box && box_range < range && box_z < 1.5 && box_z > 0.25) range = box_range;
      if (range > 80) continue;
      scan.returns.push_back(return_at(range, bearing, range * std::tan(down)));
    }
  }
  return scan;
}

TEST(VirtualScanBuilder, OnlyTheBoxIsLeftOfASlopingStreetWhoseSensorHeightIsUnknown) {
  for (const double grade : {0.0, 0.04, -0.04}) {
    VirtualScanBuilder build;
    const VirtualScan& flat = build(street(1.73, grade));
    EXPECT_GE(flat.points.size(), 20U) << "grade " << grade;
    EXPECT_TRUE(is_ordered(flat));
    EXPECT_TRUE(flat.full_circle);
    for (const PlanarPoint& p : flat.points) EXPECT_NEAR(p.x_m, 12, 0.1) << "grade " << grade;
  }
}

TEST(VirtualScanBuilder, AWallSeenOverACarIsKeptBehindIt) {
  Scan scan = street(1.73, 0);
  for (int c = 0; c < 40; ++c) {
    for (const double z : {-0.2, 0.1, 0.4}) {
      scan.returns.push_back(return_at(20, 0.003 * (c - 20), z));
    }
  }
  VirtualScanBuilder build;
  const auto& points = build(scan).points;
  EXPECT_GE(std::ranges::count_if(points, [](const auto& p) { return p.range_m > 19; }), 15);
  EXPECT_GE(std::ranges::count_if(points, [](const auto& p) { return p.range_m < 13; }), 20);
  EXPECT_TRUE(std::ranges::is_sorted(points, {}, &PlanarPoint::bearing_rad));
}

}  // namespace
}  // namespace scanfuse::preprocess
