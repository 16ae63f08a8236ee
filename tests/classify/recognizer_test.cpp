#include "scanfuse/classify/recognizer.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>

#include "scanfuse/shape/outline.hpp"
#include "shape/flat_world.hpp"

namespace scanfuse::classify {
namespace {

using flat_world::look;
using flat_world::Scanner;

std::vector<Detection> detect(const std::vector<Box2>& boxes, RandomStream& random,
                              const RecognizerOptions& options = {}) {
  const auto shot = look(boxes, Scanner{}, random);
  shape::OutlineExtractor extract;
  Recognizer recognize(options);
  const auto found = recognize(extract(shot.scan, shot.clusters));
  return {found.begin(), found.end()};
}

TEST(Recognizer, CarsAtEveryAspectAreFoundWithTheirCentre) {
  RandomStream random(5);
  for (int k = 0; k < 36; ++k) {
    const Box2 car{{20, 3}, radians(10.0 * k), 4.4, 1.8};
    const auto found = detect({car}, random);
    ASSERT_EQ(found.size(), 1u) << k;
    EXPECT_LT((found[0].box.centre_m - car.centre_m).norm(), 0.5) << k;
    EXPECT_LT(std::abs(wrap_half_pi(found[0].box.heading_rad - car.heading_rad)), 0.1) << k;
    EXPECT_TRUE(found[0].covariance.allFinite());
    EXPECT_GT(found[0].covariance.determinant(), 0);
  }
}

TEST(Recognizer, WallsAndPolesAreNoVehicles) {
  RandomStream random(6);
  EXPECT_TRUE(detect({{{20, 5}, 0.1, 25, 0.3}}, random).empty());
  EXPECT_TRUE(detect({{{15, 5}, 0.1, 0.2, 0.2}}, random).empty());
}

TEST(Recognizer, BushesAreNoVehicles) {
  RandomStream random(7);
  int found = 0;
  for (int run = 0; run < 50; ++run) {
    auto shot = look({{{15, 3}, 0, 1.6, 1.6}}, Scanner{.sigma_range_m = 0.3}, random);
    shot.scan.sigma_range_m = 0.03;
    shape::OutlineExtractor extract;
    Recognizer recognize;
    found += static_cast<int>(recognize(extract(shot.scan, shot.clusters)).size());
  }
  EXPECT_LE(found, 2);
}

TEST(Recognizer, ARearAloneGivesAWholeCarBehindIt) {
  RandomStream random(8);
  const auto found = detect({{{20, 0}, 0, 4.4, 1.8}}, random);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].faces_seen, 1);
  EXPECT_TRUE(found[0].width_seen);
  EXPECT_FALSE(found[0].length_seen);
  EXPECT_NEAR(found[0].box.length_m, 4.4, 1e-9);
  EXPECT_NEAR(found[0].box.centre_m.x(), 20, 0.1);
  EXPECT_NEAR(found[0].visible_middle_m.x(), 17.8, 0.1);
}

TEST(Recognizer, AHalfHiddenRearGrowsBehindWhatHidesIt) {
  RandomStream random(9);
  const Box2 car{{25, 0}, 0, 4.4, 1.8}, post{{10, -0.35}, 0, 0.2, 0.5};
  for (int run = 0; run < 20; ++run) {
    const auto found = detect({car, post}, random);
    ASSERT_EQ(found.size(), 1u);
    EXPECT_TRUE(found[0].right_end_occluded);
    EXPECT_FALSE(found[0].left_end_occluded);
    EXPECT_FALSE(found[0].width_seen);
    EXPECT_NEAR(found[0].box.centre_m.y(), 0, 0.2);
  }
}

TEST(Recognizer, SmallUsersAreUnknownAndOnlyOnRequest) {
  RandomStream random(11);
  const Box2 pedestrian{{10, 1}, 0, 0.5, 0.5};
  EXPECT_TRUE(detect({pedestrian}, random).empty());
  RecognizerOptions options;
  options.keep = Keep::kRoadUsers;
  const auto found = detect({pedestrian}, random, options);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].object_class, ObjectClass::kUnknown);
}

TEST(Recognizer, TheLiteralRulesTakeLinesAndCornersOfCarSize) {
  RandomStream random(12);
  RecognizerOptions options;
  options.method = Method::kLu2018;
  EXPECT_EQ(detect({{{20, 0}, 0, 4.4, 1.8}}, random, options).size(), 1u);
  EXPECT_EQ(detect({{{20, 5}, 0.6, 4.4, 1.8}}, random, options).size(), 1u);
  EXPECT_TRUE(detect({{{20, 5}, 0.1, 25, 0.3}}, random, options).empty());
}

TEST(Recognizer, NothingInGivesNothingOut) {
  Recognizer recognize;
  EXPECT_TRUE(recognize({}).empty());
  const std::vector<Outline> blank(2);
  EXPECT_TRUE(recognize(blank).empty());
}

// Normalised errors of the centre and heading, the extent's own variance added, stay in their band.
TEST(Recognizer, CentresAreAsUncertainAsTheySay) {
  RandomStream random(13);
  double sum = 0;
  int count = 0;
  for (int run = 0; run < 400; ++run) {
    const double bearing = random.uniform(-0.5, 0.5), range = random.uniform(8, 40);
    const Box2 car{Eigen::Vector2d(std::cos(bearing), std::sin(bearing)) * range,
                   random.uniform(-kPi, kPi), random.normal(4.4, 0.4), random.normal(1.8, 0.1)};
    for (const Detection& d : detect({car}, random)) {
      const double turn = wrap_half_pi(d.box.heading_rad - car.heading_rad);
      if (std::abs(turn) > 0.5) continue;
      const Eigen::Vector2d along(std::cos(d.box.heading_rad), std::sin(d.box.heading_rad));
      const Eigen::Vector2d across(-along.y(), along.x());
      Eigen::Matrix3d covariance = d.covariance;
      covariance.topLeftCorner<2, 2>() += d.var_length_m2 / 4 * along * along.transpose() +
                                          d.var_width_m2 / 4 * across * across.transpose();
      const Eigen::Vector2d e = d.box.centre_m - car.centre_m;
      const Eigen::Vector3d error(e.x(), e.y(), turn);
      sum += error.dot(covariance.ldlt().solve(error));
      ++count;
    }
  }
  EXPECT_GT(count, 380);
  EXPECT_GT(sum / count, 1.0);
  EXPECT_LT(sum / count, 4.5);
}

}  // namespace
}  // namespace scanfuse::classify
