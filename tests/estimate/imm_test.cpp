#include "scanfuse/estimate/imm.hpp"

#include <gtest/gtest.h>

#include "estimate/ctra_simulation.hpp"
#include "scanfuse/estimate/consistency.hpp"
#include "scanfuse/estimate/ctra_models.hpp"

namespace scanfuse::estimate {
namespace {

constexpr double kStep = 0.08, kPositionSigma = 0.15;
const std::array<CtraModel, 3> kModels = road_user_models();

CtraImm::Switching leave_after(double seconds) {
  return CtraImm::Switching::Constant(0.5 / seconds);
}

CtraImm start_imm(double v) {
  return {start_of_ctra(v, 0, 0), CtraImm::Weights::Constant(1.0 / 3), ctra::kAngles};
}

double fold(CtraImm& imm, const Gaussian<2>& z) {
  return imm.update(z, [](const Gaussian<6>& x) { return expect(x, position_of_ctra()); });
}

TEST(MomentMatch, IsTheMeanAndCovarianceOfTheMixture) {
  const std::array<Gaussian<1>, 2> parts = {
      Gaussian<1>{Eigen::Matrix<double, 1, 1>(1.0), Eigen::Matrix<double, 1, 1>(2.0)},
      Gaussian<1>{Eigen::Matrix<double, 1, 1>(4.0), Eigen::Matrix<double, 1, 1>(1.0)}};
  const auto merged = moment_match<1, 2>(parts, Eigen::Vector2d(0.25, 0.75));
  EXPECT_NEAR(merged.mean(0), 3.25, 1e-15);
  EXPECT_NEAR(merged.covariance(0), 0.25 * (2 + 2.25 * 2.25) + 0.75 * (1 + 0.75 * 0.75), 1e-14);
}

TEST(MomentMatch, AnglesOnBothSidesOfPiMeetThere) {
  std::array<Gaussian<6>, 2> parts;
  parts[0].mean(2) = kPi - 0.1;
  parts[1].mean(2) = -kPi + 0.3;
  const auto merged = moment_match<6, 2>(parts, Eigen::Vector2d(0.5, 0.5), ctra::kAngles);
  EXPECT_NEAR(merged.mean(2), -kPi + 0.1, 1e-14);
  EXPECT_NEAR(merged.covariance(2, 2), 1 + 0.04, 1e-13);
}

TEST(Switching, TwoHalfStepsSwitchAsOneWholeStep) {
  Eigen::Matrix3d rates;
  rates << 0, 0.3, 0.1, 2, 0, 0.5, 0.7, 40, 0;
  for (const double dt : {0.0, 0.001, 0.08, 1.0, 30.0}) {
    const Eigen::Matrix3d whole = switching<3>(rates, dt), half = switching<3>(rates, dt / 2);
    EXPECT_TRUE(whole.isApprox(half * half, 1e-12)) << dt;
    EXPECT_NEAR((whole.rowwise().sum() - Eigen::Vector3d::Ones()).norm(), 0, 1e-12);
    EXPECT_GE(whole.minCoeff(), 0);
  }
  const Eigen::Matrix2d two = switching<2>(Eigen::Matrix2d::Constant(0.7), 1.3);
  EXPECT_NEAR(two(0, 0), 0.5 + 0.5 * std::exp(-2 * 0.7 * 1.3), 1e-14);
}

TEST(Imm, OfEqualModelsIsTheFilterItself) {
  RandomStream random(51);
  const CtraNoise noise{0, 0, 1, 0.1};
  Gaussian<6> single = start_of_ctra(12, 0, 0.2);
  Imm<6, 2> imm(single, {0.3, 0.7}, ctra::kAngles);
  CtraVector truth = single.mean;
  const auto expectation = [](const Gaussian<6>& x) { return expect(x, position_of_ctra()); };
  for (int k = 0; k < 100; ++k) {
    truth = moved(truth, kStep, noise, random);
    const auto z = measured_position(truth, kPositionSigma, random);
    single = predict_ctra(single, kStep, noise);
    const double expected = innovation(single, z, expectation(single)).log_likelihood();
    single = update(single, z, expectation(single), ctra::kAngles);
    imm.predict(switching<2>(Eigen::Matrix2d::Constant(0.5), kStep),
                [&](int, const Gaussian<6>& x) { return predict_ctra(x, kStep, noise); });
    EXPECT_NEAR(imm.update(z, expectation), expected, 1e-8);
  }
  EXPECT_TRUE(imm.combined().mean.isApprox(single.mean, 1e-9));
  EXPECT_TRUE(imm.combined().covariance.isApprox(single.covariance, 1e-9));
}

TEST(Imm, ProbabilitiesSumToOneHoweverUnlikelyTheMeasurement) {
  CtraImm imm = start_imm(10);
  for (const double far : {0.0, 10.0, 1e3, 1e6, 1e160}) {
    predict(imm, kStep, kModels, leave_after(5));
    fold(imm, {{far, -far}, 1e-4 * Eigen::Matrix2d::Identity()});
    EXPECT_NEAR(imm.probabilities().sum(), 1, 1e-14) << far;
    EXPECT_GE(imm.probabilities().minCoeff(), 0) << far;
  }
  const auto before = imm.probabilities();
  const double never = -std::numeric_limits<double>::infinity();
  imm.reweigh(CtraImm::Weights::Constant(never));
  EXPECT_EQ(imm.probabilities(), before);
  imm.reweigh({std::nan(""), 0, 0});
  EXPECT_NEAR(imm.probabilities().sum(), 1, 1e-15);
  EXPECT_EQ(imm.probabilities()(0), 0);
}

/// Mean probabilities over the last steps of runs on a target with the given motion.
CtraImm::Weights preferences(double a, double w) {
  CtraImm::Weights sum = CtraImm::Weights::Zero();
  constexpr int kRuns = 50;
  for (int run = 0; run < kRuns; ++run) {
    RandomStream random(52, run);
    CtraVector truth = start_of_ctra(10, a, w).mean;
    CtraImm imm = start_imm(10);
    for (int k = 0; k < 60; ++k) {
      truth = ctra_transition(truth, kStep).mean;
      predict(imm, kStep, kModels, leave_after(5));
      fold(imm, measured_position(truth, kPositionSigma, random));
    }
    sum += imm.probabilities() / kRuns;
  }
  return sum;
}

TEST(Imm, PrefersTheModelThatTheTargetFollows) {
  const auto straight = preferences(0, 0), turning = preferences(0, 0.4),
             braking = preferences(-2.5, 0.4);
  for (const auto& [name, p] :
       {std::pair{"straight", straight}, {"turning", turning}, {"turning_and_braking", braking}}) {
    RecordProperty(name, ::testing::PrintToString(p.transpose()));
  }
  EXPECT_GT(straight(0), std::max(straight(1), straight(2)));
  EXPECT_GT(turning(1), std::max(turning(0), turning(2)));
  EXPECT_GT(braking(2), std::max(braking(0), braking(1)));
}

struct SwitchingScores {
  double imm = 0, straight = 0;
  double imm_error_m = 0, straight_error_m = 0;
};

/// Truth that switches between the models as the filter believes it does.
class SwitchingTarget {
 public:
  SwitchingTarget(double seconds, std::uint64_t run)
      : random_(53, run), pi_(switching<3>(leave_after(seconds), kStep)) {
    Gaussian<6> start = start_of_ctra(12, 0, 0);
    state_ = draw(start, random_);
    enter(0);
  }
  void step() {
    const double u = random_.uniform();
    int next = 0;
    for (double sum = pi_(mode_, 0); u > sum && next < 2; sum += pi_(mode_, next)) ++next;
    if (next != mode_) enter(next);
    CtraNoise noise = kModels[mode_].noise;
    state_ = moved(state_, kStep, noise, random_);
  }
  Gaussian<2> measure() { return measured_position(state_, kPositionSigma, random_); }
  [[nodiscard]] Eigen::Vector4d truth() const { return velocity_of_ctra(state_); }

