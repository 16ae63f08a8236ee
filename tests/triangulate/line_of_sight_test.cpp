#include "scanfuse/triangulate/line_of_sight.hpp"

#include <gtest/gtest.h>

#include "triangulate/scene_of_three.hpp"

namespace scanfuse::triangulate {
namespace {

using testing::sensor_at;

TEST(LineOfSight, PointsWhereTheBearingWasMeasured) {
  PassiveSensor sensor = sensor_at({1, 2, 3});
  sensor.world_from_sensor.rotation =
      Eigen::AngleAxisd(0.7, Eigen::Vector3d(1, 2, -1).normalized());
  const Eigen::Vector3d point(-4, 9, 12);
  const Direction d = direction_to(sensor, point);
  Bearing bearing;
  bearing.azimuth_rad = d.azimuth_rad;
  bearing.elevation_rad = d.elevation_rad;
  const LineOfSight line = line_of_sight(sensor, bearing);
  EXPECT_NEAR((line.direction - (point - line.origin_m).normalized()).norm(), 0, 1e-12);
  EXPECT_NEAR(sight(line, point)->offset_rad.norm(), 0, 1e-12);
}

TEST(LineOfSight, OffsetIsTheErrorOfTheAnglesNearTheHorizonAndAcrossTheSeam) {
  const PassiveSensor sensor = sensor_at({0, 0, 0});
  Bearing bearing;
  bearing.azimuth_rad = kPi - 0.001;
  const double azimuth = -kPi + 0.002, elevation = 0.004;  // 3 mrad on, over the seam
  const Eigen::Vector3d point =
      100 * Eigen::Vector3d(std::cos(azimuth) * std::cos(elevation),
                            std::sin(azimuth) * std::cos(elevation), std::sin(elevation));
  const auto seen = sight(line_of_sight(sensor, bearing), point);
  ASSERT_TRUE(seen);
  EXPECT_NEAR(seen->offset_rad.x(), 0.003, 1e-6);
  EXPECT_NEAR(seen->offset_rad.y(), 0.004, 1e-6);
}

// At the zenith azimuth turns by any angle for the least step; the tangent plane does not.
TEST(LineOfSight, StaysSmoothAtTheZenith) {
  const PassiveSensor sensor = sensor_at({0, 0, 0}, 0.001);
  Bearing bearing;
  bearing.azimuth_rad = 2;
  bearing.elevation_rad = kPi / 2 - 1e-4;
  const LineOfSight line = line_of_sight(sensor, bearing);
  EXPECT_GT(line.sigma_left_rad, 0);
  const auto over = sight(line, {0.1, 0, 1000}), under = sight(line, {-0.1, 0, 1000});
  ASSERT_TRUE(over && under);
  EXPECT_LT((over->offset_rad - under->offset_rad).norm(), 3e-4);
}

TEST(LineOfSight, SeesNothingBehindItOrAtItsOrigin) {
  const PassiveSensor sensor = sensor_at({0, 0, 0});
  const LineOfSight line = line_of_sight(sensor, Bearing{});
  EXPECT_FALSE(sight(line, {-5, 0, 0}));
  EXPECT_FALSE(sight(line, {0, 0, 0}));
}

TEST(LineOfSight, DerivativesAgreeWithDifferences) {
  for (const bool elevation : {true, false}) {
    PassiveSensor sensor = sensor_at({3, -2, 1});
    sensor.world_from_sensor.rotation = Eigen::AngleAxisd(0.3, Eigen::Vector3d::UnitX());
    if (!elevation) sensor.sigma_elevation_rad.reset();
    Bearing bearing;
    bearing.azimuth_rad = 0.4;
    bearing.elevation_rad = 0.2;
    const LineOfSight line = line_of_sight(sensor, bearing);
    const Eigen::Vector3d point = line.origin_m + 50 * line.direction + 4 * line.left - line.up;
    const auto seen = sight(line, point);
    const Direction direction = direction_to(sensor, point);
    for (int k = 0; k < 3; ++k) {
      const Eigen::Vector3d step = 1e-4 * Eigen::Vector3d::Unit(k);
      const Eigen::Vector2d slope =
          (sight(line, point + step)->offset_rad - sight(line, point - step)->offset_rad) / 2e-4;
      EXPECT_NEAR((slope - seen->jacobian_rad_per_m.col(k)).norm(), 0, 1e-9);
      const Direction a = direction_to(sensor, point + step),
                      b = direction_to(sensor, point - step);
      EXPECT_NEAR((a.azimuth_rad - b.azimuth_rad) / 2e-4, direction.jacobian_rad_per_m(0, k), 1e-9);
      EXPECT_NEAR((a.elevation_rad - b.elevation_rad) / 2e-4, direction.jacobian_rad_per_m(1, k),
                  1e-9);
    }
  }
}

TEST(FieldOfView, IsCentredOnTheSensorsAxis) {
  PassiveSensor sensor = sensor_at({0, 0, 0});
  sensor.field_of_view_azimuth_rad = sensor.field_of_view_elevation_rad = radians(60);
  EXPECT_TRUE(in_field_of_view(sensor, {10, 5, 0}));
  EXPECT_FALSE(in_field_of_view(sensor, {10, 6, 0}));
  EXPECT_FALSE(in_field_of_view(sensor, {10, 0, -6}));
  EXPECT_NEAR(sensor.field_of_view(), radians(60) * 1.0, 1e-12);  // 2 sin 30 deg
}

}  // namespace
}  // namespace scanfuse::triangulate
