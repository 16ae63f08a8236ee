#include "scanfuse/calibrate/lines.hpp"

#include "calibrate/rig_scene.hpp"
#include "scanfuse/core/random.hpp"

namespace scanfuse::calibrate {
namespace {

std::vector<BeamReturn> wall(double bias_m, double sigma_m, std::uint64_t seed) {
  RandomStream random(seed);
  std::vector<BeamReturn> returns;
  for (int i = 0; i < 180; ++i) {
    const double angle = -0.3 + 0.0015 * i;
    returns.push_back({angle, 0.9 / std::cos(angle - 0.5) + bias_m + random.normal(0, sigma_m)});
  }
  return returns;
}

TEST(FitReturns, FindsTheLineThatNoiseFreeReturnsLieOn) {
  const auto line = fit_returns(wall(0, 0, 1));
  ASSERT_TRUE(line);
  EXPECT_NEAR(line->distance_m, 0.9, 1e-9);
  EXPECT_NEAR(std::atan2(line->normal.y(), line->normal.x()), 0.5, 1e-9);
  EXPECT_LT(line->scatter_m2, 1e-16);
  EXPECT_EQ(line->rank, 3);
}

// What is kept of a line says the same of a model as all its returns do, bias included.
TEST(FitReturns, KeepsTheSumOfSquares) {
  const auto returns = wall(0.001, 0.001, 2);
  const auto line = fit_returns(returns);
  ASSERT_TRUE(line);
  const Eigen::Vector4d model(0.0007, -0.001, 0.001, 0);  // offset, slope, bias
  const double kept = (line->z - line->R * model).squaredNorm() + line->scatter_m2;
  const Eigen::Vector2d normal = (line->normal + 0.001 * line->along()).normalized();
  const double distance = normal.dot(line->centre_m + 0.0007 * line->normal);
  double all = 0;
  for (const auto& r : returns) {
    const Eigen::Vector2d ray(std::cos(r.angle_rad), std::sin(r.angle_rad));
    all += std::pow(r.range_m - 0.001 - distance / normal.dot(ray), 2);
  }
  EXPECT_NEAR(kept / all, 1, 1e-3);
}

TEST(FitReturns, RefusesTooFewAndLinesAlongARay) {
  EXPECT_FALSE(fit_returns(std::vector<BeamReturn>(3, {0, 1})));
  EXPECT_FALSE(fit_returns(std::vector<BeamReturn>{{0.1, 1}, {0.1, 2}, {0.1, 3}, {0.1, 4}}));
}

TEST(FitStripe, LeavesOutSpecklesAndKeepsTheNoise) {
  const Camera camera = simulate::turntable_world().camera;
  RandomStream random(5);
  std::vector<Eigen::Vector2d> points;
  for (int i = 0; i < 400; ++i) {
    // Straight in space, so curved in the raw image.
    const Eigen::Vector3d at(0.05 + 1e-4 * i, -0.2 + 0.001 * i, 1.2);
    points.emplace_back(camera.project(at) + Eigen::Vector2d(random.normal(0, 0.15), 0));
    if (i % 5 == 0) points.emplace_back(random.uniform(0, 1600), random.uniform(0, 1200));
  }
  points.emplace_back(std::numeric_limits<double>::quiet_NaN(), 3);
  const auto line = fit_stripe(camera, points);
  ASSERT_TRUE(line);
  EXPECT_GE(line->outliers, 70);
  EXPECT_GE(line->count, 395);
  EXPECT_NEAR(std::sqrt(line->scatter / (line->count - 2)), 0.15, 0.02);
  EXPECT_FALSE(fit_stripe(camera, std::vector<Eigen::Vector2d>(7)));
}

}  // namespace
}  // namespace scanfuse::calibrate
