#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "calibrate/analytic_lidar.hpp"
#include "scanfuse/calibrate/cloud/assemble.hpp"
#include "scanfuse/calibrate/cloud/axis_frame.hpp"
#include "scanfuse/calibrate/cloud/measure.hpp"

// Assembly and measures on scans in closed form (analytic_lidar.hpp).
namespace scanfuse::calibrate {
namespace {

using calibrate_testing::FlatThing;
using calibrate_testing::LidarModel;
using calibrate_testing::look_at;
using calibrate_testing::placed_disc;
using calibrate_testing::upright_rig;
using calibrate_testing::wall_at;

AssembledCloud assembled(const std::vector<FlatThing>& things, const LidarModel& model,
                         std::uint64_t seed, const AssembleOptions& options = {}) {
  auto made = assemble(look_at(things, upright_rig(), model, seed), upright_rig(), options);
  EXPECT_TRUE(made) << made.error().message;
  return made ? std::move(*made) : AssembledCloud{};
}

LidarModel exact_model() {
  LidarModel model;
  model.noise_m = model.turntable_noise_rad = 0;
  model.spot_rad = 1e-9;
  return model;
}

FlatThing rectangle(double half_x_m, double half_y_m, double z_m, double turn_rad = 0) {
  FlatThing thing;
  thing.half_m = {half_x_m, half_y_m};
  thing.camera_from_thing.translation_m = {0.2, 0.05, z_m};
  thing.camera_from_thing.rotation =
      Eigen::Quaterniond(Eigen::AngleAxisd(turn_rad, Eigen::Vector3d::UnitZ()));
  return thing;
}

// Without noise every point lies on the wall, to the 0.1 mm of the ranges.
TEST(Assemble, PointsOfAWallLieOnIt) {
  const auto made = assembled({wall_at(1.5)}, exact_model(), 1);
  ASSERT_GT(made.cloud.points.size(), 1000u);
  for (const auto& point : made.cloud.points) EXPECT_NEAR(point.position_m.z(), 1.5, 1e-4);
  EXPECT_EQ(made.mixed, 0);
}

// Distances between points are the same in both frames, and the axis is z in the axis frame.
TEST(Assemble, AxisFrameIsTheSameCloudMoved) {
  const Rig rig = upright_rig();
  const Pose3 move = axis_from_camera(rig);
  EXPECT_LT((move.rotation * rig.axis_direction - Eigen::Vector3d::UnitZ()).norm(), 1e-12);
  EXPECT_LT((move * rig.axis_point_m).head<2>().norm(), 1e-12);
  EXPECT_NEAR((move * rig.camera_from_lidar.translation_m).z(), 0, 1e-12);
  const auto camera = assembled({wall_at(1.5)}, LidarModel{}, 2);
  AssembleOptions options;
  options.frame = CloudFrame::kAxis;
  const auto axis = assembled({wall_at(1.5)}, LidarModel{}, 2, options);
  ASSERT_EQ(camera.cloud.points.size(), axis.cloud.points.size());
  for (std::size_t k = 0; k < axis.cloud.points.size(); k += 97) {
    EXPECT_LT((move * camera.cloud.points[k].position_m - axis.cloud.points[k].position_m).norm(),
              1e-9);
  }
}

TEST(Assemble, ReassemblyWithTheSameRigChangesNothing) {
  const auto made = assembled({wall_at(1.5)}, LidarModel{}, 3);
  const Cloud again = reassembled(made.cloud, upright_rig(), upright_rig());
  for (std::size_t k = 0; k < again.points.size(); k += 31) {
    EXPECT_LT((again.points[k].position_m - made.cloud.points[k].position_m).norm(), 1e-12);
  }
}

// A range bias of the rig is taken off: twice the bias makes points that much nearer.
TEST(Assemble, RangeBiasIsTakenOff) {
  Rig rig = upright_rig();
  rig.range_bias_m = 0.002;
  const auto scans = look_at({wall_at(1.5)}, rig, exact_model(), 4);
  const auto made = assemble(scans, rig);
  ASSERT_TRUE(made);
  for (const auto& point : made->cloud.points) EXPECT_NEAR(point.position_m.z(), 1.5, 1e-4);
}

TEST(Assemble, ScansWithoutReturnsAreAnError) {
  const auto scans = look_at({}, upright_rig(), LidarModel{}, 1);
  const auto made = assemble(scans, upright_rig());
  ASSERT_FALSE(made);
  EXPECT_THAT(made.error().message, ::testing::HasSubstr("no"));
}

// Of returns between a disc and a wall hardly any is left; of those on the disc hardly any is lost.
TEST(Mixed, ReturnsBetweenEdgeAndBackgroundAreFound) {
  const FlatThing disc = rectangle(0.08, 0.08, 1.2);
  AssembleOptions keep;
  keep.keep_mixed = true;
  const auto all = assembled({disc, wall_at(1.8)}, LidarModel{}, 5, keep);
  const auto clean = assembled({disc, wall_at(1.8)}, LidarModel{}, 5);
  const auto between = [](const Cloud& cloud) {
    return std::ranges::count_if(cloud.points, [](const CloudPoint& p) {
      return p.position_m.z() > 1.2 + 0.01 && p.position_m.z() < 1.8 - 0.01;
    });
  };
  const auto on = [](const Cloud& cloud) {
    return std::ranges::count_if(
        cloud.points, [](const CloudPoint& p) { return std::abs(p.position_m.z() - 1.2) < 0.004; });
  };
  ASSERT_GT(between(all.cloud), 50);
  EXPECT_LT(between(clean.cloud), between(all.cloud) / 10);
  EXPECT_GT(on(clean.cloud), on(all.cloud) * 98 / 100);
}

// A wall seen aslant, a corner and a thin post have no mixed returns.
TEST(Mixed, SlantsAndThinThingsAreKept) {
  FlatThing slant = wall_at(1.5);
  slant.camera_from_thing.rotation =
      Eigen::Quaterniond(Eigen::AngleAxisd(1.1, Eigen::Vector3d::UnitY()));
  LidarModel model = exact_model();
  model.noise_m = 0.001;
  const auto made = assembled({slant}, model, 6);
  EXPECT_LT(made.mixed, made.returns / 500);
  const FlatThing post = rectangle(0.004, 0.3, 1.2);
  const auto thin = assembled({post, wall_at(1.8)}, model, 7);
  EXPECT_LT(thin.mixed, thin.returns / 200);
}

struct DiscErrors {
  double bias_mm = 0, sd_mm = 0, nees = 0;
  double outermost_bias_mm = 0;
};

DiscErrors measure_discs(double wall_m, const LidarModel& model, int placements,
                         std::uint64_t seed) {
  DiscErrors errors;
  double squares = 0;
  for (int k = 0; k < placements; ++k) {
    std::vector<FlatThing> things{placed_disc(seed + static_cast<std::uint64_t>(k))};
    if (wall_m > 0) things.push_back(wall_at(wall_m));
    const auto made = assembled(things, model, seed + 100 + static_cast<std::uint64_t>(k));
    const auto disc = measure_disc(made.cloud, {}, {}, std::nullopt);
    EXPECT_TRUE(disc) << disc.error().message;
    if (!disc) return errors;
    const double error = (disc->diameter_m.value - 0.14) * 1e3;
    errors.bias_mm += error / placements;
    errors.outermost_bias_mm += (disc->outermost_diameter_m - 0.14) * 1e3 / placements;
    squares += error * error;
    errors.nees += std::pow(error / (disc->diameter_m.sigma() * 1e3), 2) / placements;
  }
  errors.sd_mm = std::sqrt(std::max(squares / placements - errors.bias_mm * errors.bias_mm, 0.0));
  return errors;
}

// [Liu2023, Table 2]: ten placements of a disc of 140 mm at about 1.5 m; the paper's bias of -1.5
// and spread of 2.9 mm are those of the outermost points.
TEST(MeasureDisc, TenPlacementsBeforeAWall) {
  const auto errors = measure_discs(2.0, LidarModel{}, 10, 40);
  EXPECT_LT(std::abs(errors.bias_mm), 0.3);
  EXPECT_LT(errors.sd_mm, 0.3);
  EXPECT_LT(errors.nees, 3);
  EXPECT_LT(errors.outermost_bias_mm, -1.0);
}

TEST(MeasureDisc, TenPlacementsWithNothingBehind) {
  const auto errors = measure_discs(0, LidarModel{}, 10, 60);
  EXPECT_LT(std::abs(errors.bias_mm), 0.3);
  EXPECT_LT(errors.sd_mm, 0.3);
  EXPECT_LT(errors.outermost_bias_mm, -1.0);
}

TEST(MeasureDisc, AWideSpotBeforeANearWall) {
  LidarModel model;
  model.spot_rad = 0.0025;
  const auto errors = measure_discs(1.4, model, 6, 80);
  EXPECT_LT(std::abs(errors.bias_mm), 0.3);
  EXPECT_LT(errors.sd_mm, 0.3);
}

// An uncertain range bias scales what is measured: 1 % of the range, 1 % of the diameter.
TEST(MeasureDisc, RigUncertaintyIsCarriedOver) {
  Rig rig = upright_rig();
  rig.covariance(10, 10) = 0.015 * 0.015;
  const auto made = assembled({placed_disc(3), wall_at(2.0)}, LidarModel{}, 9);
  const auto disc = measure_disc(made.cloud, {}, {}, rig);
  ASSERT_TRUE(disc) << disc.error().message;
  EXPECT_NEAR(disc->diameter_m.sigma_rig, 0.14 * 0.01, 0.14 * 0.002);
}

// The same cloud without profiles is measured by area, more coarsely.
TEST(MeasureDisc, CloudFromElsewhereIsMeasuredByArea) {
  auto made = assembled({placed_disc(5)}, LidarModel{}, 11);
  made.cloud.profiles.clear();
  for (auto& point : made.cloud.points) point.profile = point.beam = -1;
  const auto disc = measure_disc(made.cloud, {}, {}, std::nullopt);
  ASSERT_TRUE(disc) << disc.error().message;
  EXPECT_TRUE(disc->by_area);
  EXPECT_NEAR(disc->diameter_m.value, 0.14, 0.003);
  EXPECT_FALSE(measure_disc(made.cloud, {}, {}, upright_rig()));
}

TEST(MeasureDisc, WallWithoutDiscIsAnError) {
  const auto made = assembled({wall_at(1.5)}, LidarModel{}, 12);
  const auto disc = measure_disc(made.cloud, {}, {}, std::nullopt);
  ASSERT_FALSE(disc);
  EXPECT_THAT(disc.error().message, ::testing::HasSubstr("--crop"));
  EXPECT_FALSE(measure_disc(Cloud{}, {}, {}, std::nullopt));
}

TEST(MeasurePlane, DistanceAndItsUncertainty) {
  int inside = 0;
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const auto made = assembled({wall_at(1.5)}, LidarModel{}, 200 + seed);
    const auto plane = measure_plane(made.cloud, {}, {}, std::nullopt);
    ASSERT_TRUE(plane) << plane.error().message;
    EXPECT_NEAR(plane->distance_m.value, 1.5, 1e-3);
    EXPECT_NEAR(plane->rms_m, 1e-3, 2e-4);
    inside += std::abs(plane->distance_m.value - 1.5) < 2.5 * plane->distance_m.sigma() ? 1 : 0;
  }
  EXPECT_GE(inside, 16);
}

TEST(MeasureDistance, BetweenTwoSheets) {
  const auto made = assembled({rectangle(0.06, 0.2, 1.3), wall_at(1.6)}, LidarModel{}, 21);
  CropBox near, far;
  near.high_m.z() = 1.45;
  far.low_m.z() = 1.55;
  const auto distance = measure_distance(made.cloud, far, near, {}, std::nullopt);
  ASSERT_TRUE(distance) << distance.error().message;
  EXPECT_NEAR(distance->perpendicular_m.value, 0.3, 5e-4);
  EXPECT_GT(distance->perpendicular_m.sigma(), 0);
}

TEST(MeasureSize, SidesOfATurnedRectangle) {
  const auto made = assembled({rectangle(0.1, 0.06, 1.2, 0.3), wall_at(2.0)}, LidarModel{}, 22);
  CropBox box;
  box.high_m.z() = 1.3;
  const auto size = measure_size(made.cloud, box, {}, std::nullopt);
  ASSERT_TRUE(size) << size.error().message;
  EXPECT_NEAR(size->length_m.value, 0.2, 1.5e-3);
  EXPECT_NEAR(size->width_m.value, 0.12, 1.5e-3);
}

}  // namespace
}  // namespace scanfuse::calibrate
