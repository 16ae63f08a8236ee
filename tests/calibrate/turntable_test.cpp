#include "scanfuse/calibrate/turntable.hpp"

#include <algorithm>

#include "calibrate/rig_scene.hpp"

namespace scanfuse::calibrate {
namespace {

using testing::calibrate_by;
using testing::kNoNoise;
using testing::points_apart_m;
using testing::simulate_small;
using testing::small_world;
using testing::TurntableNoise;
using testing::TurntableWorldOptions;

bool warns(const TurntableCalibration& result, std::string_view of) {
  return std::any_of(result.warnings.begin(), result.warnings.end(),
                     [&](const std::string& w) { return w.find(of) != std::string::npos; });
}

TEST(CalibrateTurntable, EveryMethodIsExactWithoutNoise) {
  auto options = small_world();
  options.beam_zero_rad = 0.4;
  const auto data = simulate::simulate_turntable_features(options, kNoNoise, 1);
  for (const auto& [name, method] : choices(TurntableMethod{})) {
    const auto result = calibrate_by(data.features, method);
    ASSERT_TRUE(result) << name << ": " << result.error().message;
    EXPECT_EQ(result->positions_used, 22) << name;
    EXPECT_LT(points_apart_m(data.world.rig, result->rig), 1e-5) << name;
    EXPECT_LT(result->table1.centre_mm.max, 0.01) << name;
  }
}

// The figures that the joint method promises, on seeds of its own, at a quarter of the data.
TEST(CalibrateTurntable, JointErrorsAreThoseThatItsCovarianceTells) {
  double nees = 0, covered = 0, line_chi2 = 0;
  const int runs = 12;
  for (std::uint64_t seed = 201; seed < 201 + runs; ++seed) {
    const auto data = simulate_small({}, seed);
    const auto result = calibrate_by(data.features, TurntableMethod::kJoint);
    ASSERT_TRUE(result) << result.error().message;
    EXPECT_EQ(result->positions_used, 22);
    EXPECT_NEAR(result->chi2_per_dof, 1, 0.05);
    line_chi2 += result->line_chi2_per_dof / runs;
    const Eigen::Matrix<double, 10, 1> delta = difference(data.world.rig, result->rig).head<10>();
    const Eigen::Matrix<double, 10, 10> C = result->rig.covariance.topLeftCorner<10, 10>();
    nees += delta.dot(C.inverse() * delta) / (10 * runs);
    for (int k = 0; k < 10; ++k) covered += std::abs(delta[k]) < 1.96 * std::sqrt(C(k, k));
  }
  EXPECT_NEAR(nees, 1, 0.45);  // 3.5 standard deviations of 120 / chi-square
  EXPECT_GT(covered / (10 * runs), 0.88);
  EXPECT_NEAR(line_chi2, 1, 0.15);
}

TEST(CalibrateTurntable, JointIsNearerThanTheClosedFormThanThePaper) {
  double error[3] = {};
  for (std::uint64_t seed = 301; seed < 307; ++seed) {
    const auto data = simulate_small({}, seed);
    for (const auto& [name, method] : choices(TurntableMethod{})) {
      const auto result = calibrate_by(data.features, method);
      ASSERT_TRUE(result) << name << ": " << result.error().message;
      // The axis alone may come out nearer by the paper's way; what is measured does not.
      error[static_cast<int>(method)] += points_apart_m(data.world.rig, result->rig);
    }
  }
  EXPECT_LT(error[1], error[0]);
  EXPECT_LT(error[2], error[1]);
}

TEST(CalibrateTurntable, MountingsThatDefeatThePaperAreOrdinary) {
  const auto with = [](auto&& change) {
    TurntableWorldOptions options = small_world();
    change(options);
    return options;
  };
  const std::pair<const char*, TurntableWorldOptions> mountings[] = {
      {"radius 0", with([](auto& o) { o.radius_m = 0; })},
      {"reversed", with([](auto& o) { o.reversed = true; })},
      {"x along the axis", with([](auto& o) { o.beam_zero_rad = kPi / 2; })},
      {"axis along the normal", with([](auto& o) { o.axis_tilt_rad = kPi / 2; })}};
  for (const auto& [name, options] : mountings) {
    const auto data = simulate::simulate_turntable_features(options, {}, 5);
    const auto result = calibrate_by(data.features, TurntableMethod::kJoint);
    ASSERT_TRUE(result) << name << ": " << result.error().message;
    EXPECT_TRUE(result->rig.covariance.allFinite()) << name;
    EXPECT_LT(points_apart_m(data.world.rig, result->rig), 2e-3) << name;
    const auto paper = calibrate_by(data.features, TurntableMethod::kLiu2023);
    if (!paper) continue;
    EXPECT_TRUE(paper->rig.axis_direction.allFinite()) << name;
  }
}

TEST(CalibrateTurntable, LeavesOutBadFramesAndNamesThem) {
  auto data = simulate_small();
  auto& positions = data.features.positions;
  positions[2].stripe_px[0].clear();
  for (auto& p : positions[5].stripe_px[1]) p.x() += 4;  // another frame's stripe
  for (auto& r : positions[9].scan) r.range_m += 0.02;   // another frame's scan
  positions[12].turntable_rad = std::numeric_limits<double>::quiet_NaN();
  std::swap(positions[14], positions[20]);  // unsorted: no harm
  for (auto& r : positions[16].scan) r.range_m = 0;
  const auto result = calibrate_by(data.features, TurntableMethod::kJoint);
  ASSERT_TRUE(result) << result.error().message;
  EXPECT_EQ(result->positions_used, 17);
  for (const std::size_t bad : {2, 5, 9, 12, 16}) {
    EXPECT_FALSE(result->positions[bad].used) << bad;
    EXPECT_FALSE(result->positions[bad].reason.empty()) << bad;
  }
  EXPECT_EQ(result->diagnostics.count("position left out"), 5);
  EXPECT_LT(points_apart_m(data.world.rig, result->rig), 1e-3);
}

TEST(CalibrateTurntable, FindsARangeBiasByItself) {
  TurntableNoise noise;
  noise.range_bias_m = 0.01;
  const auto data = simulate::simulate_turntable_features(small_world(), noise, 4);
  const auto result = calibrate_by(data.features, TurntableMethod::kJoint);
  ASSERT_TRUE(result);
  const double sigma = std::sqrt(result->rig.covariance(10, 10));
  EXPECT_GT(sigma, 0);
  EXPECT_NEAR(result->rig.range_bias_m, 0.01, 4 * sigma);
  EXPECT_TRUE(warns(*result, "ranges are"));
}

TEST(CalibrateTurntable, FindsTheDifferenceOfBlackAndWhiteSquares) {
  TurntableNoise noise;
  noise.square_bias_m = 0.004;
  const auto data = simulate::simulate_turntable_features(small_world(), noise, 4);
  const auto result = calibrate_by(data.features, TurntableMethod::kJoint);
  ASSERT_TRUE(result);
  EXPECT_GT(result->square_bias_sigma_m, 0);
  EXPECT_NEAR(result->square_bias_m, 0.004, 4 * result->square_bias_sigma_m);
}

TEST(CalibrateTurntable, EstimatesTheAngleScaleWhereAsked) {
  TurntableNoise noise;
  noise.angle_scale = 1.01;
  const auto data = simulate::simulate_turntable_features(small_world(), noise, 4);
  const auto without = calibrate_by(data.features, TurntableMethod::kJoint);
  ASSERT_TRUE(without);
  EXPECT_TRUE(warns(*without, "estimate angle_scale"));
  TurntableOptions options;
  options.angle_scale = Systematic::kOn;
  const auto result = calibrate_turntable(data.features, options);
  ASSERT_TRUE(result);
  EXPECT_NEAR(result->rig.angle_scale, 1.01, 4 * std::sqrt(result->rig.covariance(11, 11)));
}

// Errors that a line's points share make a covariance from the points' noise a lie.
TEST(CalibrateTurntable, WidensItsCovarianceWhereLinesShareErrors) {
  TurntableNoise noise;
  noise.stripe_line_px = 0.2;
  noise.range_line_m = 0.0003;
  const auto data = simulate_small(noise, 11);
  const auto honest = calibrate_by(data.features, TurntableMethod::kJoint);
  TurntableOptions blind;
  blind.line_effects = false;
  const auto naive = calibrate_turntable(data.features, blind);
  ASSERT_TRUE(honest) << honest.error().message;
  ASSERT_TRUE(naive) << naive.error().message;
  EXPECT_GT(honest->line_chi2_per_dof, 3);
  EXPECT_TRUE(warns(*honest, "errors that all points of a line share"));
  EXPECT_GT(honest->rig.covariance(0, 0), 4 * naive->rig.covariance(0, 0));
}

TEST(CalibrateTurntable, NamesWeakDirectionsAndRemedies) {
  auto options = small_world();
  options.step_rad = radians(0.2);  // an arc of 4.2 degrees
  const auto data = simulate::simulate_turntable_features(options, {}, 3);
  const auto result = calibrate_by(data.features, TurntableMethod::kJoint);
  ASSERT_TRUE(result);
  EXPECT_TRUE(warns(*result, "weak: the axis's place along the arc's"));
  EXPECT_TRUE(warns(*result, "turn further than 4.2 degrees (12 or more)"));
}

TEST(CalibrateTurntable, RefusesWhatCannotBeCalibrated) {
  const auto good = simulate_small();
  const auto message = [&](auto&& spoil) {
    TurntableFeatures features = good.features;
    spoil(features);
    const auto result = calibrate_turntable(features);
    return result ? std::string("accepted") : result.error().message;
  };
  EXPECT_NE(message([](auto& f) { f.positions.resize(2); }).find("3 are needed"),
            std::string::npos);
  EXPECT_NE(message([](auto& f) { f.positions.clear(); }).find("no positions were given"),
            std::string::npos);
  EXPECT_NE(message([](auto& f) { f.corners_px[1].clear(); }).find("second board: 0 corners"),
            std::string::npos);
  EXPECT_NE(message([](auto& f) {
              for (auto& p : f.positions) p.turntable_rad = degrees(p.turntable_rad);
            }).find("in degrees"),
            std::string::npos);
  EXPECT_NE(message([](auto& f) { f.camera.fx_px = 0; }).find("focal"), std::string::npos);
  EXPECT_NE(message([](auto& f) {
              for (auto& p : f.positions) p.turntable_rad = 0.1;
            }).find("do not differ"),
            std::string::npos);
}

TEST(CalibrateTurntable, GivesTheSameBytesAgain) {
  const auto data = simulate_small();
  const auto one = calibrate_by(data.features, TurntableMethod::kJoint);
  const auto two = calibrate_by(data.features, TurntableMethod::kJoint);
  ASSERT_TRUE(one && two);
  EXPECT_EQ(one->rig.axis_point_m, two->rig.axis_point_m);
  EXPECT_EQ(one->rig.covariance, two->rig.covariance);
  EXPECT_EQ(one->covariance_jackknife, two->covariance_jackknife);
}

}  // namespace
}  // namespace scanfuse::calibrate