 private:
  /// What a model lets go starts at its onset, what it holds is zero.
  void enter(int mode) {
    const CtraModel& from = kModels[mode_];
    const bool had_turn = from.kind != CtraKind::kConstantVelocity;
    const bool had_accel = from.kind == CtraKind::kTurnAndAcceleration;
    mode_ = mode;
    const CtraKind kind = kModels[mode].kind;
    double& w = state_(ctra::kYawRate);
    double& a = state_(ctra::kAccel);
    if (kind == CtraKind::kConstantVelocity) {
      w = 0;
    } else if (!had_turn) {
      w = random_.normal(0, from.onset_yaw_rate_rad_per_s);
    }
    if (kind != CtraKind::kTurnAndAcceleration) {
      a = 0;
    } else if (!had_accel) {
      a = random_.normal(0, from.onset_accel_m_per_s2);
    }
  }

  RandomStream random_;
  Eigen::Matrix3d pi_;
  CtraVector state_;
  int mode_ = 0;
};

/// NEES of x, vx, y, vy after 8 s of each run, for the IMM and for its straight model alone.
SwitchingScores score_switching(double seconds, int runs) {
  SwitchingScores scores;
  for (int run = 0; run < runs; ++run) {
    SwitchingTarget target(seconds, run);
    CtraImm imm(start_of_ctra(12, 0, 0), CtraImm::Weights::Unit(0), ctra::kAngles);
    Gaussian<6> straight = imm.belief(0);
    for (int k = 0; k < 100; ++k) {
      target.step();
      const auto z = target.measure();
      predict(imm, kStep, kModels, leave_after(seconds));
      fold(imm, z);
      straight = predict_ctra(straight, kStep, kModels[0]);
      straight = update(straight, z, expect(straight, position_of_ctra()), ctra::kAngles);
    }
    const Gaussian<4> a = velocity_of_ctra(imm.combined()), b = velocity_of_ctra(straight);
    scores.imm += nees(a, target.truth()) / runs;
    scores.straight += nees(b, target.truth()) / runs;
    scores.imm_error_m +=
        Eigen::Vector2d(a.mean(0) - target.truth()(0), a.mean(2) - target.truth()(2))
            .squaredNorm() /
        runs;
    scores.straight_error_m +=
        Eigen::Vector2d(b.mean(0) - target.truth()(0), b.mean(2) - target.truth()(2))
            .squaredNorm() /
        runs;
  }
  return scores;
}

TEST(Imm, NeesLiesInItsBandOnATargetThatSwitchesAsBelieved) {
  constexpr int kRuns = 2000;
  const SwitchingScores s = score_switching(4, kRuns);
  RecordProperty("imm", ::testing::PrintToString(s.imm));
  RecordProperty("straight", ::testing::PrintToString(s.straight));
  RecordProperty("imm_rms_m", ::testing::PrintToString(std::sqrt(s.imm_error_m)));
  RecordProperty("straight_rms_m", ::testing::PrintToString(std::sqrt(s.straight_error_m)));
  const Band band = mean_chi_square_band(kRuns, 4);
  EXPECT_TRUE(band.contains(s.imm)) << s.imm << " not in " << band.low << " .. " << band.high;
  EXPECT_GT(s.straight, 2 * band.high);
}

TEST(Imm, AFlipOfAllModelsTellsTheSameMotion) {
  CtraImm imm = start_imm(10), flipped = imm;
  flipped.transform(flip_heading);
  RandomStream random(54);
  CtraVector truth = start_of_ctra(10, 1, 0.3).mean;
  for (int k = 0; k < 50; ++k) {
    truth = ctra_transition(truth, kStep).mean;
    const auto z = measured_position(truth, kPositionSigma, random);
    for (CtraImm* filter : {&imm, &flipped}) {
      predict(*filter, kStep, kModels, leave_after(5));
      fold(*filter, z);
    }
  }
  const Gaussian<6> a = imm.combined(), b = flip_heading(flipped.combined());
  EXPECT_LT(wrapped<6>(a.mean - b.mean, ctra::kAngles).norm(), 1e-9);
  EXPECT_TRUE(a.covariance.isApprox(b.covariance, 1e-9));
}

}  // namespace
}  // namespace scanfuse::estimate
