#include "scanfuse/triangulate/costs.hpp"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>

#include "triangulate/scene_of_three.hpp"

namespace scanfuse::triangulate {
namespace {

using testing::bearings_to;
using testing::lines_of;
using testing::scene_of_three;

const Eigen::Vector3d kTarget(20e3, 20e3, 8e3);

PassiveScene wide_scene(double sigma_rad) {
  PassiveScene scene = scene_of_three({0, 0, 0}, sigma_rad);
  scene.volume_m = PassiveScene::Volume{{{0, 40e3}, {0, 40e3}, {0, 11e3}}};
  scene.expected_targets = 20;
  for (auto& sensor : scene.sensors) {
    sensor.detection_probability = 0.9;
    sensor.clutter_density = 0.4;
  }
  return scene;
}

/// ln of the evidence against clutter by importance sampling around the most likely place.
double sampled_evidence(const std::vector<LineOfSight>& lines, const Location& at,
                        const ScenePrior& prior, const PassiveScene& scene) {
  const Eigen::LLT<Eigen::Matrix3d> root(at.covariance_m2);
  constexpr int kSamples = 200000;
  RandomStream random(11);
  double sum = 0;
  for (int k = 0; k < kSamples; ++k) {
    Eigen::Vector3d z;
    double weight = 0;  // ln of likelihood over proposal
    for (int i = 0; i < 3; ++i) z[i] = random.normal();
    weight += z.squaredNorm() / 2 + 1.5 * std::log(2 * kPi) +
              std::log(at.covariance_m2.determinant()) / 2;
    const Eigen::Vector3d x = at.position_m + root.matrixL() * z;
    bool inside = true;
    for (int i = 0; i < 3; ++i) {
      const auto& [low, high] = (*scene.volume_m)[static_cast<std::size_t>(i)];
      inside = inside && x[i] >= low && x[i] <= high;
    }
    if (!inside) continue;
    for (const LineOfSight& line : lines) {
      const auto seen = sight(line, x);
      weight -= line.log_spread() + (std::pow(seen->offset_rad.x() / line.sigma_left_rad, 2) +
                                     std::pow(seen->offset_rad.y() / line.sigma_up_rad, 2)) /
                                        2;
    }
    sum += std::exp(weight) / kSamples;
  }
  double w = prior.log_intensity + std::log(sum);
  for (const LineOfSight& line : lines) {
    const auto& sensor = prior.sensors[static_cast<std::size_t>(line.sensor)];
    w += sensor.log_detected - sensor.log_clutter;
  }
  return w;
}

TEST(EvidenceCost, AgreesWithImportanceSampling) {
  for (const double sigma : {0.005, 0.01}) {
    const PassiveScene scene = wide_scene(sigma);
    const auto prior = scene_prior(scene, {}).prior;
    for (const std::uint64_t seed : {1U, 2U, 3U}) {
      const auto lines = lines_of(scene, bearings_to(scene, kTarget, 1, seed));
      const auto at = most_likely(lines);
      ASSERT_TRUE(at);
      EXPECT_NEAR(EvidenceCost{}({lines, *at}, scene, prior),
                  sampled_evidence(lines, *at, prior, scene), 0.01);
    }
  }
}

TEST(EvidenceCost, ChargesAMissOnlyToASensorThatLooksThere) {
  PassiveScene scene = wide_scene(0.005);
  const auto prior = scene_prior(scene, {}).prior;
  auto lines = lines_of(scene, bearings_to(scene, kTarget));
  lines.pop_back();  // the third sensor saw nothing
  const auto at = most_likely(lines);
  ASSERT_TRUE(at);
  const double charged = EvidenceCost{}({lines, *at}, scene, prior);
  scene.sensors[2].field_of_view_azimuth_rad = 0.01;
  EXPECT_NEAR(EvidenceCost{}({lines, *at}, scene, prior) - charged, -std::log(0.1), 1e-9);
}

TEST(EvidenceCost, FallsOutsideTheVolume) {
  const PassiveScene scene = wide_scene(0.005);
  const auto prior = scene_prior(scene, {}).prior;
  const auto weigh = [&](const Eigen::Vector3d& target) {
    const auto lines = lines_of(scene, bearings_to(scene, target));
    return EvidenceCost{}({lines, *most_likely(lines)}, scene, prior);
  };
  EXPECT_GT(weigh(kTarget), 0);
  EXPECT_LT(weigh({20e3, 20e3, 30e3}), 0);
}

TEST(Costs, PreferTheTruePairingToASwappedOne) {
  const PassiveScene scene = wide_scene(0.002);
  const auto prior = scene_prior(scene, {}).prior;
  const auto one = bearings_to(scene, kTarget, 1, 5);
  const auto other = bearings_to(scene, kTarget + Eigen::Vector3d(3e3, 0, 0), 1, 6);
  auto swapped = one;
  swapped[0] = other[0];
  for (const CostMethod method :
       {CostMethod::kEvidence, CostMethod::kClassic, CostMethod::kRenyi, CostMethod::kRenyiLiteral,
        CostMethod::kKullbackLeibler, CostMethod::kLeaveOneOut}) {
    const auto weigh = [&](const std::vector<Bearing>& bearings) {
      const auto lines = lines_of(scene, bearings);
      const auto at = most_likely(lines);
      return std::visit([&](const auto& cost) { return cost({lines, *at}, scene, prior); },
                        make_cost(method));
    };
    EXPECT_GT(weigh(one), weigh(swapped)) << static_cast<int>(method);
    EXPECT_TRUE(std::isfinite(weigh(swapped)));
  }
}

TEST(ScenePrior, EstimatesVolumeAndNumberFromTheBearings) {
  PassiveScene scene = scene_of_three({0, 0, 0}, 0.001);
  BearingScan scan;
  RandomStream random(3);
  for (int t = 0; t < 30; ++t) {
    const Eigen::Vector3d target(random.uniform(10e3, 30e3), random.uniform(10e3, 30e3),
                                 random.uniform(2e3, 8e3));
    for (Bearing b : bearings_to(scene, target, 1, static_cast<std::uint64_t>(t))) {
      scan.bearings.push_back(b);
    }
  }
  for (auto& sensor : scene.sensors) sensor.detection_probability = 1;
  const auto estimated = scene_prior(scene, scan);
  EXPECT_TRUE(estimated.volume_estimated && estimated.targets_estimated);
  const auto& v = estimated.prior.volume_m;
  EXPECT_LT(v[0][0], 12e3);
  EXPECT_GT(v[0][1], 28e3);
  double volume = 1;
  for (const auto& [low, high] : v) volume *= high - low;
  EXPECT_NEAR(std::exp(estimated.prior.log_intensity) * volume, 30, 1e-6);
}

}  // namespace
}  // namespace scanfuse::triangulate
