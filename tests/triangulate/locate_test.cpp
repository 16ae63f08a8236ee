#include "scanfuse/triangulate/locate.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>

#include "scanfuse/estimate/consistency.hpp"
#include "triangulate/scene_of_three.hpp"

namespace scanfuse::triangulate {
namespace {

using testing::bearings_to;
using testing::lines_of;
using testing::scene_of_three;

const Eigen::Vector3d kAimedAt(20e3, 20e3, 8e3);

TEST(Locate, MeetsThePointThatNoiseFreeLinesPassThrough) {
  const PassiveScene scene = scene_of_three();
  const auto lines = lines_of(scene, bearings_to(scene, kAimedAt));
  EXPECT_NEAR((least_squares(lines) - kAimedAt).norm(), 0, 1e-6);
  const auto at = most_likely(lines);
  ASSERT_TRUE(at);
  EXPECT_TRUE(at->converged);
  EXPECT_NEAR((at->position_m - kAimedAt).norm(), 0, 1e-6);
  EXPECT_NEAR(at->chi2, 0, 1e-12);
}

struct Consistency {
  double rmse_m = 0;
  double bound_m = 0;  ///< root of the mean trace of the covariances told
  double nees = 0;
};

/// What `locate` does over many measurements of one target.
template <class Locate>
Consistency consistency(const PassiveScene& scene, const Eigen::Vector3d& target, int runs,
                        Locate&& locate) {
  Consistency sum;
  for (int k = 0; k < runs; ++k) {
    const auto bearings = bearings_to(scene, target, 1, static_cast<std::uint64_t>(k) + 1);
    const auto [position, covariance] = locate(lines_of(scene, bearings));
    const Eigen::Vector3d error = position - target;
    sum.rmse_m += error.squaredNorm() / runs;
    sum.bound_m += covariance.trace() / runs;
    sum.nees += error.dot(covariance.inverse() * error) / runs;
  }
  sum.rmse_m = std::sqrt(sum.rmse_m);
  sum.bound_m = std::sqrt(sum.bound_m);
  return sum;
}

std::pair<Eigen::Vector3d, Eigen::Matrix3d> by_likelihood(const std::vector<LineOfSight>& lines) {
  const auto at = most_likely(lines);
  return {at->position_m, at->covariance_m2};
}

TEST(Locate, MostLikelyIsAtTheCramerRaoBoundWhereverTheOriginIs) {
  for (const double far : {0.0, 10e3, 100e3}) {
    const Eigen::Vector3d origin(far, -far, 0);
    const auto seen = consistency(scene_of_three(origin), origin + kAimedAt, 4000, by_likelihood);
    EXPECT_NEAR(seen.rmse_m / seen.bound_m, 1, 0.02) << far;
    EXPECT_TRUE(estimate::mean_chi_square_band(4000, 3, 0.99).contains(seen.nees)) << seen.nees;
  }
}

TEST(Locate, MostLikelyWeighsUnequalSensors) {
  PassiveScene scene = scene_of_three();
  for (std::size_t s = 0; s < 3; ++s) {
    scene.sensors[s].sigma_azimuth_rad =
        *(scene.sensors[s].sigma_elevation_rad = std::array{0.001, 0.005, 0.02}[s]);
  }
  const auto best = consistency(scene, kAimedAt, 3000, by_likelihood);
  const auto plain = consistency(scene, kAimedAt, 3000, [](const auto& lines) {
    const Eigen::Vector3d x = least_squares(lines);
    return std::pair(x, covariance_corrected(lines, x));
  });
  EXPECT_NEAR(best.rmse_m / best.bound_m, 1, 0.03);
  EXPECT_GT(plain.rmse_m, 2 * best.rmse_m);
}

// [Lu2015, eq. 13] as printed depends on where coordinates start; corrected it does not.
TEST(Locate, LiteralCovarianceMovesWithTheOriginAndTheCorrectedOneDoesNot) {
  const auto nees = [](double far, bool literal) {
    const Eigen::Vector3d origin(far, far, 0);
    return consistency(scene_of_three(origin), origin + kAimedAt, 2000,
                       [&](const auto& lines) {
                         const Eigen::Vector3d x = least_squares(lines);
                         return std::pair(x, literal ? covariance_literal(lines)
                                                     : covariance_corrected(lines, x));
                       })
        .nees;
  };
  EXPECT_NEAR(nees(0, false), 3, 0.2);
  EXPECT_NEAR(nees(100e3, false), 3, 0.2);
  EXPECT_GT(nees(0, true), 10);
  EXPECT_LT(nees(100e3, true), nees(0, true) / 3);
}

TEST(Locate, AzimuthAloneNeedsAPriorOfHeight) {
  PassiveScene scene = scene_of_three();
  for (auto& sensor : scene.sensors) sensor.sigma_elevation_rad.reset();
  const auto lines = lines_of(scene, bearings_to(scene, kAimedAt));
  EXPECT_FALSE(most_likely(lines));
  const Gaussian<3> height{{0, 0, 5e3}, Eigen::Vector3d(1e18, 1e18, 1e6).asDiagonal()};
  const auto at = most_likely(lines, &height);
  ASSERT_TRUE(at);
  EXPECT_NEAR((at->position_m - Eigen::Vector3d(20e3, 20e3, 5e3)).norm(), 0, 1);
  EXPECT_NEAR(at->covariance_m2(2, 2), 1e6, 1e3);
}

TEST(Locate, ParallelLinesAndASingleLineHaveNoPosition) {
  const PassiveScene scene = scene_of_three();
  std::vector<Bearing> parallel(2);
  parallel[1].sensor = 1;
  for (auto& b : parallel) b.azimuth_rad = 0.3;
  EXPECT_FALSE(most_likely(lines_of(scene, parallel)));
  EXPECT_FALSE(most_likely(lines_of(scene, std::span(parallel).first(1))));
  EXPECT_TRUE(least_squares(lines_of(scene, parallel)).allFinite());
  EXPECT_TRUE(least_squares({}).allFinite());
}

TEST(Locate, APriorPullsAsOneMoreMeasurement) {
  const PassiveScene scene = scene_of_three();
  const auto lines = lines_of(scene, bearings_to(scene, kAimedAt));
  const auto free = most_likely(lines);
  Gaussian<3> prior{kAimedAt + Eigen::Vector3d(100, 0, 0), free->covariance_m2};
  const auto pulled = most_likely(lines, &prior);
  ASSERT_TRUE(pulled);
  EXPECT_NEAR(pulled->position_m.x() - kAimedAt.x(), 50, 1);
  EXPECT_NEAR(pulled->covariance_m2.trace() / free->covariance_m2.trace(), 0.5, 0.01);
}

}  // namespace
}  // namespace scanfuse::triangulate
