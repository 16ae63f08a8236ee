#include "scanfuse/estimate/kalman.hpp"

#include <gtest/gtest.h>

#include "scanfuse/core/random.hpp"
#include "scanfuse/estimate/constant_velocity.hpp"

namespace scanfuse::estimate {
namespace {

const Eigen::Matrix<double, 2, 4> kH = position_of_constant_velocity();

Gaussian<4> some_belief() {
  Gaussian<4> x;
  x.mean << 1, -2, 3, 4;
  Eigen::Matrix4d root;
  root << 1, 0, 0, 0, 0.4, 2, 0, 0, -0.3, 0.2, 1.5, 0, 0.1, 0.5, -0.6, 0.7;
  x.covariance = root * root.transpose();
  return x;
}

Gaussian<2> position(double x, double y, double sigma) {
  return {{x, y}, sigma * sigma * Eigen::Matrix2d::Identity()};
}

double least_eigenvalue(const Eigen::Matrix4d& P) {
  return Eigen::SelfAdjointEigenSolver<Eigen::Matrix4d>(P).eigenvalues().minCoeff();
}

TEST(KalmanUpdate, OrderOfIndependentMeasurementsDoesNotMatter) {
  const Gaussian<2> a = position(1.5, 2, 0.3), b = position(0.8, 3.5, 0.7);
  const auto ab = update(update(some_belief(), a, kH), b, kH);
  const auto ba = update(update(some_belief(), b, kH), a, kH);
  EXPECT_TRUE(ab.mean.isApprox(ba.mean, 1e-12));
  EXPECT_TRUE(ab.covariance.isApprox(ba.covariance, 1e-12));
}

TEST(KalmanUpdate, EqualsThePaperFormInExactCases) {
  const Gaussian<4> x = some_belief();
  const Gaussian<2> z = position(2, 2, 0.5);
  const Eigen::Matrix2d S = innovation(x, z, kH).covariance;
  const Eigen::Matrix<double, 4, 2> K = x.covariance * kH.transpose() * S.inverse();
  const Eigen::Matrix4d eq11 = (Eigen::Matrix4d::Identity() - K * kH) * x.covariance;
  EXPECT_TRUE(update(x, z, kH).covariance.isApprox(eq11, 1e-12));
}

TEST(KalmanUpdate, CovarianceStaysSymmetricAndPositiveDefiniteAfterManyUpdates) {
  Gaussian<4> x = some_belief();
  x.covariance *= 1e8;
  const Eigen::Matrix4d F = constant_velocity_transition(0.08);
  const Eigen::Matrix4d Q = Eigen::Matrix4d::Zero();
  for (int i = 0; i < 20000; ++i) {
    x = update(predict(x, F, Q), position(i * 0.1, 1, 1e-3), kH);
    ASSERT_EQ(x.covariance, x.covariance.transpose()) << i;
  }
  EXPECT_GT(least_eigenvalue(x.covariance), 0);
}

TEST(KalmanUpdate, AMeasurementNeverMakesTheBeliefVaguer) {
  const Gaussian<4> x = some_belief();
  const auto after = update(x, position(9, 9, 2), kH);
  EXPECT_GE(least_eigenvalue(x.covariance - after.covariance), -1e-12);
}

TEST(Innovation, LogLikelihoodIsThatOfTheNormalDensity) {
  Gaussian<1> x, z;
  x.mean << 1;
  x.covariance << 3;
  z.mean << 2;
  z.covariance << 1;
  const auto nu = innovation(x, z, Eigen::Matrix<double, 1, 1>::Identity().eval());
  EXPECT_NEAR(nu.nis(), 0.25, 1e-15);
  EXPECT_NEAR(nu.log_likelihood(), -0.125 - 0.5 * std::log(2 * kPi * 4), 1e-15);
}

TEST(ConstantVelocity, TwoHalfStepsEqualOneWholeStep) {
  for (const double dt : {0.001, 0.08, 1.0, 7.0}) {
    const auto step = [](const Gaussian<4>& x, double t) {
      return predict(x, constant_velocity_transition(t), constant_velocity_noise(t, 1.5));
    };
    const auto whole = step(some_belief(), dt), halves = step(step(some_belief(), dt / 2), dt / 2);
    EXPECT_TRUE(whole.mean.isApprox(halves.mean, 1e-12)) << dt;
    EXPECT_TRUE(whole.covariance.isApprox(halves.covariance, 1e-12)) << dt;
  }
}

TEST(ConstantVelocity, TheTwoPointStartIsTheLimitOfAVagueOnePointStart) {
  const double sigma = 0.5, dt = 0.08;
  auto x = start_from_one_point(position(1, 2, sigma), 1e5);
  x = predict(x, constant_velocity_transition(dt), Eigen::Matrix4d::Zero().eval());
  x = update(x, position(1.4, 1.9, sigma), kH);
  const auto two = start_from_two_points({1, 2}, {1.4, 1.9}, sigma, dt);
  EXPECT_TRUE(x.mean.isApprox(two.mean, 1e-6));
  EXPECT_TRUE(x.covariance.isApprox(two.covariance, 1e-6));
}

TEST(ConstantVelocity, EquationFourteenIsWhatTheDifferenceOfTwoPositionsHas) {
  const double sigma = 0.5, dt = 0.08;
  RandomStream random(5);
  Eigen::Matrix2d sum = Eigen::Matrix2d::Zero();
  constexpr int kRuns = 200000;
  for (int i = 0; i < kRuns; ++i) {
    const double a = random.normal(0, sigma), b = random.normal(0, sigma);
    const Eigen::Vector2d error(b, (b - a) / dt);
    sum += error * error.transpose();
  }
  const Eigen::Matrix4d P = two_point_covariance(sigma, dt);
  EXPECT_TRUE((sum / kRuns).isApprox(P.topLeftCorner<2, 2>(), 0.01));
}

TEST(ConstantVelocity, GainWithoutProcessNoiseFallsAsFourOverN) {
  auto x = start_from_two_points({0, 0}, {0, 0}, 0.2, 0.08);
  double gain = 0;
  for (int n = 3; n <= 1000; ++n) {
    x = predict(x, constant_velocity_transition(0.08), Eigen::Matrix4d::Zero().eval());
    const double before = x.covariance(0, 0);
    gain = before / (before + 0.04);
    x = update(x, position(0, 0, 0.2), kH);
  }
  EXPECT_NEAR(gain * 1000, 4, 0.05);
}

struct Consistency {
  double anees = 0, anis = 0;
  int samples = 0;
};

/// Filters `runs` random walks in velocity; `turn_rad_per_s` bends them, which the model ignores.
Consistency simulate(double turn_rad_per_s, int runs) {
  const double dt = 0.08, sigma = 0.15, sigma_a = 1.5;
  const Eigen::Matrix4d F = constant_velocity_transition(dt);
  const Eigen::Matrix4d Q = constant_velocity_noise(dt, sigma_a);
  const Eigen::Matrix4d root = Q.llt().matrixL();
  Consistency result;
  for (int run = 0; run < runs; ++run) {
    RandomStream random(11, run);
    const auto draw = [&](double s) { return random.normal(0, s); };
    Eigen::Vector4d truth(0, draw(10), 0, draw(10));
    auto x = start_from_one_point(position(draw(sigma), draw(sigma), sigma), 10);
    for (int k = 0; k < 60; ++k) {
      const Eigen::Vector4d noise(draw(1), draw(1), draw(1), draw(1));
      truth = F * truth + root * noise;
      const double c = std::cos(turn_rad_per_s * dt), s = std::sin(turn_rad_per_s * dt);
      truth = Eigen::Vector4d(truth(0), c * truth(1) - s * truth(3), truth(2),
                              s * truth(1) + c * truth(3));
      x = predict(x, F, Q);
      const auto z = position(truth(0) + draw(sigma), truth(2) + draw(sigma), sigma);
      result.anis += innovation(x, z, kH).nis();
      x = update(x, z, kH);
      if (k == 59) result.anees += nees(x, truth);
    }
  }
  result.anees /= runs;
  result.anis /= runs * 60;
  result.samples = runs;
  return result;
}

// Mean of n chi-square draws of d degrees: standard deviation sqrt(2 d / n).
TEST(Consistency, NeesAndNisLieInTheirBandOnMatchedData) {
  const auto result = simulate(0, 500);
  EXPECT_NEAR(result.anees, 4, 1.96 * std::sqrt(2 * 4.0 / 500));
  EXPECT_NEAR(result.anis, 2, 1.96 * std::sqrt(2 * 2.0 / (500 * 60)));
}

TEST(Consistency, ATurningTargetFailsTheTestOfTheStraightModel) {
  const auto result = simulate(0.5, 200);
  EXPECT_GT(result.anees, 4 + 1.96 * std::sqrt(2 * 4.0 / 200));
  EXPECT_GT(result.anis, 2 + 1.96 * std::sqrt(2 * 2.0 / (200 * 60)));
}

}  // namespace
}  // namespace scanfuse::estimate
