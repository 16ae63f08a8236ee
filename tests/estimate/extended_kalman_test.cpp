#include "scanfuse/estimate/extended_kalman.hpp"

#include <gtest/gtest.h>

#include "estimate/ctra_simulation.hpp"
#include "scanfuse/estimate/consistency.hpp"
#include "scanfuse/estimate/constant_velocity.hpp"

namespace scanfuse::estimate {
namespace {

/// Position and heading, as a box tells them.
Expectation<6, 3> pose_of(const Gaussian<6>& x) {
  return expect<6, 3>(x, Eigen::Matrix<double, 3, 6>::Identity());
}
constexpr Angles kHeadingOfPose = Angles::at(2);

/// Range and bearing from the origin.
Expectation<6, 2> range_and_bearing(const Gaussian<6>& x) {
  const Eigen::Vector2d p = x.mean.head<2>();
  const double r = p.norm();
  Expectation<6, 2> h{{r, std::atan2(p.y(), p.x())}, Eigen::Matrix<double, 2, 6>::Zero()};
  h.H.leftCols<2>() << p.x() / r, p.y() / r, -p.y() / (r * r), p.x() / (r * r);
  return h;
}

TEST(ExtendedKalman, EqualsTheLinearFilterWhereNothingBends) {
  const Gaussian<6> x = start_of_ctra(10, 0, 0.1);
  RandomStream random(31);
  const auto z = measured_position(x.mean, 0.3, random);
  const auto H = position_of_ctra();
  const auto linear = update(x, z, H), extended = update(x, z, expect(x, H));
  EXPECT_EQ(linear.mean, extended.mean);
  EXPECT_EQ(linear.covariance, extended.covariance);
}

TEST(ExtendedKalman, WholeTurnsOfAnAngleDoNotMatter) {
  Gaussian<6> x = start_of_ctra(10, 0, 0.1);
  x.mean(2) = 3.1;
  Gaussian<3> z{{5, -3, -3.1}, 0.01 * Eigen::Matrix3d::Identity()};
  const auto near = update(x, z, pose_of(x), ctra::kAngles, kHeadingOfPose);
  EXPECT_GT(std::abs(near.mean(2)), 3.1);
  for (const double turns : {-3, 1, 10}) {
    Gaussian<6> x2 = x;
    x2.mean(2) += 2 * kPi * turns;
    const auto same = update(x2, z, pose_of(x2), ctra::kAngles, kHeadingOfPose);
    EXPECT_TRUE(same.mean.isApprox(near.mean, 1e-13));
    EXPECT_EQ(same.covariance, near.covariance);
  }
}

TEST(ExtendedKalman, CovarianceStaysSymmetricAndPositiveDefiniteAfterManySteps) {
  RandomStream random(32);
  const CtraNoise noise{0, 0, 1, 0.1};
  Gaussian<6> x = start_of_ctra(15, 0, 0.2);
  x.covariance *= 1e6;
  CtraVector truth = x.mean;
  for (int i = 0; i < 5000; ++i) {
    truth = ctra_transition(truth, 0.08).mean;
    x = predict_ctra(x, 0.08, noise);
    x = update(x, measured_position(truth, 1e-3, random), expect(x, position_of_ctra()),
               ctra::kAngles);
    ASSERT_EQ(x.covariance, x.covariance.transpose());
    ASSERT_LE(std::abs(x.mean(2)), kPi);
  }
  EXPECT_GT(Eigen::SelfAdjointEigenSolver<CtraMatrix>(x.covariance).eigenvalues().minCoeff(), 0);
  EXPECT_LT((x.mean - truth).head<2>().norm(), 0.01);
}

struct Scores {
  double anees = 0, anis = 0;
  int runs = 0, innovations = 0;
  void finish() {
    anees /= runs;
    anis /= innovations;
  }
};

/// NEES of the last step of each run (independent), NIS of all.
template <class Expect>
Scores score_matched(const CtraNoise& noise, int runs, const Eigen::Matrix2d& R, Expect&& h,
                     Angles angles_of_z) {
  constexpr int kSteps = 60;
  constexpr double kDt = 0.08;
  Scores scores{0, 0, runs, runs * kSteps};
  for (int run = 0; run < runs; ++run) {
    RandomStream random(33, run);
    Gaussian<6> x = start_of_ctra(12, 0, 0.3);
    CtraVector truth = draw(x, random);
    for (int k = 0; k < kSteps; ++k) {
      truth = moved(truth, kDt, noise, random);
      x = predict_ctra(x, kDt, noise);
      Gaussian<2> z{h(Gaussian<6>{truth}).mean, R};
      z.mean +=
          R.diagonal().cwiseSqrt().cwiseProduct(Eigen::Vector2d(random.normal(), random.normal()));
      scores.anis += innovation(x, z, h(x), angles_of_z).nis();
      x = update(x, z, h(x), ctra::kAngles, angles_of_z);
    }
    Gaussian<6> error = x;
    error.mean = wrapped<6>(x.mean - truth, ctra::kAngles);
    scores.anees += nees<6>(error, CtraVector::Zero());
  }
  scores.finish();
  ::testing::Test::RecordProperty("anees", ::testing::PrintToString(scores.anees));
  ::testing::Test::RecordProperty("anis", ::testing::PrintToString(scores.anis));
  return scores;
}

TEST(ExtendedKalman, NeesAndNisLieInTheirBandOnATurningTarget) {
  const auto h = [](const Gaussian<6>& x) { return expect(x, position_of_ctra()); };
  const Scores s =
      score_matched({0, 0, 1, 0.1}, 4000, 0.15 * 0.15 * Eigen::Matrix2d::Identity(), h, {});
  EXPECT_TRUE(mean_chi_square_band(s.runs, 6).contains(s.anees)) << s.anees;
  EXPECT_TRUE(mean_chi_square_band(s.innovations, 2).contains(s.anis)) << s.anis;
}

TEST(ExtendedKalman, NeesAndNisLieInTheirBandWithRangeAndBearing) {
  const Eigen::Vector2d sigma(0.1, 0.005);
  const Scores s = score_matched({0, 0, 1, 0.1}, 4000, sigma.cwiseAbs2().asDiagonal(),
                                 range_and_bearing, Angles::at(1));
  EXPECT_TRUE(mean_chi_square_band(s.runs, 6).contains(s.anees)) << s.anees;
  EXPECT_TRUE(mean_chi_square_band(s.innovations, 2).contains(s.anis)) << s.anis;
}

// The constant-velocity filter on a target that turns at 0.3 rad/s.
TEST(ExtendedKalman, AStraightModelFailsOnATurningTarget) {
  constexpr int kRuns = 200, kSteps = 60;
  constexpr double kDt = 0.08, kSigma = 0.15;
  Scores scores{0, 0, kRuns, kRuns * kSteps};
  for (int run = 0; run < kRuns; ++run) {
    RandomStream random(34, run);
    CtraVector truth = draw(start_of_ctra(12, 0, 0.3), random);
    auto x = start_from_one_point(measured_position(truth, kSigma, random), 10);
    const Eigen::Matrix<double, 2, 4> H = position_of_constant_velocity();
    for (int k = 0; k < kSteps; ++k) {
      truth = moved(truth, kDt, {0, 0, 1, 0.1}, random);
      x = predict(x, constant_velocity_transition(kDt), constant_velocity_noise(kDt, 0.8));
      const auto z = measured_position(truth, kSigma, random);
      scores.anis += innovation(x, z, H).nis();
      x = update(x, z, H);
    }
    scores.anees += nees(x, velocity_of_ctra(truth));
  }
  scores.finish();
  RecordProperty("anees", ::testing::PrintToString(scores.anees));
  RecordProperty("anis", ::testing::PrintToString(scores.anis));
  EXPECT_GT(scores.anees, 2 * mean_chi_square_band(kRuns, 4).high);
  EXPECT_GT(scores.anis, mean_chi_square_band(kRuns * kSteps, 2).high);
}

}  // namespace
}  // namespace scanfuse::estimate
