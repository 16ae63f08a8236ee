#include "scanfuse/estimate/ego_frame.hpp"

#include <gtest/gtest.h>

#include "estimate/ctra_simulation.hpp"

namespace scanfuse::estimate {
namespace {

using GuoVector = Eigen::Matrix<double, 5, 1>;

/// An ego vehicle in the odometry frame.
struct EgoPlace {
  Eigen::Vector2d position_m = Eigen::Vector2d::Zero();
  double heading_rad = 0;

  void drive(const EgoControl& u, double T) {
    const CtraVector x =
        (CtraVector() << position_m, heading_rad, u.speed_m_per_s, 0, u.yaw_rate_rad_per_s)
            .finished();
    const CtraVector end = ctra_transition(x, T).mean;
    position_m = end.head<2>();
    heading_rad = end(2);
  }

  /// A belief of the odometry frame told in the ego frame.
  template <int N>
  [[nodiscard]] Gaussian<N> tell(const Gaussian<N>& x) const {
    Eigen::Matrix<double, N, N> G = Eigen::Matrix<double, N, N>::Identity();
    G.template topLeftCorner<2, 2>() = Eigen::Rotation2Dd(-heading_rad).toRotationMatrix();
    Gaussian<N> told{x.mean, G * x.covariance * G.transpose()};
    told.mean.template head<2>() -= position_m;
    told.mean = (G * told.mean).eval();
    if constexpr (N > 2) told.mean(2) = wrap_pi(x.mean(2) - heading_rad);
    return told;
  }
};

EgoControl control_at(int k) { return {12 + 3 * std::sin(0.1 * k), 0.4 * std::cos(0.07 * k)}; }

TEST(EgoFrame, FiltersHereAndInTheOdometryFrameAgree) {
  const CtraNoise noise{0, 0, 1, 0.1};
  constexpr double T = 0.08;
  RandomStream random(41);
  EgoPlace ego;
  Gaussian<6> odometry = start_of_ctra(14, 0.5, 0.2), here = odometry;
  CtraVector truth = odometry.mean;
  const auto H = position_of_ctra();
  double worst = 0;
  for (int k = 0; k < 200; ++k) {
    const EgoControl u = control_at(k);
    truth = moved(truth, T, noise, random);
    odometry = predict_ctra(odometry, T, noise);
    here = predict<6>(here, seen_from_ego<6>(ctra_transition(here.mean, T), u, T),
                      ctra_noise(here.mean, T, noise), Eigen::Matrix2d::Zero());
    ego.drive(u, T);
    const Gaussian<2> z = measured_position(truth, 0.2, random);
    odometry = update(odometry, z, expect(odometry, H), ctra::kAngles);
    here = update(here, ego.tell(z), expect(here, H), ctra::kAngles);

    const Gaussian<6> told = ego.tell(odometry);
    const CtraVector error = wrapped<6>(told.mean - here.mean, ctra::kAngles);
    worst = std::max({worst, error.norm() / odometry.mean.norm(),
                      (told.covariance - here.covariance).norm() / here.covariance.norm()});
  }
  RecordProperty("worst", ::testing::PrintToString(worst));
  EXPECT_LE(worst, 1e-13);
}

TEST(EgoFrame, SlopesAreThoseOfTheStep) {
  RandomStream random(42);
  constexpr double h = 1e-4, T = 0.3;
  for (int i = 0; i < 100; ++i) {
    const CtraVector x = draw(start_of_ctra(14, 0.5, random.uniform(-2, 2)), random);
    const Eigen::Vector2d u(random.uniform(-5, 40), i == 0 ? 0 : random.uniform(-1, 1));
    const auto step = [&](const CtraVector& state, const Eigen::Vector2d& control) {
      return seen_from_ego<6>(ctra_transition(state, T), {control(0), control(1)}, T);
    };
    const auto f = step(x, u);
    for (int c = 0; c < 6; ++c) {
      const CtraVector e = h * CtraVector::Unit(c);
      const CtraVector slope = (step(x + e, u).step.mean - step(x - e, u).step.mean) / (2 * h);
      EXPECT_LT((slope - f.step.F.col(c)).norm(), 1e-6) << c;
    }
    for (int c = 0; c < 2; ++c) {
      const Eigen::Vector2d e = h * Eigen::Vector2d::Unit(c);
      const CtraVector slope = (step(x, u + e).step.mean - step(x, u - e).step.mean) / (2 * h);
      EXPECT_LT((slope - f.B.col(c)).norm(), 1e-6) << c;
    }
  }
}

TEST(EgoFrame, AStandingTargetGoesBackwardsPastADrivingEgo) {
  const CtraVector x = (CtraVector() << 20, 2, 0, 0, 0, 0).finished();
  const auto f = seen_from_ego<6>(ctra_transition(x, 0.5), {10, 0}, 0.5);
  EXPECT_NEAR(f.step.mean(0), 15, 1e-14);
  EXPECT_NEAR(f.step.mean(1), 2, 1e-14);
  EXPECT_NEAR(f.B(0, 0), -0.5, 1e-15);
}

// The covariance grows by what uncertain control does to the place, and by nothing when it is sure.
TEST(EgoFrame, UncertainControlSpreadsTheBelief) {
  const Gaussian<6> x = start_of_ctra(10, 0, 0);
  const auto f = seen_from_ego<6>(ctra_transition(x.mean, 0.1), {10, 0.1}, 0.1);
  const CtraMatrix none = CtraMatrix::Zero();
  const Eigen::Matrix2d U = Eigen::Vector2d(0.04, 1e-4).asDiagonal();
  const auto sure = predict<6>(x, f, none, Eigen::Matrix2d::Zero());
  const auto unsure = predict<6>(x, f, none, U);
  EXPECT_TRUE((unsure.covariance - sure.covariance).isApprox(f.B * U * f.B.transpose(), 1e-10));
}

TEST(Guo, ATargetThatKeepsItsDirectionIsFollowedExactly) {
  const double T = 0.1;
  EgoPlace ego;
  GuoVector ground = (GuoVector() << 30, -4, 0.5, 8, 1.2).finished(), here = ground;
  for (int k = 0; k < 100; ++k) {
    const EgoControl u = control_at(k);
    here = guo_transition(here, u, T).step.mean;
    const double way = ground(3) * T + ground(4) * T * T / 2;
    ground.head<2>() += way * Eigen::Vector2d(std::cos(ground(2)), std::sin(ground(2)));
    ground(3) += ground(4) * T;
    ego.drive(u, T);
  }
  const GuoVector told = ego.tell(Gaussian<5>{ground}).mean;
  EXPECT_LT((told.head<2>() - here.head<2>()).norm(), 1e-11);
  EXPECT_NEAR(wrap_pi(told(2) - here(2)), 0, 1e-13);
  EXPECT_NEAR(here(3), 8 + 1.2 * 10, 1e-12);
}

TEST(Guo, IsTheSixStateModelWithTurnRateZero) {
  const GuoVector x = (GuoVector() << 30, -4, 0.5, 8, 1.2).finished();
  const CtraVector full = (CtraVector() << x, 0).finished();
  const auto five = guo_transition(x, {9, 0.2}, 0.1);
  const auto six = seen_from_ego<6>(ctra_transition(full, 0.1), {9, 0.2}, 0.1);
  EXPECT_TRUE(five.step.mean.isApprox(six.step.mean.head<5>(), 1e-15));
  EXPECT_TRUE(five.B.isApprox(six.B.topRows<5>(), 1e-15));
  const auto Q = guo_noise(x, 0.1, {0.1, 0, 2, 9});
  EXPECT_NEAR(Q(4, 4), 0.4, 1e-15);
  EXPECT_NEAR(Q(2, 2), 0.001, 1e-17);
}

// What the missing turn rate costs: a second ahead in a bend of 40 m at 12 m/s, from a perfect
// start.
TEST(Guo, WithoutATurnRateATargetInABendIsLost) {
  const CtraVector truth = (CtraVector() << 0, 0, 0, 12, 0, 0.3).finished();
  const GuoVector five = guo_transition(truth.head<5>(), {}, 1).step.mean;
  const double miss = (five.head<2>() - ctra_transition(truth, 1).mean.head<2>()).norm();
  EXPECT_GT(miss, 1.7);
  EXPECT_LT(miss, 1.9);
}

}  // namespace
}  // namespace scanfuse::estimate
