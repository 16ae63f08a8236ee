#include "scanfuse/simulate/turntable_images.hpp"

#include <gtest/gtest.h>

#include "scanfuse/simulate/turntable_scans.hpp"

namespace scanfuse::simulate {
namespace {

/// The rig of the paper seen by a small camera: quick.
TurntableWorld small_world(int positions = 3) {
  TurntableWorldOptions options;
  options.positions = positions;
  TurntableWorld world = turntable_world(options);
  Camera& camera = world.camera;
  camera.width_px /= 4;
  camera.height_px /= 4;
  for (double* value : {&camera.fx_px, &camera.fy_px, &camera.cx_px, &camera.cy_px}) *value /= 4;
  return world;
}

TEST(RayOfPixel, UndoesProjection) {
  const Camera camera = turntable_world().camera;
  for (double u = 0; u < camera.width_px; u += 101) {
    for (double v = 0; v < camera.height_px; v += 97) {
      EXPECT_LT((camera.project(ray_of_pixel(camera, {u, v})) - Eigen::Vector2d(u, v)).norm(),
                1e-9);
    }
  }
}

TEST(RenderSessionImages, AnyNumberOfThreadsGivesTheSameBytes) {
  const TurntableWorld world = small_world();
  const SessionImages one = render_session_images(world, {}, 5, true, {}, 1);
  const SessionImages four = render_session_images(world, {}, 5, true, {}, 4);
  EXPECT_EQ(one.bright.pixels, four.bright.pixels);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(one.stripes[i].pixels, four.stripes[i].pixels);
    EXPECT_EQ(one.laser_off[i].pixels, four.laser_off[i].pixels);
  }
  EXPECT_NE(one.bright.pixels, render_session_images(world, {}, 6).bright.pixels);
}

TEST(RenderSessionImages, TheLaserOnlyAddsLightAndOnlyInAStripe) {
  const TurntableWorld world = small_world();
  TurntableImageOptions options;
  options.read_noise_counts = 0;
  options.electrons_per_count = 10000;
  const TurntableRenderer renderer(world, options, 1);
  const Image on = renderer.stripe(0, 0), off = renderer.laser_off(0);
  int lit = 0;
  for (std::size_t i = 0; i < on.pixels.size(); ++i) {
    EXPECT_GE(on.pixels[i] + 1, off.pixels[i]);
    lit += on.pixels[i] > off.pixels[i] + 10 ? 1 : 0;
  }
  EXPECT_GT(lit, 200);
  EXPECT_LT(lit, 5000);
}

TEST(RenderSessionImages, ARedLaserLightsRedPixelsOfAMosaic) {
  const TurntableWorld world = small_world();
  TurntableImageOptions options;
  options.sensor = Sensor::kRggb;
  const TurntableRenderer renderer(world, options, 1);
  const Image on = renderer.stripe(0, 0), off = renderer.laser_off(0);
  double red = 0, rest = 0;
  for (int r = 0; r < on.height_px; ++r) {
    for (int c = 0; c < on.width_px; ++c) {
      (r % 2 == 0 && c % 2 == 0 ? red : rest) += on.at(c, r) - off.at(c, r);
    }
  }
  EXPECT_GT(red, 4 * rest);
}

TEST(SimulateScans, RangesAreThoseOfTheBoardsAndTheSameForAnyThreads) {
  TurntableWorld world = small_world();
  TurntableScanOptions options;
  options.range_noise_m = 0;
  options.range_step_m = 0;
  options.spot_rays = 1;
  const auto scans = simulate_scans(world, options, 4, {}, 1);
  const auto again = simulate_scans(world, options, 4, {}, 3);
  ASSERT_EQ(scans.size(), 3U);
  const TurntableScene scene(world);
  int on_boards = 0;
  for (std::size_t k = 0; k < scans[1].size(); ++k) {
    const BeamReturn& beam = scans[1][k];
    const Pose3 lidar = world.rig.pose(world.turntable_rad[1]);
    const Eigen::Vector3d ray =
        lidar.rotation * Eigen::Vector3d(std::cos(beam.angle_rad), std::sin(beam.angle_rad), 0);
    const auto hit = scene.cast(lidar.translation_m, ray);
    if (hit.surface < 0) continue;
    EXPECT_NEAR(beam.range_m, hit.distance_m, 1e-9);
    EXPECT_EQ(beam.range_m, again[1][k].range_m);
    on_boards += hit.surface < 2 ? 1 : 0;
  }
  EXPECT_GT(on_boards, 100);
}

TEST(SimulateScans, NoiseAndStepAreAsAsked) {
  const TurntableWorld world = small_world();
  TurntableScanOptions exact;
  exact.range_noise_m = 0;
  exact.range_step_m = 0;
  TurntableScanOptions options;
  const auto truth = simulate_scans(world, exact, 4), noisy = simulate_scans(world, options, 4);
  double sum = 0, count = 0;
  for (std::size_t i = 0; i < truth.size(); ++i) {
    for (std::size_t k = 0; k < truth[i].size(); ++k) {
      const double range = noisy[i][k].range_m;
      if (std::isnan(range)) continue;
      EXPECT_NEAR(range / 0.0001, std::round(range / 0.0001), 1e-6);
      sum += std::pow(range - truth[i][k].range_m, 2);
      count += 1;
    }
  }
  EXPECT_NEAR(std::sqrt(sum / count), 0.001, 0.0001);
}

TEST(SimulateDiscSweeps, EverySweepClearsTheDiscAndMixesAtItsEdge) {
  const TurntableWorld world = turntable_world();
  TurntableScanOptions options;
  options.spot_rays = 5;
  options.resolved_m = 0.5;
  const auto sweeps = simulate_disc_sweeps(world, options, 2, 9);
  ASSERT_EQ(sweeps.size(), 2U);
  for (const auto& sweep : sweeps) {
    ASSERT_GT(sweep.scans.size(), 80U);
    int on_disc = 0, mixed = 0;
    double widest = 0;
    for (std::size_t i = 0; i < sweep.scans.size(); ++i) {
      int here = 0;
      for (const BeamReturn& beam : sweep.scans[i]) {
        if (std::isnan(beam.range_m)) continue;
        const Eigen::Vector3d p = world.rig.pose(sweep.turntable_rad[i]) *
                                  Eigen::Vector3d(beam.range_m * std::cos(beam.angle_rad),
                                                  beam.range_m * std::sin(beam.angle_rad), 0);
        const Eigen::Vector3d at = sweep.disc.camera_from_disc.inverse() * p;
        const bool near_plane = std::abs(at.z()) < 0.006 && at.head<2>().norm() < 0.08;
        here += near_plane ? 1 : 0;
        if (near_plane) widest = std::max(widest, at.head<2>().norm());
        mixed += at.z() < -0.02 && at.z() > -0.12 && at.head<2>().norm() < 0.09 ? 1 : 0;
      }
      on_disc += here;
      if (i == 0 || i + 1 == sweep.scans.size()) {
        EXPECT_EQ(here, 0);
      }
    }
    EXPECT_GT(on_disc, 2000);
    EXPECT_NEAR(widest, 0.07, 0.003);
    EXPECT_GT(mixed, 5);
  }
}

}  // namespace
}  // namespace scanfuse::simulate
