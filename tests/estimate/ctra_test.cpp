#include "scanfuse/estimate/ctra.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <iterator>
#include <vector>

#include "scanfuse/core/random.hpp"
#include "scanfuse/estimate/gauss_legendre.hpp"
#include "scanfuse/estimate/turn_moments.hpp"

namespace scanfuse::estimate {
namespace {

using LongVector = Eigen::Matrix<long double, 6, 1>;

/// int_0^end f by composite Simpson with Richardson's extrapolation (Romberg), in long double.
long double integral(const std::function<long double(long double)>& f, long double end) {
  constexpr int kLevels = 12;
  std::array<long double, kLevels> row{};
  row[0] = end / 2 * (f(0) + f(end));
  long long intervals = 1;
  for (int level = 1; level < kLevels; ++level, intervals *= 2) {
    const long double h = end / static_cast<long double>(intervals);
    long double middle = 0;
    for (long long i = 0; i < intervals; ++i) middle += f((static_cast<long double>(i) + 0.5L) * h);
    long double before = row[0], power = 1;
    row[0] = (row[0] + h * middle) / 2;
    for (int k = 1; k <= level; ++k) {
      power *= 4;
      const long double next = row[k - 1] + (row[k - 1] - before) / (power - 1);
      before = row[k];
      row[k] = next;
    }
  }
  return row[kLevels - 1];
}

/// The flow of CTRA by quadrature alone: no moments, no branches.
LongVector reference_flow(const LongVector& x, long double T) {
  const auto heading = [&](long double t) { return x(2) + x(5) * t; };
  const auto speed = [&](long double t) { return x(3) + x(4) * t; };
  LongVector end = x;
  end(0) += integral([&](long double t) { return speed(t) * std::cos(heading(t)); }, T);
  end(1) += integral([&](long double t) { return speed(t) * std::sin(heading(t)); }, T);
  end(2) = heading(T);
  end(3) = speed(T);
  return end;
}

/// Central differences of fourth order in long double.
Eigen::Matrix<long double, 6, 6> reference_slope(const LongVector& x, long double T) {
  Eigen::Matrix<long double, 6, 6> F;
  constexpr long double h = 1e-4L;
  for (int i = 0; i < 6; ++i) {
    const auto f = [&](long double step) {
      return reference_flow(x + step * LongVector::Unit(i), T);
    };
    const LongVector d1 = f(h) - f(-h), d2 = f(2 * h) - f(-2 * h), d3 = f(3 * h) - f(-3 * h);
    F.col(i) = (45 * d1 - 9 * d2 + d3) / (60 * h);
  }
  return F;
}

const std::vector<double> kTurnRates = {0,    1e-300, 1e-15, 1e-9, -1e-8, 1e-6, 1e-4, -1e-3, 0.01,
                                        -0.1, 0.239,  0.241, 0.5,  -0.99, 1.01, -2,   3,     -3};

CtraVector random_ctra(RandomStream& random, double w) {
  CtraVector x;
  x << random.uniform(-100, 100), random.uniform(-100, 100), random.uniform(-kPi, kPi),
      random.uniform(-60, 60), random.uniform(-10, 10), w;
  return x;
}

CtraMatrix random_spd(RandomStream& random) {
  CtraMatrix root;
  for (double& entry : root.reshaped()) entry = random.normal();
  return root * root.transpose();
}

double difference(const Gaussian<6>& a, const Gaussian<6>& b) {
  const CtraVector d = wrapped<6>(a.mean - b.mean, ctra::kAngles);
  return std::max(d.norm() / (1 + a.mean.norm()),
                  (a.covariance - b.covariance).norm() / a.covariance.norm());
}

TEST(TurnMoments, AgreeWithTheirIntegralsToRounding) {
  double worst = 0;
  std::vector<double> angles = kTurnRates;
  for (int i = -300; i <= 300; ++i) angles.push_back(i * 0.01 + 1e-5);
  for (const double th : angles) {
    const TurnMoments m = turn_moments(th);
    const double got[2][3] = {{m.A0, m.A1, m.A2}, {m.B0, m.B1, m.B2}};
    for (int k = 0; k < 3; ++k) {
      const auto moment = [&](auto wave) {
        return integral(
            [&](long double s) { return std::pow(s, k) * wave(static_cast<long double>(th) * s); },
            1);
      };
      const auto a = moment([](long double t) { return std::cos(t); });
      const auto b = moment([](long double t) { return std::sin(t); });
      worst = std::max({worst, static_cast<double>(std::abs(got[0][k] - a)),
                        static_cast<double>(std::abs(got[1][k] - b))});
      if (std::abs(th) < 1) {
        EXPECT_NEAR(got[1][k], static_cast<double>(b), 1e-15 * std::abs(th));
      }
    }
  }
  RecordProperty("worst", ::testing::PrintToString(worst));
  EXPECT_LE(worst, 1e-15);
}

TEST(GaussLegendre, IntegratesPolynomialsUpToDegreeFifteen) {
  for (int degree = 0; degree <= 15; ++degree) {
    double sum = 0;
    for_each_node(1, 1, [&](double t, double weight) { sum += weight * std::pow(t, degree); });
    EXPECT_NEAR(sum, 1.0 / (degree + 1), 1e-15) << degree;
  }
}

// Relative to the length of the way, |v| T + |a| T^2 / 2: a component of it may be zero.
TEST(Ctra, StepAgreesWithIntegrationInLongDouble) {
  RandomStream random(21);
  double worst = 0;
  for (const double T : {0.001, 0.01, 0.08, 0.3, 1.0}) {
    for (const double w : kTurnRates) {
      for (int i = 0; i < 4; ++i) {
        CtraVector x = random_ctra(random, w);
        x.head<2>().setZero();
        const CtraVector got = ctra_transition(x, T).mean;
        const LongVector want = reference_flow(x.cast<long double>(), T);
        const double way = std::abs(x(3)) * T + std::abs(x(4)) * T * T / 2;
        worst = std::max(
            worst, static_cast<double>((got.cast<long double>() - want).head<2>().norm()) / way);
        EXPECT_NEAR(got(2), static_cast<double>(want(2)), 1e-15 * 8);
        EXPECT_NEAR(got(3), static_cast<double>(want(3)), 1e-12);
      }
    }
  }
  RecordProperty("worst", ::testing::PrintToString(worst));
  EXPECT_LE(worst, 2e-15);
}

TEST(Ctra, SlopeAgreesWithDifferencesInLongDouble) {
  RandomStream random(22);
  double worst = 0;
  for (const double T : {0.001, 0.08, 1.0}) {
    for (const double w : {0.0, 1e-9, -1e-4, 0.3, -1.0, 3.0}) {
      const CtraVector x = random_ctra(random, w);
      const CtraMatrix got = ctra_transition(x, T).F;
      const CtraMatrix want = reference_slope(x.cast<long double>(), T).cast<double>();
      for (int column = 0; column < 6; ++column) {
        worst = std::max(worst, (got - want).col(column).norm() / want.col(column).norm());
      }
    }
  }
  RecordProperty("worst", ::testing::PrintToString(worst));
  EXPECT_LE(worst, 1e-12);
}

TEST(Ctra, TurnRateIsObservableOnAStraight) {
  const CtraVector x = (CtraVector() << 0, 0, 0, 15, 0, 0).finished();
  EXPECT_NEAR(ctra_transition(x, 0.1).F(ctra::kY, ctra::kYawRate), 15 * 0.01 / 2, 1e-15);
}

TEST(Ctra, TurningAndMovingTheStateTurnsAndMovesTheResult) {
  RandomStream random(23);
  const CtraNoise noise{0.02, 0.5, 1.5, 0.2};
  for (int i = 0; i < 100; ++i) {
    const double turn = random.uniform(-kPi, kPi), T = random.uniform(0.001, 1);
    CtraMatrix G = CtraMatrix::Identity();
    G.topLeftCorner<2, 2>() = Eigen::Rotation2Dd(turn).toRotationMatrix();
    const CtraVector shift = (CtraVector() << 7, -3, turn, 0, 0, 0).finished();
    const auto moved = [&](const Gaussian<6>& x) {
      return Gaussian<6>{G * x.mean + shift, G * x.covariance * G.transpose()};
    };
    const Gaussian<6> x{random_ctra(random, random.uniform(-3, 3)), random_spd(random)};
    EXPECT_LT(difference(predict_ctra(moved(x), T, noise), moved(predict_ctra(x, T, noise))),
              1e-13);
  }
}

TEST(Ctra, TwoHalfStepsLeaveTheBeliefOfOneWholeStep) {
  RandomStream random(24);
  const CtraNoise noise{0.02, 0.5, 1.5, 0.2};
  double worst = 0, worst_noise = 0;
  for (const Fade& fade : {Fade{}, Fade{1, 2}}) {
    for (const double T : {0.001, 0.08, 0.3, 1.0}) {
      for (const double w : kTurnRates) {
        Gaussian<6> x{random_ctra(random, w), random_spd(random)};
        const auto halved = [&] {
          return predict_ctra(predict_ctra(x, T / 2, noise, fade), T / 2, noise, fade);
        };
        worst = std::max(worst, difference(predict_ctra(x, T, noise, fade), halved()));
        x.covariance.setZero();
        worst_noise = std::max(worst_noise, difference(predict_ctra(x, T, noise, fade), halved()));
      }
    }
  }
  RecordProperty("worst", ::testing::PrintToString(std::max(worst, worst_noise)));
  EXPECT_LE(worst, 1e-12);
  EXPECT_LE(worst_noise, 1e-12);
}

// On a straight along x the model is a chain of integrators with known noise.
TEST(CtraNoise, OnAStraightIsThatOfIntegratedWhiteNoise) {
  const double T = 0.7, v = 12, jerk = 1.3, yaw = 0.4;
  const CtraVector x = (CtraVector() << 0, 0, 0, v, 0, 0).finished();
  const CtraMatrix Q = ctra_noise(x, T, {0, 0, jerk, yaw});
  Eigen::Matrix3d chain;  // of place, its rate, and its second rate
  chain << T * T * T * T * T / 20, T * T * T * T / 8, T * T * T / 6, T * T * T * T / 8,
      T * T * T / 3, T * T / 2, T * T * T / 6, T * T / 2, T;
  const std::array<int, 3> along = {ctra::kX, ctra::kSpeed, ctra::kAccel};
  const std::array<int, 3> across = {ctra::kY, ctra::kHeading, ctra::kYawRate};
  const Eigen::Vector3d scale(v, 1, 1);
  EXPECT_TRUE(Eigen::Matrix3d(Q(along, along)).isApprox(jerk * jerk * chain, 1e-14));
  EXPECT_TRUE(Eigen::Matrix3d(Q(across, across))
                  .isApprox(yaw * yaw * scale.asDiagonal() * chain * scale.asDiagonal(), 1e-14));
}

TEST(CtraNoise, IsPositiveSemidefinite) {
  RandomStream random(25);
  for (int i = 0; i < 300; ++i) {
    const CtraVector x = random_ctra(random, random.uniform(-3, 3));
    const CtraMatrix Q = ctra_noise(x, random.uniform(0.001, 1), {0.01, 0.2, 1, 0.1});
    const auto eigenvalues = Eigen::SelfAdjointEigenSolver<CtraMatrix>(Q).eigenvalues();
    EXPECT_GE(eigenvalues.minCoeff(), -1e-14 * eigenvalues.maxCoeff());
  }
}

TEST(CtraFade, WithoutFadingIsThePlainStep) {
  RandomStream random(26);
  for (const double w : kTurnRates) {
    const CtraVector x = random_ctra(random, w);
    const auto plain = ctra_transition(x, 0.5), faded = ctra_transition(x, 0.5, Fade{1e13, 1e13});
    EXPECT_TRUE(faded.mean.isApprox(plain.mean, 1e-12)) << w;
    EXPECT_TRUE(faded.F.isApprox(plain.F, 1e-12)) << w;
  }
}

TEST(CtraFade, ATargetLostInABendGoesStraightInTheEnd) {
  const CtraVector x = (CtraVector() << 0, 0, 0, 10, 0, 0.5).finished();
  const auto end = ctra_transition(x, 20, Fade{1.0});
  EXPECT_NEAR(end.mean(ctra::kHeading), 0.5, 1e-8);
  EXPECT_NEAR(end.mean(ctra::kYawRate), 0, 1e-8);
  EXPECT_NEAR(ctra_transition(x, 20).mean(ctra::kHeading), 10, 1e-12);
}

TEST(CtraFade, SlopeIsThatOfItsStep) {
  RandomStream random(27);
  for (int i = 0; i < 50; ++i) {
    const CtraVector x = random_ctra(random, random.uniform(-2, 2));
    const Fade fade{0.8, 1.5};
    const auto f = ctra_transition(x, 0.6, fade);
    constexpr double h = 1e-3;
    for (int column = 0; column < 6; ++column) {
      const auto at = [&](double step) {
        return ctra_transition(x + step * CtraVector::Unit(column), 0.6, fade).mean;
      };
      const CtraVector slope = (8 * (at(h) - at(-h)) - (at(2 * h) - at(-2 * h))) / (12 * h);
      EXPECT_TRUE((slope - f.F.col(column)).norm() < 1e-9 * (1 + slope.norm())) << column;
    }
  }
}

TEST(CtraFlip, TellsTheSameMotionBeforeAndAfterAStep) {
  RandomStream random(28);
  const CtraNoise noise{0.02, 0.5, 1.5, 0.2};
  for (int i = 0; i < 100; ++i) {
    const Gaussian<6> x{random_ctra(random, random.uniform(-3, 3)), random_spd(random)};
    const double T = random.uniform(0.001, 1);
    EXPECT_LT(difference(flip_heading(predict_ctra(x, T, noise)),
                         predict_ctra(flip_heading(x), T, noise)),
              1e-13);
    EXPECT_LT(difference(flip_heading(flip_heading(x)), x), 1e-15);
    const Gaussian<4> a = velocity_of_ctra(x), b = velocity_of_ctra(flip_heading(x));
    EXPECT_TRUE(a.mean.isApprox(b.mean, 1e-13));
    EXPECT_TRUE(a.covariance.isApprox(b.covariance, 1e-12));
  }
}

TEST(Ctra, VelocityHasTheMomentsOfTheBelief) {
  for (const double v : {0.0, 0.5, 12.0}) {
    RandomStream random(29);
    Gaussian<6> x;
    x.mean << 1, 2, 0.8, v, 0.3, 0.1;
    x.covariance = 0.02 * random_spd(random);
    const Gaussian<4> got = velocity_of_ctra(x);
    const CtraMatrix root = x.covariance.llt().matrixL();
    Eigen::Vector4d sum = Eigen::Vector4d::Zero();
    Eigen::Matrix4d squares = Eigen::Matrix4d::Zero();
    constexpr int kDraws = 200000;
    for (int i = 0; i < kDraws; ++i) {
      CtraVector unit;
      for (double& entry : unit) entry = random.normal();
      const CtraVector s = x.mean + root * unit;
      const Eigen::Vector4d d =
          Eigen::Vector4d(s(0), s(3) * std::cos(s(2)), s(1), s(3) * std::sin(s(2))) - got.mean;
      sum += d;
      squares += d * d.transpose();
    }
    EXPECT_LT((sum / kDraws).norm(), 0.02) << v;
    EXPECT_TRUE(got.covariance.isApprox(squares / kDraws, 0.02)) << v;
  }
}

TEST(CtraFlip, SettlesOnlyWhatSurelyDrivesBackwards) {
  Gaussian<6> x;
  x.mean << 0, 0, 1, -0.4, 0, 0;
  EXPECT_EQ(settle_heading(x).mean(ctra::kSpeed), -0.4);
  x.mean(ctra::kSpeed) = -0.6;
  EXPECT_EQ(settle_heading(x).mean(ctra::kSpeed), 0.6);
  EXPECT_NEAR(settle_heading(x).mean(ctra::kHeading), 1 - kPi, 1e-15);
}

TEST(Ctrv, IsCtraWithoutAcceleration) {
  const CtrvVector x = (CtrvVector() << 1, 2, 0.3, 8, 0.4).finished();
  const double r = 8 / 0.4;
  const auto f = ctrv_transition(x, 0.5);
  EXPECT_NEAR(f.mean(ctrv::kX), 1 + r * (std::sin(0.5) - std::sin(0.3)), 1e-13);
  EXPECT_NEAR(f.mean(ctrv::kY), 2 + r * (std::cos(0.3) - std::cos(0.5)), 1e-13);
  EXPECT_EQ(f.F(ctrv::kHeading, ctrv::kYawRate), 0.5);
  const CtrvMatrix Q = ctrv_noise(x, 0.5, {0, 1, 9, 0.1});
  EXPECT_NEAR(Q(ctrv::kSpeed, ctrv::kSpeed), 0.5, 1e-15);
  EXPECT_NEAR(Q(ctrv::kYawRate, ctrv::kYawRate), 0.005, 1e-15);
}

}  // namespace
}  // namespace scanfuse::estimate
