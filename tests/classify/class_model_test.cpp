#include "scanfuse/classify/class_model.hpp"

#include <gtest/gtest.h>

#include "scanfuse/classify/fit_softmax.hpp"
#include "scanfuse/core/random.hpp"

namespace scanfuse::classify {
namespace {

Outline line_of(double length_m, double var_range_m2) {
  Outline outline;
  outline.points = 8;
  outline.box = {{10, 0}, kPi / 2, length_m, 0.1};
  outline.lines.push_back({{10, -length_m / 2}, {10, length_m / 2}, 0.01, 8});
  outline.var_range_m2 = var_range_m2;
  return outline;
}

TEST(Features, AreFiniteForBlankAndHugeOutlines) {
  std::vector<Outline> outlines(2);
  outlines[1] = line_of(1e6, 1e9);
  for (std::size_t i = 0; i < 2; ++i) {
    for (const double x : features_of(outlines, i, 0)) EXPECT_TRUE(std::isfinite(x));
  }
}

TEST(Features, ScaleMakesAModelLookLikeTheRealThing) {
  const std::vector<Outline> real{line_of(1.8, 0.01)};
  std::vector<Outline> model{line_of(0.18, 0.0001)};
  model[0].box.centre_m = {1, 0};
  model[0].box.width_m = 0.01;
  const auto a = features_of(real, 0, 1), b = features_of(model, 0, 1, 0.1);
  EXPECT_NEAR(a[kLogLength], b[kLogLength], 1e-9);
  EXPECT_NEAR(a[kLogRange], b[kLogRange], 1e-9);
  EXPECT_NEAR(a[kLogRangeSpread], b[kLogRangeSpread], 1e-9);
}

// One layer says nothing of how upright a thing is: neither "upright" nor "leaning".
TEST(Features, OneLayerHasAUsualLayerDepthAndSaysThatItIsUnknown) {
  std::vector<Outline> outlines{line_of(0.5, 0.01), line_of(0.5, 0.01)};
  outlines[1].layered_share = 1;
  outlines[1].layer_depth_m = 0.05;
  const auto one = features_of(outlines, 0, 0), four = features_of(outlines, 1, 0);
  EXPECT_EQ(one[kLogLayerDepth], four[kLogLayerDepth]);
  EXPECT_EQ(one[kLayeredShare], 0);
  EXPECT_EQ(four[kLayeredShare], 1);
}

TEST(FitSoftmax, RecoversTheProbabilitiesThatLabelsWereDrawnWith) {
  RandomStream random(3);
  const int n = 20000;
  Eigen::MatrixXf terms(n, 2);
  std::vector<int> labels;
  for (int i = 0; i < n; ++i) {
    const double x = random.normal();
    terms.row(i) << 1.0F, static_cast<float>(x);
    labels.push_back(random.chance(1 / (1 + std::exp(-(0.5 + 2 * x)))) ? 1 : 0);
  }
  const auto fit = fit_softmax(terms, labels, {}, 2, {1e-6, 300, 1e-9});
  EXPECT_NEAR(fit.weights(1, 0) - fit.weights(0, 0), 0.5, 0.1);
  EXPECT_NEAR(fit.weights(1, 1) - fit.weights(0, 1), 2.0, 0.1);
}

TEST(FitTemperature, UndoesLogitsThatAreTwiceTooLarge) {
  RandomStream random(4);
  Eigen::MatrixXd logits(20000, 2);
  std::vector<int> labels;
  for (int i = 0; i < logits.rows(); ++i) {
    const double z = random.normal();
    labels.push_back(random.chance(1 / (1 + std::exp(-z))) ? 1 : 0);
    logits.row(i) << 0, 2 * z;
  }
  EXPECT_NEAR(fit_temperature(logits, labels), 2, 0.15);
  EXPECT_EQ(fit_temperature(Eigen::MatrixXd(0, 2), {}), 1);
}

TEST(GuoIntervals, OfSeveralMatchesTheNearestMiddleWins) {
  Intervals intervals;
  intervals[0].l = {1.4, 5};
  intervals[1].l = {0.2, 0.8};
  intervals[2].l = {0.4, 2.0};
  for (auto& of : intervals) of.var_r_of_one = {0, 0.1};
  EXPECT_EQ(class_by_intervals(line_of(0.5, 0.05), intervals), ObjectClass::kPedestrian);
  EXPECT_EQ(class_by_intervals(line_of(1.3, 0.05), intervals), ObjectClass::kCyclist);
  EXPECT_EQ(class_by_intervals(line_of(3.0, 0.05), intervals), ObjectClass::kVehicle);
  EXPECT_FALSE(class_by_intervals(line_of(8.0, 0.05), intervals));
  EXPECT_FALSE(class_by_intervals(line_of(0.5, 0.5), intervals));
  EXPECT_FALSE(class_by_intervals(Outline{}, intervals));
}

}  // namespace
}  // namespace scanfuse::classify
