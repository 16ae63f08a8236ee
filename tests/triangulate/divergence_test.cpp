#include "scanfuse/triangulate/divergence.hpp"

#include <gtest/gtest.h>

#include "scanfuse/triangulate/pseudo_measurement.hpp"
#include "triangulate/scene_of_three.hpp"

namespace scanfuse::triangulate {
namespace {

Gaussian<2> density(double x, double y, double a, double b, double c) {
  Gaussian<2> g;
  g.mean << x, y;
  g.covariance << a, b, b, c;
  return g;
}

const Gaussian<2> kOne = density(0.1, -0.3, 2, 0.5, 1), kOther = density(0.4, 0.2, 1, -0.2, 3);

TEST(Renyi, IsZeroForEqualDensitiesAndPositiveElse) {
  for (const double alpha : {0.1, 0.5, 0.9, 1.0}) {
    EXPECT_NEAR(renyi(kOne, kOne, alpha), 0, 1e-12);
    EXPECT_GT(renyi(kOne, kOther, alpha), 0);
  }
}

TEST(Renyi, BecomesKullbackLeiblerAtOne) {
  EXPECT_NEAR(renyi(kOne, kOther, 1 - 1e-7), kullback_leibler(kOne, kOther), 1e-5);
}

// alpha D_(1 - alpha)(q || p) = (1 - alpha) D_alpha(p || q): so alpha and 1 - alpha rank alike.
TEST(Renyi, IsSkewSymmetricInItsOrder) {
  for (const double alpha : {0.2, 0.35, 0.5}) {
    EXPECT_NEAR((1 - alpha) * renyi(kOne, kOther, alpha), alpha * renyi(kOther, kOne, 1 - alpha),
                1e-12);
  }
}

// D = 1 / (alpha - 1) ln integral p^alpha q^(1 - alpha), by summing over a grid.
TEST(Renyi, AgreesWithItsIntegral) {
  const auto value = [](const Gaussian<2>& g, const Eigen::Vector2d& x) {
    const Eigen::Vector2d d = x - g.mean;
    return std::exp(-d.dot(g.covariance.inverse() * d) / 2) / std::sqrt(g.covariance.determinant());
  };
  double integral = 0;
  constexpr double kStep = 0.05, kAlpha = 0.4;
  for (double x = -12; x < 12; x += kStep) {
    for (double y = -12; y < 12; y += kStep) {
      integral += std::pow(value(kOne, {x, y}), kAlpha) *
                  std::pow(value(kOther, {x, y}), 1 - kAlpha) * kStep * kStep / (2 * M_PI);
    }
  }
  EXPECT_NEAR(renyi(kOne, kOther, kAlpha), std::log(integral) / (kAlpha - 1), 1e-6);
}

// [Lu2015, eq. 20] as printed: equal means, unlike covariances.
TEST(Renyi, AsPrintedGoesBelowZero) {
  EXPECT_LT(renyi_literal(density(0, 0, 1, 0, 1), density(0, 0, 4, 0, 4), 0.5), 0);
}

TEST(Renyi, SymmetricFormDoesNotCareWhichIsFirst) {
  const auto divergence = [](const auto& p, const auto& q) { return renyi(p, q, 0.3); };
  EXPECT_DOUBLE_EQ(symmetric(divergence, kOne, kOther), symmetric(divergence, kOther, kOne));
}

TEST(PseudoMeasurements, CovarianceIsFullAndAgreesWithSampling) {
  const PassiveScene scene = testing::scene_of_three();
  const Eigen::Vector3d target(20e3, 20e3, 8e3);
  const Eigen::Matrix3d spread = Eigen::Vector3d(100, 50, 80).cwiseAbs2().asDiagonal();
  const auto pseudo = pseudo_measurements(scene.sensors, target, spread);
  ASSERT_EQ(pseudo.covariance_rad2.rows(), 6);
  Eigen::MatrixXd sampled = Eigen::MatrixXd::Zero(6, 6);
  RandomStream random(4);
  constexpr int kSamples = 20000;
  for (int k = 0; k < kSamples; ++k) {
    const Eigen::Vector3d x =
        target + Eigen::Vector3d(100 * random.normal(), 50 * random.normal(), 80 * random.normal());
    const Eigen::VectorXd d =
        pseudo_measurements(scene.sensors, x, spread).mean_rad - pseudo.mean_rad;
    sampled += d * d.transpose() / kSamples;
  }
  EXPECT_LT((sampled - pseudo.covariance_rad2).norm(), 0.05 * pseudo.covariance_rad2.norm());
  EXPECT_GT(std::abs(pseudo.covariance_rad2(0, 2)), 0);  // not block diagonal
}

}  // namespace
}  // namespace scanfuse::triangulate
