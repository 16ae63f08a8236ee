#include "scanfuse/camera/calibrate_camera.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "scanfuse/core/random.hpp"

namespace scanfuse::camera {
namespace {

using Eigen::AngleAxisd;
using Eigen::Vector3d;

Camera truth() {
  Camera camera{.width_px = 1624, .height_px = 1234};
  camera.fx_px = 2757.4;
  camera.fy_px = 2758.6;
  camera.cx_px = 831.6;
  camera.cy_px = 638.9;
  camera.k1 = -0.076;
  camera.k2 = 0.371;
  return camera;
}

/// Views of a board, turned by up to `tilt_rad`, with noise in their corners.
std::vector<DetectedBoard> views(int count, double tilt_rad, double sigma_px, std::uint64_t seed) {
  RandomStream random(seed);
  std::vector<DetectedBoard> boards;
  while (static_cast<int>(boards.size()) < count) {
    DetectedBoard board;
    board.spec = {14, 20, 0.02};
    const Eigen::Quaterniond turn =
        AngleAxisd(random.uniform(-tilt_rad, tilt_rad), Vector3d::UnitX()) *
        AngleAxisd(random.uniform(-tilt_rad, tilt_rad), Vector3d::UnitY());
    const Pose3 pose{turn, {random.uniform(-0.28, -0.1), random.uniform(-0.2, -0.06), 1.2}};
    bool inside = true;
    for (int i = 0; i < 280; ++i) {
      const Vector3d at(i % 20 * 0.02, i / 20 * 0.02, 0);
      const Eigen::Vector2d noise(random.normal(0, sigma_px), random.normal(0, sigma_px));
      board.corners_px.emplace_back(truth().project(pose * at) + noise);
      const auto& p = board.corners_px.back();
      inside = inside && p.x() > 0 && p.y() > 0 && p.x() < 1623 && p.y() < 1233;
    }
    if (inside) boards.push_back(board);
  }
  return boards;
}

TEST(CalibrateCamera, ErrorsAreAsLargeAsTheCovarianceSays) {
  const auto result = calibrate_camera(views(12, 0.6, 0.07, 5), 1624, 1234);
  ASSERT_TRUE(result) << result.error().message;
  EXPECT_NEAR(result->rms_px, 0.07 * std::sqrt(2.0), 0.01);
  const Camera camera = truth();
  const double errors[] = {result->camera.fx_px - camera.fx_px, result->camera.fy_px - camera.fy_px,
                           result->camera.cx_px - camera.cx_px, result->camera.cy_px - camera.cy_px,
                           result->camera.k1 - camera.k1,       result->camera.k2 - camera.k2};
  for (int i = 0; i < 6; ++i) {
    const double sigma = std::sqrt(result->covariance(i, i));
    EXPECT_GT(sigma, 0);
    EXPECT_LT(std::abs(errors[i]), 4 * sigma) << i;
  }
  EXPECT_LT(std::sqrt(result->covariance(0, 0)), 5);
  EXPECT_EQ(result->covariance(6, 6), 0);
}

TEST(CalibrateCamera, AViewThatDoesNotFitIsLeftOut) {
  auto boards = views(9, 0.6, 0.05, 8);
  for (std::size_t i = 0; i < boards[4].corners_px.size(); i += 7) {
    boards[4].corners_px[i].x() += 6;
  }
  const auto result = calibrate_camera(boards, 1624, 1234);
  ASSERT_TRUE(result) << result.error().message;
  EXPECT_FALSE(result->views[4].used);
  EXPECT_TRUE(result->views[3].used);
  EXPECT_LT(result->rms_px, 0.1);
}

TEST(CalibrateCamera, TooFewViewsAreAnError) {
  EXPECT_FALSE(calibrate_camera(views(2, 0.6, 0.05, 1), 1624, 1234));
  EXPECT_FALSE(calibrate_camera({}, 1624, 1234));
}

TEST(CalibrateCamera, ViewsOutsideTheImageAreAnError) {
  EXPECT_FALSE(calibrate_camera(views(5, 0.6, 0.05, 1), 640, 480));
}

}  // namespace
}  // namespace scanfuse::camera
